#include "targets/certificate.hpp"

#include "targets.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using kernel::CertificateFault;

TEST(CertificateInput, IsAStartAndFiveBytesAStep) {
    // A tetrahedron; flip 3 on the end and in the log; origin 1 of the log's start becomes 6.
    const InputBytes input{1, 0, 0, 0, 0, 0, 0, 3, 0, 0, 6, 2, 1, 0, 7};
    const CertificateCase certificate = decode_certificate(input);
    EXPECT_EQ(certificate.log.flips, (std::vector<kernel::Edge>{{3}}));
    EXPECT_NE(certificate.from, certificate.to);
    EXPECT_EQ(certificate.log.start.records.at(1).origin.id, 6);
    EXPECT_EQ(certificate.from.records.at(1).origin.id, 1);
}

TEST(CertificateInput, HasAtMostSoManySteps) {
    InputBytes input{1, 0, 0, 0, 0};
    input.resize(1000);  // step 0: an honest flip of edge 0
    EXPECT_EQ(decode_certificate(input).log.flips.size(), most_certificate_steps);
}

TEST(CertificateSeeds, ShowEveryFaultThatCanBe) {
    std::set<CertificateFault> faults;
    for (const Seed& seed : certificate_target.seeds())
        faults.insert(expected_verdict(decode_certificate(seed.bytes)).fault);
    for (const CertificateFault fault :
         {CertificateFault::none, CertificateFault::from_is_no_surface,
          CertificateFault::to_is_no_surface, CertificateFault::ends_differ,
          CertificateFault::log_starts_elsewhere, CertificateFault::no_such_edge,
          CertificateFault::flip_not_defined, CertificateFault::log_ends_elsewhere})
        EXPECT_TRUE(faults.contains(fault)) << name(fault);
}

TEST(CertificateSeeds, ThatAreHonestAreExpectedToHold) {
    int honest = 0;
    for (const Seed& seed : certificate_target.seeds()) {
        if (seed.name.find("_honest") == std::string::npos) continue;
        const auto verdict = expected_verdict(decode_certificate(seed.bytes));
        EXPECT_TRUE(verdict) << seed.name << ": " << name(verdict.fault);
        ++honest;
    }
    EXPECT_GE(honest, 20);
}

}  // namespace
}  // namespace tightflip::fuzz
