#include "command_runner.hpp"
#include "documented_keys.hpp"

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

class Hull : public CommandTest {};

TEST_F(Hull, KeysAreAsDocumented) {
    write("cube.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n.5 .5 .5\n");
    expect_as_documented(
        "hull", run_json({"hull", "cube.xyz", "--leave-out", "-o", "a.off", "--log", "a.log"}));
    expect_as_documented("hull", run_json({"hull", "cube.xyz", "-o", "b.off"}, 1));
    EXPECT_THAT(names(), UnorderedElementsAre("cube.xyz", "a.off", "a.log"));
}

TEST_F(Hull, OfTheCubeHasItsFacets) {
    write("cube.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n");
    const Json json = run_json({"hull", "cube.xyz", "-o", "a.off", "--log", "a.log"});
    EXPECT_EQ(json["vertices"], 8);
    EXPECT_EQ(json["faces"], 12);
    EXPECT_EQ(json["certificate"], "convex_up_to_flat_edges");
    EXPECT_EQ(json["convex"], true);
    const Json measured = run_json({"measure", "a.off"});
    EXPECT_EQ(measured["convex_edges"], 12);
    EXPECT_EQ(measured["flat_edges"], 6);
    EXPECT_NEAR(measured["volume"], 1, 1e-12);
    EXPECT_EQ(measured["embedded"], true);
    // The log leads from a book to a surface with the very same triangles.
    const Json replayed = run_json({"replay", "a.log"});
    EXPECT_EQ(replayed["flips_done"], json["flips"]);
}

TEST_F(Hull, TakesPointsOfAnyFileAndItsLogIsACertificate) {
    ASSERT_EQ(run({"make", "random-sphere", "--vertices", "200", "-o", "points.off"}).exit_code, 0);
    ASSERT_EQ(run({"make", "book", "--vertices", "200", "-o", "book"}).exit_code, 0);
    const Json json = run_json({"hull", "points.off", "-o", "a.tfs", "--log", "a.log", "--binary"});
    EXPECT_EQ(json["certificate"], "convex");
    EXPECT_EQ(run({"verify", "book", "a.tfs", "a.log"}).exit_code, 0);
    EXPECT_EQ(run({"isomorphic", "--labelled", "points.off", "a.tfs"}).exit_code, 0);
}

TEST_F(Hull, LeavesOutWhatIsInsideWhereAsked) {
    write("a.xyz", "0 0 0\n4 0 0\n0 4 0\n0 0 4\n1 1 1\n0 0 0\n");
    const Outcome refused = run({"hull", "a.xyz", "-o", "a.off"});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.out, HasSubstr("points 0 and 5 coincide"));
    EXPECT_THAT(refused.out, HasSubstr("--leave-out"));
    EXPECT_THAT(names(), UnorderedElementsAre("a.xyz"));
    EXPECT_EQ(run_json({"hull", "a.xyz", "-o", "a.off", "--leave-out"})["vertices"], 4);
    write("b.xyz", "0 0 0\n4 0 0\n0 4 0\n0 0 4\n1 1 1\n");
    EXPECT_THAT(run_json({"hull", "b.xyz", "-o", "b.off"}, 1)["reason"], HasSubstr("point 4"));
}

TEST_F(Hull, SaysWhyThereIsNone) {
    write("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n");
    EXPECT_THAT(run({"hull", "flat.xyz", "-o", "a.off"}).out, HasSubstr("one plane"));
    write("few.xyz", "0 0 0\n1 0 0\n0 1 0\n");
    EXPECT_THAT(run({"hull", "few.xyz", "-o", "a.off"}).out, HasSubstr("too few"));
    expect_unusable({"hull", "missing.xyz", "-o", "a.off"}, {"missing.xyz"});
    write("bad.xyz", "0 0 0\n1 0\n");
    expect_unusable({"hull", "bad.xyz", "-o", "a.off"}, {"bad.xyz:2", "z coordinate"});
    expect_wrong_usage({"hull", "few.xyz"}, {"--output"});
    expect_wrong_usage({"hull", "few.xyz", "-o", "a", "--log", "a"}, {"--log"});
}

TEST_F(Hull, StopsAtItsTimeAndWritesNothing) {
    ASSERT_EQ(run({"make", "random-sphere", "--vertices", "20000", "-o", "points.off"}).exit_code,
              0);
    const Json json = run_json({"hull", "points.off", "-o", "a.off", "--time", "0"}, 3);
    EXPECT_EQ(json["convex"], false);
    EXPECT_THAT(json["reason"], HasSubstr("time"));
    EXPECT_THAT(names(), UnorderedElementsAre("points.off"));
}

}  // namespace
}  // namespace tightflip::tools
