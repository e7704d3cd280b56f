#include "command_runner.hpp"
#include "documented_keys.hpp"
#include "samples.hpp"

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;

class Info : public CommandTest {};

TEST_F(Info, KeysAreAsDocumented) {
    write("a", samples::smallest_sphere);
    expect_as_documented("info FILE", run_json({"info", "a"}));
    expect_as_documented("info", run_json({"info"}));
}

TEST_F(Info, CodesAreThoseOfThePage) {
    std::vector<DocumentedCode> told;
    const Json about = run_json({"info"});
    for (const Json& code : about["codes"]) {
        told.push_back({code["code"], code["name"], code["description"]});
    }
    const std::vector<DocumentedCode> documented = documented_codes();
    EXPECT_GT(documented.size(), 20U);
    ASSERT_EQ(told.size(), documented.size());
    for (std::size_t i = 0; i < told.size(); ++i) {
        EXPECT_EQ(told[i], documented[i])
            << told[i].code << " " << told[i].name << ": " << told[i].meaning;
    }
}

TEST_F(Info, DescribesASurface) {
    run_json({"make", "double-wheel", "--vertices", "8", "-o", "wheel"});
    const Json wheel = run_json({"info", "wheel"});
    EXPECT_EQ(wheel["vertices_by_degree"], Json({{"4", 6}, {"6", 2}}));
    EXPECT_EQ(wheel["flippable_edges"], 18);
    run_json({"make", "book", "--vertices", "4", "-o", "book"});
    // At a vertex of degree 2 both edges have the same two opposite corners.
    const Json book = run_json({"info", "book"});
    EXPECT_EQ(book["vertices_by_degree"], Json({{"2", 2}, {"4", 2}}));
    EXPECT_EQ(book["flippable_edges"], 2);
    EXPECT_THAT(run({"info", "book"}).out, HasSubstr("6 edges (2 flippable)"));
}

TEST_F(Info, RefusesWhatIsNoSurfaceAndGoesOn) {
    write("open.off", samples::off(3, {{0, 1, 2}}));
    write("a", samples::smallest_sphere);
    expect_unusable({"info", "open.off"}, {"open.off:6: face 0, side 0", "tightflip check"});
    const Outcome both = run({"info", "--json", "open.off", "a"});
    EXPECT_EQ(both.exit_code, 2);
    const auto objects = both.objects();
    ASSERT_EQ(objects.size(), 2U);
    EXPECT_TRUE(objects[0].contains("error"));
    EXPECT_EQ(objects[1]["vertices"], 3);
}

TEST_F(Info, WithoutAFileListsKindsAndCodesInWords) {
    const Outcome outcome = run({"info"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("tetrahedron"));
    EXPECT_THAT(outcome.out, HasSubstr("602 vertex_with_several_fans"));
}

}  // namespace
}  // namespace tightflip::tools
