#include "command_runner.hpp"
#include "documented_keys.hpp"
#include "samples.hpp"

#include <numbers>

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

constexpr double pi = std::numbers::pi;

class Measure : public CommandTest {
protected:
    /// The corners at 0 and the three unit vectors, times a factor written before the exponent.
    void write_corner(const std::string& name, const std::string& length) const {
        write(name, "OFF\n4 4 0\n0 0 0\n" + length + " 0 0\n0 " + length + " 0\n0 0 " + length +
                        "\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    }
};

TEST_F(Measure, KeysAreAsDocumented) {
    write_corner("a.off", "1");
    expect_as_documented("measure", run_json({"measure", "a.off"}));
    expect_as_documented("measure", run_json({"measure", "a.off", "--vertices-csv", "v.csv",
                                              "--edges-csv", "e.csv", "--ply", "a.ply"}));
    EXPECT_THAT(names(), UnorderedElementsAre("a.off", "v.csv", "e.csv", "a.ply"));
}

TEST_F(Measure, ACornerOfTheCube) {
    write_corner("a.off", "1");
    const Json json = run_json({"measure", "a.off"});
    EXPECT_NEAR(json["total_curvature"], 4 * pi, 1e-12);
    EXPECT_NEAR(json["total_absolute_curvature"], 4 * pi, 1e-12);
    // Three right angles, and three between (1, 1, 1) and a side.
    const double sum = 3 * (pi / 2) + 3 * (pi - std::acos(1 / std::sqrt(3.0)));
    EXPECT_NEAR(json["mean_absolute_curvature"], sum / 2, 1e-12);
    EXPECT_NEAR(json["area"], 1.5 + std::sqrt(3.0) / 2, 1e-12);
    EXPECT_NEAR(json["volume"], 1.0 / 6, 1e-12);
    EXPECT_EQ(json["convex_vertices"], 4);
    EXPECT_EQ(json["convex_edges"], 6);
    for (const char* key : {"saddle_vertices", "mixed_vertices", "flat_vertices", "concave_edges",
                            "flat_edges", "folded_edges", "degenerate_edges", "pinch_points",
                            "local_self_intersections", "global_self_intersections",
                            "coincident_pairs", "collinear_triples", "coplanar_quadruples"}) {
        EXPECT_EQ(json[key], 0) << key;
    }
    EXPECT_EQ(json["embedded"], true);
    EXPECT_EQ(json["general_position"], true);
    EXPECT_EQ(json["general_position_scope"], "all_points");
    const Outcome words = run({"measure", "a.off"});
    EXPECT_EQ(words.exit_code, 0);
    for (const char* part : {"genus 0", "4 convex", "embedded", "in general position"})
        EXPECT_THAT(words.out, HasSubstr(part));
}

TEST_F(Measure, FoldedEdgesAndIntersectionsAreCounted) {
    write("flat.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n");
    const Json flat = run_json({"measure", "flat.off"});
    EXPECT_EQ(flat["folded_edges"], 3);
    EXPECT_EQ(flat["embedded"], false);
    EXPECT_EQ(flat["volume"], 0);
    write("coincident.off",
          "OFF\n4 4 0\n0 0 0\n0 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n"
          "3 2 0 3\n");
    const Json coincident = run_json({"measure", "coincident.off"});
    EXPECT_EQ(coincident["general_position"], false);
    EXPECT_EQ(coincident["coincident_pairs"], 1);
    EXPECT_GT(coincident["degenerate_edges"], 0);
    EXPECT_GT(coincident["pinch_points"], 0);
    EXPECT_THAT(run({"measure", "coincident.off"}).out, HasSubstr("not in general position"));
}

TEST_F(Measure, WhatExceedsTheNumbersIsNull) {
    write_corner("huge.off", "1e300");
    const Json huge = run_json({"measure", "huge.off"});
    EXPECT_EQ(huge["area"], nullptr);
    EXPECT_EQ(huge["volume"], nullptr);
    EXPECT_NEAR(huge["total_curvature"], 4 * pi, 1e-12);
    EXPECT_EQ(huge["convex_edges"], 6);
    write_corner("tiny.off", "1e-300");
    EXPECT_EQ(run_json({"measure", "tiny.off"})["convex_edges"], 6);
}

TEST_F(Measure, WritesValues) {
    write_corner("a.off", "2");
    run_json(
        {"measure", "a.off", "--vertices-csv", "v.csv", "--edges-csv", "e.csv", "--ply", "a.ply"});
    EXPECT_THAT(read("v.csv"), StartsWith("vertex,degree,x,y,z,theta,omega,"));
    EXPECT_THAT(read("v.csv"), HasSubstr("\n1,3,2,0,0,"));
    EXPECT_EQ(std::ranges::count(read("v.csv"), '\n'), 5);
    EXPECT_THAT(read("e.csv"), StartsWith("edge,origin,target,length,"));
    EXPECT_EQ(std::ranges::count(read("e.csv"), '\n'), 7);
    // The PLY file is a surface again.
    Json of_off = run_json({"measure", "a.off"});
    Json of_ply = run_json({"measure", "a.ply"});
    for (const char* key : {"file", "format"}) {
        of_off.erase(key);
        of_ply.erase(key);
    }
    EXPECT_EQ(of_ply, of_off);
}

TEST_F(Measure, RefusesWhatHasNoPointsOrIsNoSurfaceAndGoesOn) {
    write("sphere", samples::smallest_sphere);
    write("open.off", samples::off(3, {{0, 1, 2}}));
    write_corner("a.off", "1");
    expect_unusable({"measure", "sphere"}, {"sphere"});
    expect_unusable({"measure", "open.off"}, {"open.off:6"});
    expect_unusable({"measure", "sphere", "--ply", "a.ply"}, {"sphere"});
    expect_unusable({"measure", "a.off", "--ply", "missing/a.ply"}, {"missing/a.ply"});
    expect_wrong_usage({"measure", "a.off", "--vertices-csv", "./a.off"}, {"--vertices-csv"});
    EXPECT_THAT(read("a.off"), StartsWith("OFF"));
    const Outcome all = run({"measure", "--json", "sphere", "a.off"});
    EXPECT_EQ(all.exit_code, 2);
    const std::vector<Json> objects = all.objects();
    ASSERT_EQ(objects.size(), 2U);
    EXPECT_TRUE(objects[0].contains("error"));
    EXPECT_EQ(objects[1]["genus"], 0);
    EXPECT_THAT(names(), UnorderedElementsAre("sphere", "open.off", "a.off"));
}

TEST_F(Measure, CountsNoMoreIntersectionsThanAsked) {
    // A tetrahedron pressed flat.
    write("flat.off",
          "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0.2 0.2 0\n3 0 2 1\n3 0 1 3\n3 1 2 3\n"
          "3 2 0 3\n");
    const Json all = run_json({"measure", "flat.off"});
    ASSERT_GT(all["local_self_intersections"], 1);
    EXPECT_EQ(all["self_intersections_complete"], true);
    const Json some = run_json({"measure", "flat.off", "--max-intersections", "1"});
    EXPECT_EQ(some["local_self_intersections"], 1);
    EXPECT_EQ(some["self_intersections_complete"], false);
    EXPECT_EQ(some["embedded"], false);
    EXPECT_THAT(run({"measure", "flat.off", "--max-intersections", "1"}).out,
                HasSubstr("not embedded: at least 1 local"));
}

}  // namespace
}  // namespace tightflip::tools
