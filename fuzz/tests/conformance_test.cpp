#include "targets/conformance.hpp"

#include "kernels.hpp"
#include "targets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using properties::KernelClass;

TEST(ConformanceInput, IsAStartLawsAndFlips) {
    const ConformanceCase script = decode_conformance(InputBytes{1, 0, 0, 0, 0, 1, 3, 0, 4, 1});
    EXPECT_TRUE(script.laws);
    EXPECT_EQ(script.flips.picks, (std::vector<std::uint32_t>{3, 260}));
    EXPECT_EQ(script.flips.kind, properties::find_start_kind("tetrahedron"));
    EXPECT_FALSE(decode_conformance({}).laws);
}

TEST(Conformance, ObjectsToABrokenKernel) {
    const std::vector<JudgedKernel> kernels{{properties::broken_kernel(), {}}};
    int objections = 0;
    for (const Seed& seed : conformance_target.seeds())
        objections +=
            conformance_objection(decode_conformance(seed.bytes), kernels).empty() ? 0 : 1;
    EXPECT_GT(objections, 0);
}

TEST(Conformance, ObjectsToWhatIsNotKnownOfAKernel) {
    const std::vector<JudgedKernel> kernels{
        {properties::cgal_surface_mesh(KernelClass::simple), {}}};
    const ConformanceCase script = decode_conformance(InputBytes{1, 0, 0, 0, 0, 0, 3, 0});
    EXPECT_THAT(
        conformance_objection(script, kernels),
        ::testing::StartsWith("invalid_flip_allowed: CGAL::Surface_mesh, judged as simple"));
    EXPECT_EQ(conformance_objection(script, judged_kernels()), "");
}

TEST(Conformance, KnowsNothingThatItsSeedsDoNotShow) {
    for (const auto& [kernel, known] : judged_kernels()) {
        for (const properties::KernelCode code : known) {
            std::vector<properties::KernelCode> others;
            std::ranges::copy_if(known, std::back_inserter(others),
                                 [&](auto other) { return other != code; });
            const std::vector<JudgedKernel> without{{kernel, others}};
            bool shown = false;
            for (const Seed& seed : conformance_target.seeds())
                shown |= !conformance_objection(decode_conformance(seed.bytes), without).empty();
            EXPECT_TRUE(shown) << kernel.name << ": " << name(code);
        }
    }
}

}  // namespace
}  // namespace tightflip::fuzz
