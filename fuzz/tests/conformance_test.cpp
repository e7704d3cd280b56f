#include "targets/conformance.hpp"

#include "kernels.hpp"
#include "targets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using properties::KernelClass;

TEST(Conformance, ObjectsToABrokenKernel) {
    const std::vector<JudgedKernel> kernels{{properties::broken_kernel(), {}}};
    int objections = 0;
    for (const Seed& seed : conformance_target.seeds())
        objections += kernel_objection(decode_kernel_script(seed.bytes), kernels).empty() ? 0 : 1;
    EXPECT_GT(objections, 0);
}

TEST(Conformance, ObjectsToWhatIsNotKnownOfAKernel) {
    const std::vector<JudgedKernel> kernels{
        {properties::cgal_surface_mesh(KernelClass::simple), {}}};
    const KernelScript script = decode_kernel_script(InputBytes{1, 0, 0, 0, 0, 0, 3, 0});
    EXPECT_THAT(
        kernel_objection(script, kernels),
        ::testing::StartsWith("invalid_flip_allowed: CGAL::Surface_mesh, judged as simple"));
    EXPECT_EQ(kernel_objection(script, judged_kernels()), "");
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
                shown |= !kernel_objection(decode_kernel_script(seed.bytes), without).empty();
            EXPECT_TRUE(shown) << kernel.name << ": " << name(code);
        }
    }
}

}  // namespace
}  // namespace tightflip::fuzz
