#include "command_runner.hpp"
#include "documented_keys.hpp"

#include <csignal>
#include <numbers>
#include <thread>

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

constexpr double pi = std::numbers::pi;

class Optimise : public CommandTest {
protected:
    void make(const std::string& kind, const std::string& name,
              const std::vector<std::string>& options = {}) const {
        std::vector<std::string> arguments{"make", kind, "-o", name};
        arguments.insert(arguments.end(), options.begin(), options.end());
        ASSERT_EQ(run(arguments).exit_code, 0);
    }
    /// The log leads from the first surface to the second.
    void expect_path(const std::string& from, const std::string& to, const std::string& log) const {
        EXPECT_EQ(run({"verify", from, to, log}).exit_code, 0);
    }
};

TEST_F(Optimise, KeysAreAsDocumented) {
    make("twisted-prism", "a.off");
    expect_as_documented("optimise", run_json({"optimise", "a.off", "-o", "b.off"}));
    expect_as_documented("optimise", run_json({"optimise", "a.off", "-o", "b.off", "--then",
                                               "area,mean", "--log", "b.log", "--trace", "b.csv"}));
    expect_as_documented("optimise",
                         run_json({"optimise", "a.off", "-o", "b.off", "--max-flips", "1"}, 3));
    EXPECT_THAT(names(), UnorderedElementsAre("a.off", "b.off", "b.log", "b.csv"));
}

TEST_F(Optimise, TheTwistedPrismBecomesConvex) {
    make("twisted-prism", "prism.off");
    const Json json = run_json({"optimise", "prism.off", "-o", "hull.tfs", "--log", "hull.log"});
    EXPECT_EQ(json["criterion"], "tight");
    EXPECT_EQ(json["strategy"], "hull");
    EXPECT_GT(json["initial"], 15.0);
    EXPECT_NEAR(json["final"], 4 * pi, 1e-9);
    EXPECT_EQ(json["flips"], 9);
    EXPECT_EQ(json["converged"], true);
    EXPECT_EQ(json["convex"], true);
    EXPECT_EQ(json["certificate"], "convex");
    EXPECT_EQ(json["embedded"], true);
    expect_path("prism.off", "hull.tfs", "hull.log");
}

TEST_F(Optimise, EveryCriterionForClosedSurfacesRuns) {
    make("bumpy-torus", "a.off", {"--vertices", "60"});
    for (const char* criterion : {"tight", "mean", "mean_weighted", "area", "edge_length", "volume",
                                  "abn", "abn_squares", "delaunay", "min_angle"}) {
        const Json json = run_json({"optimise", "a.off", "--criterion", criterion, "-o", "b.tfs",
                                    "--log", "b.log", "--strategy", "local"});
        EXPECT_LE(json["final"], json["initial"]) << criterion;
        EXPECT_EQ(json["genus"], 1);
        EXPECT_EQ(json["converged"], true) << criterion;
        expect_path("a.off", "b.tfs", "b.log");
    }
    expect_unusable({"optimise", "a.off", "--criterion", "jnd", "-o", "c.tfs"}, {"jnd"});
    expect_unusable({"optimise", "a.off", "--criterion", "tigth", "-o", "c.tfs"}, {"tigth"});
}

TEST_F(Optimise, FunctionalDataNeedTheirMarkedVertex) {
    make("franke", "a.off", {"--vertices", "40"});
    const Json json =
        run_json({"optimise", "a.off", "--criterion", "jnd", "--marked", "39", "-o", "b.off"});
    EXPECT_LT(json["final"], json["initial"]);
    expect_unusable({"optimise", "a.off", "--criterion", "jnd", "-o", "c.off"}, {"vertex"});
    expect_unusable({"optimise", "a.off", "--criterion", "jnd", "--marked", "40", "-o", "c.off"},
                    {"vertex 40"});
}

TEST_F(Optimise, AnotherCriterionCanFollow) {
    make("bumpy-sphere", "a.off", {"--vertices", "100"});
    const Json json = run_json({"optimise", "a.off", "--strategy", "local", "--then", "mean", "-o",
                                "b.tfs", "--log", "b.log", "--trace", "b.csv"});
    EXPECT_EQ(json["then"]["criterion"], "mean");
    EXPECT_LT(json["then"]["final"], json["then"]["initial"]);
    expect_path("a.off", "b.tfs", "b.log");
    const int flips = json["flips"].get<int>() + json["then"]["flips"].get<int>();
    EXPECT_EQ(run_json({"replay", "b.log"})["flips_done"], flips);
    EXPECT_THAT(read("b.csv"), StartsWith("criterion,flips,energy\n\"tight\",0,"));
    EXPECT_THAT(read("b.csv"), HasSubstr("\n\"mean\"," + std::to_string(flips) + ","));
}

