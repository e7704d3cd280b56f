#include "command_runner.hpp"
#include "documented_keys.hpp"
#include "samples.hpp"

#include <cstdlib>

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

class Render : public CommandTest {
protected:
    Render() {
        write("a.off",
              "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n"
              "3 2 0 3\n");
    }
    /// The picture that some options make.
    [[nodiscard]] std::string picture(std::vector<std::string> options) const {
        options.insert(options.begin(), {"render", "a.off", "-o", "a.svg"});
        run_json(options);
        return read("a.svg");
    }
};

TEST_F(Render, KeysAreAsDocumented) {
    const Json json = run_json({"render", "a.off", "-o", "a.svg", "--view", "-10.5,7"});
    expect_as_documented("render", json);
    EXPECT_EQ(json["azimuth"], -10.5);
    EXPECT_EQ(json["elevation"], 7);
    EXPECT_EQ(json["output"], "a.svg");
    EXPECT_THAT(names(), UnorderedElementsAre("a.off", "a.svg"));
    EXPECT_THAT(run({"render", "a.off", "-o", "a.svg"}).out, HasSubstr("drawn in a.svg"));
}

TEST_F(Render, OptionsChangeThePicture) {
    const std::string plain = picture({});
    EXPECT_THAT(plain, StartsWith("<svg xmlns="));
    EXPECT_THAT(plain, HasSubstr("width=\"640\""));
    EXPECT_THAT(plain, HasSubstr(">convex edges 6<"));
    EXPECT_THAT(plain, HasSubstr(">convex vertices 4<"));
    EXPECT_THAT(plain, Not(HasSubstr("class=\"hidden")));
    EXPECT_EQ(picture({}), plain);
    EXPECT_EQ(picture({"--view", "30,20", "--style", "shaded", "--colour", "type"}), plain);
    EXPECT_NE(picture({"--view", "31,20"}), plain);
    EXPECT_THAT(picture({"--size", "200"}), HasSubstr("width=\"200\""));
    EXPECT_THAT(picture({"--title", "Corner & edge"}), HasSubstr(">Corner &amp; edge<"));
    EXPECT_THAT(picture({"--colour", "curvature"}), HasSubstr("angle deficit"));
    EXPECT_THAT(picture({"--colour", "none"}), Not(HasSubstr("vertices")));
}

TEST_F(Render, AWireframeHasHiddenEdgesAndNoFaces) {
    EXPECT_THAT(picture({"--style", "wireframe"}), HasSubstr("class=\"hidden convex\""));
    EXPECT_THAT(picture({"--style", "wireframe"}), Not(HasSubstr("class=\"faces\"")));
    EXPECT_THAT(picture({"--style", "wireframe", "--no-hidden-edges"}),
                Not(HasSubstr("class=\"hidden")));
    const std::string shaded = picture({"--hidden-edges"});
    EXPECT_THAT(shaded, HasSubstr("class=\"hidden convex\""));
    EXPECT_THAT(shaded, HasSubstr("class=\"faces\""));
}

TEST_F(Render, WritesPng) {
    if (std::system("command -v rsvg-convert >/dev/null") != 0) {
        GTEST_SKIP() << "rsvg-convert (Debian: librsvg2-bin) is not installed";
    }
    EXPECT_EQ(run_json({"render", "a.off", "-o", "a.png", "--size", "300"})["output"], "a.png");
    const std::string png = read("a.png");
    ASSERT_GT(png.size(), 1000U);
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    // The width stands in bytes 16 to 19, the high one first.
    EXPECT_EQ(static_cast<unsigned char>(png[18]) * 256 + static_cast<unsigned char>(png[19]), 300);
    EXPECT_THAT(names(), UnorderedElementsAre("a.off", "a.png"));
}

TEST_F(Render, SaysWhatPngNeeds) {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    expect_unusable({"render", "a.off", "-o", "a.png"}, {"rsvg-convert", "librsvg2-bin", ".svg"});
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_THAT(names(), UnorderedElementsAre("a.off"));
}

TEST_F(Render, RefusesWhatItCannotDrawAndLeavesWhatWasThere) {
    write("sphere", samples::smallest_sphere);
    write("open.off", samples::off(3, {{0, 1, 2}}));
    write("old.svg", "what was here before");
    expect_unusable({"render", "sphere", "-o", "old.svg"}, {"sphere"});
    expect_unusable({"render", "open.off", "-o", "old.svg"}, {"open.off:6"});
    expect_unusable({"render", "lost.off", "-o", "old.svg"}, {"lost.off"});
    expect_unusable({"render", "a.off", "-o", "missing/a.svg"}, {"missing/a.svg"});
    EXPECT_EQ(read("old.svg"), "what was here before");
    EXPECT_THAT(names(), UnorderedElementsAre("a.off", "sphere", "open.off", "old.svg"));
}

}  // namespace
}  // namespace tightflip::tools
