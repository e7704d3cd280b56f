#include "command_runner.hpp"
#include "documented_keys.hpp"

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Explore : public CommandTest {};

TEST_F(Explore, KeysAreAsDocumented) {
    expect_as_documented("explore", run_json({"explore", "--vertices", "5", "--mirror"}));
    expect_as_documented("explore", run_json({"explore", "--vertices", "5", "--labelled"}));
    expect_as_documented("explore",
                         run_json({"explore", "--vertices", "5", "--dot", "classes.dot"}));
}

TEST_F(Explore, CountsClassesOfTheSphere) {
    const Json json = run_json({"explore", "--vertices", "7", "--mirror"});
    EXPECT_EQ(json["states"], 54);
    EXPECT_EQ(json["expected_states"], 54);
    EXPECT_EQ(json["complete"], true);
    EXPECT_EQ(json["components"], 1);
    EXPECT_EQ(json["radius"], 4);
    EXPECT_EQ(json["diameter"], 7);
    EXPECT_EQ(json["min_degree"], 5);
    EXPECT_EQ(json["max_degree"], 15);
    EXPECT_GT(json["peak_bytes"], 0);
    const Outcome words = run({"explore", "--vertices", "7"});
    EXPECT_EQ(words.exit_code, 0);
    EXPECT_THAT(words.out, HasSubstr("66"));
    EXPECT_THAT(words.out, HasSubstr("all there are"));
    EXPECT_THAT(words.out, HasSubstr("diameter 7"));
}

TEST_F(Explore, CountsLabelledSpheres) {
    const Json json = run_json({"explore", "--vertices", "6", "--labelled"});
    EXPECT_EQ(json["states"], 5280);
    EXPECT_EQ(json["expected_states"], 5280);
    EXPECT_EQ(json["diameter"], 10);
    EXPECT_EQ(json["kind"], "labelled");
}

TEST_F(Explore, FindsWhereTheTheoremEnds) {
    const Json json = run_json({"explore", "--vertices", "3", "--genus", "2"});
    EXPECT_EQ(json["states"], 2);
    EXPECT_EQ(json["components"], 2);
    EXPECT_EQ(json["diameter"], nullptr);
}

TEST_F(Explore, SimpleGraphsAreFewer) {
    EXPECT_EQ(run_json({"explore", "--vertices", "8", "--mirror", "--simple"})["states"], 14);
}

TEST_F(Explore, ThreadsDoNotChangeTheResult) {
    Json one = run_json({"explore", "--vertices", "8", "--threads", "1", "--eccentricities"});
    Json three = run_json({"explore", "--vertices", "8", "--threads", "3", "--eccentricities"});
    for (const char* key : {"seconds", "exploring_seconds", "states_per_second", "peak_bytes"}) {
        one.erase(key);
        three.erase(key);
    }
    EXPECT_EQ(one, three);
}

TEST_F(Explore, DistancesCanBeLeftOut) {
    const Json json = run_json({"explore", "--vertices", "6", "--no-distances"});
    EXPECT_EQ(json["states"], 14);
    EXPECT_EQ(json["radius"], nullptr);
    EXPECT_EQ(json["diameter"], nullptr);
}

TEST_F(Explore, DrawsTheClasses) {
    const Json json = run_json({"explore", "--vertices", "5", "--dot", "classes.dot"});
    EXPECT_EQ(json["dot"], "classes.dot");
    EXPECT_THAT(read("classes.dot"), HasSubstr("graph flips {"));
    EXPECT_THAT(read("classes.dot"), HasSubstr("3 3 4 4 4"));
}

TEST_F(Explore, RefusesToDrawTooMany) {
    const Outcome outcome = run({"explore", "--vertices", "10", "--dot", "classes.dot"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("too many to draw"));
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Explore, RefusesSizesOutOfRange) {
    expect_unusable({"explore", "--vertices", "2"}, {"at least 3 vertices"});
    expect_unusable({"explore", "--vertices", "1000"}, {"too many"});
    expect_unusable({"explore", "--vertices", "12", "--labelled"}, {"up to 11 vertices"});
    expect_unusable({"explore", "--vertices", "10", "--labelled", "--memory", "1G"},
                    {"needs about", "limit of 1024 MiB"});
    expect_unusable({"explore", "--vertices", "4", "--genus", "1", "--simple"}, {"no such"});
    expect_wrong_usage({"explore"}, {"--vertices"});
    expect_wrong_usage({"explore", "--vertices", "5", "--labelled", "--mirror"}, {"--mirror"});
    expect_wrong_usage({"explore", "--vertices", "-5"}, {"-5"});
    expect_wrong_usage({"explore", "--vertices", "5", "--memory", "much"}, {"much"});
}

class ExploreCheckpoint : public CommandTest {
protected:
    const std::vector<std::string> arguments{"explore",
                                             "--vertices",
                                             "8",
                                             "--labelled",
                                             "--no-distances",
                                             "--checkpoint",
                                             "kept",
                                             "--checkpoint-every",
                                             "0",
                                             "--threads",
                                             "1"};
    std::filesystem::path kept = path("kept") / "labelled.checkpoint";

    /// Kills a run as soon as it has kept something of its labelled stage.
    void kill_a_run() {
        Running run(path("."), arguments, {});
        while (!std::filesystem::exists(kept)) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        run.send(SIGKILL);
        EXPECT_EQ(run.finish().signal, SIGKILL);
    }
};

TEST_F(ExploreCheckpoint, AKilledRunGoesOnToTheRightCount) {
    kill_a_run();
    const Json json = run_json(arguments);
    EXPECT_EQ(json["states"], 14622720);
    EXPECT_EQ(json["complete"], true);
}

TEST_F(ExploreCheckpoint, ADamagedOneIsRefusedAndKept) {
    kill_a_run();
    std::string bytes = read("kept/labelled.checkpoint");
    bytes[bytes.size() / 2] ^= 1;
    write("kept/labelled.checkpoint", bytes);
    expect_unusable(arguments, {"labelled.checkpoint", "damaged"});
    EXPECT_EQ(read("kept/labelled.checkpoint"), bytes);
}

TEST_F(ExploreCheckpoint, AnotherRunsIsRefused) {
    run_json({"explore", "--vertices", "5", "--checkpoint", "kept"});
    expect_unusable({"explore", "--vertices", "6", "--checkpoint", "kept"},
                    {"classes.checkpoint", "other parameters"});
}

TEST_F(Explore, AnInterruptedRunIsUndecided) {
    Running run(path("."),
                {"explore", "--vertices", "9", "--labelled", "--json", "--checkpoint", "kept",
                 "--checkpoint-every", "0", "--threads", "1"},
                {});
    while (!std::filesystem::exists(path("kept") / "classes.checkpoint")) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    run.send(SIGINT);
    const Outcome outcome = run.finish();
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.object()["verdict"], "undecided");
    EXPECT_THAT(outcome.err, HasSubstr("interrupted"));
}

}  // namespace
}  // namespace tightflip::tools