TEST_F(Optimise, StopsAtALimitAndGoesOnFromItsLog) {
    make("bumpy-sphere", "a.off", {"--vertices", "100"});
    const std::vector<std::string> whole{"optimise", "a.off", "-o",         "c.tfs",
                                         "--log",    "c.log", "--strategy", "local"};
    std::vector<std::string> limited = whole;
    limited.insert(limited.end(), {"--max-flips", "5"});
    const Json stopped = run_json(limited, 3);
    EXPECT_EQ(stopped["end"], "flip_limit");
    EXPECT_EQ(stopped["converged"], false);
    EXPECT_EQ(stopped["flips"], 5);
    EXPECT_LT(stopped["final"], stopped["initial"]);
    expect_path("a.off", "c.tfs", "c.log");
    const Json resumed = run_json({"optimise", "a.off", "--resume", "c.log", "-o", "d.tfs", "--log",
                                   "d.log", "--strategy", "local"});
    EXPECT_EQ(resumed["initial"], stopped["final"]);
    EXPECT_EQ(resumed["converged"], true);
    expect_path("a.off", "d.tfs", "d.log");
    const Json late =
        run_json({"optimise", "a.off", "-o", "e.tfs", "--time", "0", "--strategy", "local"}, 3);
    EXPECT_EQ(late["end"], "time_limit");
    make("twisted-prism", "other.off");
    expect_unusable({"optimise", "other.off", "--resume", "c.log", "-o", "f.tfs"},
                    {"c.log", "another surface"});
}

TEST_F(Optimise, KeepsToItsRestrictions) {
    make("bumpy-sphere", "a.off", {"--vertices", "100"});
    const Json simple =
        run_json({"optimise", "a.off", "--criterion", "area", "--simple", "-o", "s.tfs"});
    EXPECT_LT(simple["final"], simple["initial"]);
    EXPECT_EQ(run_json({"check", "s.tfs"})["simple"], true);
    const Json embedded =
        run_json({"optimise", "a.off", "--criterion", "area", "--embedded", "-o", "e.tfs"});
    EXPECT_EQ(embedded["embedded"], true);
    make("twisted-prism", "p.off");
    std::string edges = "0";
    for (int e = 1; e < 21; ++e)
        edges += "," + std::to_string(e);
    EXPECT_EQ(run_json({"optimise", "p.off", "--lock", edges, "-o", "l.tfs"})["flips"], 0);
    expect_unusable({"optimise", "p.off", "--lock", "21", "-o", "l.tfs"}, {"edge 21"});
    expect_wrong_usage({"optimise", "p.off", "--strategy", "luck", "-o", "l.tfs"}, {"luck"});
    expect_wrong_usage({"optimise", "p.off", "--simple", "--embedded", "-o", "l.tfs"},
                       {"--simple"});
}

TEST_F(Optimise, AnInterruptLeavesTheBestSoFar) {
    make("random-sphere", "a.tfs", {"--vertices", "3000"});
    ASSERT_EQ(run({"flip", "a.tfs", "--random", "30000", "-o", "b.tfs"}).exit_code, 0);
    Running search(path(""),
                   {"optimise", "b.tfs", "--criterion", "mean", "--strategy", "kicks", "-o",
                    "c.tfs", "--log", "c.log", "--json"},
                   {});
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    search.send(SIGINT);
    const Outcome outcome = search.finish();
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    const Json json = outcome.object();
    EXPECT_EQ(json["end"], "interrupted");
    EXPECT_LT(json["final"], json["initial"]);
    expect_path("b.tfs", "c.tfs", "c.log");
}

TEST_F(Optimise, RefusesWhatIsNoClosedSurfaceWithPoints) {
    write("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    expect_unusable({"optimise", "open.off", "-o", "a.off"}, {"open.off"});
    make("book", "book", {"--vertices", "6"});
    expect_unusable({"optimise", "book", "-o", "a.off"}, {"book", "coordinates"});
    EXPECT_THAT(names(), UnorderedElementsAre("open.off", "book"));
}

TEST_F(Optimise, NoOutputTakesTheNameOfAnother) {
    make("twisted-prism", "a.off");
    const std::string before = read("a.off");
    expect_wrong_usage({"optimise", "a.off", "-o", "b", "--log", "b"}, {"--log", "--output"});
    expect_wrong_usage({"optimise", "a.off", "-o", "b", "--trace", "./b"}, {"--trace", "--output"});
    expect_wrong_usage({"optimise", "a.off", "-o", "b", "--log", "c", "--trace", "c"},
                       {"--trace", "--log"});
    expect_wrong_usage({"optimise", "a.off", "-o", "b", "--log", "a.off"}, {"--log", "FILE"});
    expect_wrong_usage({"optimise", "a.off", "-o", "b", "--trace", "a.off"}, {"--trace", "FILE"});
    expect_wrong_usage({"optimise", "a.off", "-o", ""}, {"--output", "name"});
    EXPECT_THAT(names(), UnorderedElementsAre("a.off"));
    EXPECT_EQ(read("a.off"), before);
    EXPECT_EQ(run({"optimise", "a.off", "-o", "a.off"}).exit_code, 0);  // asked for
    EXPECT_NE(read("a.off"), before);
}

TEST_F(Optimise, ValuesOutOfRangeAreNoNumbers) {
    write("a.off",
          "OFF\n4 4 0\n0 0 0\n1e300 0 0\n0 1e300 0\n0 0 1e300\n3 0 2 1\n3 0 1 3\n"
          "3 1 2 3\n3 2 0 3\n");
    const Json json = run_json({"optimise", "a.off", "--criterion", "area", "-o", "b.off"});
    EXPECT_TRUE(json["initial"].is_null());
    EXPECT_TRUE(json["final"].is_null());
    EXPECT_NEAR(run_json({"optimise", "a.off", "-o", "b.off"})["final"], 4 * pi, 1e-9);
}

}  // namespace
}  // namespace tightflip::tools
