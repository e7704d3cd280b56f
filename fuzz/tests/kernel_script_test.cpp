#include "kernel_script.hpp"

// The mesh of the guide, which then allows flips to parallel edges.
#define MY_MESH_FORGETS_PARALLEL_EDGES
#include "../../docs/examples/conformance/my_kernel.hpp"

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using properties::KernelCode;
using properties::MyKernel;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const Target forgetful = kernel_target<MyKernel>("forgetful");

InputBytes seed_called(std::string_view name) {
    const std::vector<Seed> seeds = kernel_script_seeds();
    return std::ranges::find(seeds, name, &Seed::name)->bytes;
}

TEST(KernelScript, IsAStartLawsAndFlips) {
    const KernelScript script = decode_kernel_script(InputBytes{1, 0, 0, 0, 0, 1, 3, 0, 4, 1});
    EXPECT_TRUE(script.laws);
    EXPECT_EQ(script.flips.picks, (std::vector<std::uint32_t>{3, 260}));
    EXPECT_EQ(script.flips.kind, properties::find_start_kind("tetrahedron"));
    EXPECT_FALSE(decode_kernel_script({}).laws);
}

TEST(KernelScript, IsShownInWords) {
    std::ostringstream words;
    show_kernel_script(words, InputBytes{1, 0, 0, 0, 0, 1, 3, 0});
    EXPECT_THAT(words.str(), StartsWith("tetrahedron, V = 4, genus 0, seed 0, E = 6; flips 3; each "
                                        "flip undone and redone\n"));
    EXPECT_THAT(words.str(), HasSubstr("flip 1: edge 3 joins "));
}

TEST(KernelTarget, ObjectsToWhatAKernelBreaksAndNamesTheStart) {
    EXPECT_EQ(forgetful.name, "forgetful");
    EXPECT_THAT(objection(forgetful, seed_called("tetrahedron_3_0")),
                StartsWith("invalid_flip_allowed: my mesh, judged as simple: "
                           "701 invalid_flip_allowed, tetrahedron V=4, step 1: "));
    EXPECT_THAT(objection(forgetful, seed_called("simple")),
                HasSubstr("701 invalid_flip_allowed, simple V=12 genus 1, step "));
}

TEST(KernelTarget, PassesOverWhatIsKnown) {
    const Target known = kernel_target<MyKernel, KernelCode::invalid_flip_allowed>("known");
    for (const Seed& seed : known.seeds())
        EXPECT_EQ(objection(known, seed.bytes), "") << seed.name;
}

TEST(KernelTarget, AsksNoKernelForASurfaceThatItCannotHold) {
    EXPECT_EQ(objection(forgetful, seed_called("book")), "");
}

}  // namespace
}  // namespace tightflip::fuzz
