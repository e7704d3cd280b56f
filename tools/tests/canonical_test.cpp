#include "command_runner.hpp"
#include "documented_keys.hpp"
#include "samples.hpp"

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;

class Canonical : public CommandTest {};

TEST_F(Canonical, KeysAreAsDocumented) {
    write("a", samples::smallest_sphere);
    expect_as_documented("canonical", run_json({"canonical", "a"}));
    expect_as_documented("canonical", run_json({"canonical", "a", "--labelled", "--mirror"}));
}

TEST_F(Canonical, SpellsTheCodeThatThePageDescribes) {
    write("a", samples::smallest_sphere);
    const Json plain = run_json({"canonical", "a"});
    EXPECT_EQ(plain["file"], "a");
    EXPECT_EQ(plain["vertices"], 3);
    EXPECT_EQ(plain["genus"], 0);
    EXPECT_EQ(plain["labelled"], false);
    EXPECT_EQ(plain["mirror"], false);
    EXPECT_EQ(plain["automorphisms"], 6);
    EXPECT_EQ(plain["code"], Json({0, 5, 4}));
    const Json mirror = run_json({"canonical", "a", "--mirror"});
    EXPECT_EQ(mirror["automorphisms"], 12);
    EXPECT_EQ(mirror["mirror"], true);
    const Json labelled = run_json({"canonical", "a", "--labelled"});
    EXPECT_EQ(labelled["labelled"], true);
    EXPECT_EQ(labelled["automorphisms"], 1);
    EXPECT_EQ(labelled["code"], Json({0, 1, 2, 0, 2, 5, 4}));
    EXPECT_NE(plain["digest"], mirror["digest"]);
}

TEST_F(Canonical, PrintsDigestAndSymmetries) {
    write("tetrahedron.off", samples::off(4, samples::tetrahedron));
    run_json({"make", "double-wheel", "--vertices", "6", "-o", "octahedron"});
    const Outcome outcome = run({"canonical", "tetrahedron.off", "octahedron", "--mirror"});
    EXPECT_EQ(outcome.exit_code, 0);
    const std::string digest = run_json({"canonical", "octahedron", "--mirror"})["digest"];
    EXPECT_EQ(digest.size(), 16U);
    EXPECT_THAT(outcome.out, HasSubstr("(4 vertices, genus 0, 24 automorphisms)"));
    EXPECT_THAT(outcome.out,
                HasSubstr("octahedron: " + digest + " (6 vertices, genus 0, 48 automorphisms)"));
}

TEST_F(Canonical, CodesOfTheSameSurfaceAreEqual) {
    write("a.off", samples::off(4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
    write("b.off", samples::off(4, {{3, 2, 0}, {3, 1, 2}, {0, 1, 3}, {2, 1, 0}}));
    write("mirrored.off", samples::off(4, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}));
    const auto code = [&](const std::string& file, const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"canonical", file};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Json json = run_json(arguments);
        return std::pair(json["code"], json["digest"]);
    };
    EXPECT_EQ(code("a.off", {"--labelled"}), code("b.off", {"--labelled"}));
    EXPECT_EQ(code("a.off", {}), code("mirrored.off", {}));
    EXPECT_NE(code("a.off", {"--labelled"}), code("mirrored.off", {"--labelled"}));
    EXPECT_EQ(code("a.off", {"--labelled", "--mirror"}),
              code("mirrored.off", {"--labelled", "--mirror"}));
}

TEST_F(Canonical, RefusesWhatIsNoSurfaceAndGoesOn) {
    write("open.off", samples::off(3, {{0, 1, 2}}));
    write("a", samples::smallest_sphere);
    expect_unusable({"canonical", "open.off"}, {"open.off:6: face 0, side 0", "tightflip check"});
    expect_unusable({"canonical", "none"}, {"none"});
    const Outcome both = run({"canonical", "--json", "open.off", "a"});
    EXPECT_EQ(both.exit_code, 2);
    const auto objects = both.objects();
    ASSERT_EQ(objects.size(), 2U);
    EXPECT_TRUE(objects[0].contains("error"));
    EXPECT_EQ(objects[1]["vertices"], 3);
    expect_wrong_usage({"canonical"}, {"FILE"});
}

}  // namespace
}  // namespace tightflip::tools
