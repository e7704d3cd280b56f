#include <tightflip/properties/finding.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

TEST(Finding, IsDescribedByStepCodeNameAndPlaceOnOneLine) {
    const Finding finding{12,
                          {.code = ViolationCode::vertex_with_several_fans,
                           .kind = kernel::PlaceKind::vertex,
                           .place = 34}};
    const std::string line = describe(finding);
    for (const char* part : {"12", "602", "vertex_with_several_fans", "vertex 34"}) {
        EXPECT_THAT(line, ::testing::HasSubstr(part));
    }
    EXPECT_THAT(line, ::testing::Not(::testing::HasSubstr("\n")));
}

}  // namespace
}  // namespace tightflip::properties
