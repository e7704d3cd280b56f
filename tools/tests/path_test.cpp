#include "command_runner.hpp"
#include "documented_keys.hpp"
#include "samples.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <thread>

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

class Path : public CommandTest {
protected:
    Path() {
        make("random", "a", {"--vertices", "60", "--seed", "1"});
        make("random", "b", {"--vertices", "60", "--seed", "2"});
    }
    void make(const std::string& kind, const std::string& file,
              const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"make", kind, "-o", file};
        arguments.insert(arguments.end(), more.begin(), more.end());
        ASSERT_EQ(run(arguments).exit_code, 0);
    }
    /// The flips between the surface at the log's end and `target`: none where they are equal.
    [[nodiscard]] Json flips_left(const std::string& log, const std::string& target) const {
        run_json({"replay", log, "-o", log + ".end"});
        return run_json({"path", log + ".end", target, "-o", log + ".rest"})["flips"];
    }
};

TEST_F(Path, KeysAreAsDocumented) {
    expect_as_documented("path", run_json({"path", "a", "b", "-o", "log"}));
    expect_as_documented("path", run_json({"path", "a", "b", "-o", "log", "--shorten"}));
}

TEST_F(Path, LeadsFromOneSurfaceToTheOther) {
    const Json json = run_json({"path", "a", "b", "-o", "log"});
    EXPECT_EQ(json["from"], "a");
    EXPECT_EQ(json["to"], "b");
    EXPECT_EQ(json["output"], "log");
    EXPECT_EQ(json["vertices"], 60);
    EXPECT_EQ(json["genus"], 0);
    EXPECT_EQ(json["bound"], 2 * 58 * 6 + 8 * 60 - 24);
    EXPECT_GT(json["flips"], 0);
    EXPECT_LE(json["flips"], json["bound"]);
    EXPECT_GE(json["seconds"], 0);
    EXPECT_NEAR(json["flips_per_v_log2_v"].get<double>(),
                json["flips"].get<double>() / (60 * std::log2(60.0)), 1e-9);
    EXPECT_FALSE(json.contains("flips_constructed"));
    const Json replayed = run_json({"replay", "log", "--audit-every", "1"});
    EXPECT_EQ(replayed["verdict"], "holds");
    EXPECT_EQ(replayed["flips"], json["flips"]);
    EXPECT_EQ(flips_left("log", "b"), 0);
    EXPECT_NE(flips_left("log", "a"), 0);
    EXPECT_THAT(run({"path", "a", "b", "-o", "log"}).out,
                HasSubstr("log: " + json["flips"].dump() + " flips from a to b"));
}

TEST_F(Path, ShortensOnRequest) {
    const Json plain = run_json({"path", "a", "b", "-o", "plain"});
    const Json shorter = run_json({"path", "a", "b", "-o", "shorter", "--shorten"});
    EXPECT_EQ(shorter["flips_constructed"], plain["flips"]);
    EXPECT_LT(shorter["flips"], plain["flips"]);
    EXPECT_EQ(run_json({"replay", "shorter"})["flips"], shorter["flips"]);
    EXPECT_EQ(flips_left("shorter", "b"), 0);
}

TEST_F(Path, WritesBothFormsOfALog) {
    run_json({"path", "a", "b", "-o", "text"});
    run_json({"path", "a", "b", "-o", "binary", "--binary"});
    EXPECT_TRUE(read("text").starts_with("tightflip-flip-log 1\n"));
    EXPECT_TRUE(read("binary").starts_with("\x89TFLIPS\n"));
    EXPECT_LT(read("binary").size(), read("text").size());
    EXPECT_EQ(flips_left("text", "b"), 0);
    EXPECT_EQ(flips_left("binary", "b"), 0);
    EXPECT_EQ(read("binary.end"), read("text.end"));
}

TEST_F(Path, IsEmptyBetweenEqualSurfaces) {
    EXPECT_EQ(run_json({"path", "a", "a", "-o", "log"})["flips"], 0);
    write("sphere", samples::smallest_sphere);
    const Json json = run_json({"path", "sphere", "sphere", "-o", "log"});
    EXPECT_EQ(json["flips"], 0);
    EXPECT_EQ(json["bound"], 0);
}

TEST_F(Path, TakesMeshesByTheOrderOfTheirVertices) {
    write("tetrahedron.off", samples::off(4, samples::tetrahedron));
    samples::Faces mirrored = samples::tetrahedron;
    for (auto& face : mirrored)
        std::swap(face[1], face[2]);
    write("mirrored.off", samples::off(4, mirrored));
    const Json json = run_json({"path", "tetrahedron.off", "mirrored.off", "-o", "log"});
    EXPECT_GE(json["flips"], 2);  // known: the tetrahedron and its mirror image are two flips apart
    EXPECT_EQ(flips_left("log", "mirrored.off"), 0);
}

TEST_F(Path, RefusesEndsThatNoFlipsCanJoin) {
    make("random", "larger", {"--vertices", "61"});
    make("random", "torus", {"--vertices", "60", "--genus", "1"});
    write("log", "what was here before");
    expect_unusable({"path", "a", "larger", "-o", "log"},
                    {"larger: ", "number of vertices", "60", "61"});
    expect_unusable({"path", "a", "torus", "-o", "log"}, {"torus: ", "genus"});
    EXPECT_EQ(read("log"), "what was here before");
    EXPECT_THAT(names(), UnorderedElementsAre("a", "b", "larger", "torus", "log"));
}

TEST_F(Path, RefusesInputsThatAreNoSurfaces) {
    write("open.off", samples::off(3, {{0, 1, 2}}));
    run_json({"path", "a", "b", "-o", "log"});
    expect_unusable({"path", "a", "open.off", "-o", "new"}, {"open.off:6: face 0, side 0"});
    expect_unusable({"path", "open.off", "a", "-o", "new"}, {"open.off:6: face 0, side 0"});
    expect_unusable({"path", "missing", "a", "-o", "new"}, {"missing"});
    expect_unusable({"path", "a", "log", "-o", "new"}, {"log: this is a flip log"});
    expect_unusable({"path", "a", "b", "-o", "no/where"}, {"no/where"});
    expect_wrong_usage({"path", "a", "b"}, {"--output"});
    expect_wrong_usage({"path", "a", "-o", "new"}, {"TO"});
    EXPECT_THAT(names(), UnorderedElementsAre("a", "b", "open.off", "log"));
}

TEST_F(Path, ShortestPathsAreSearchedFor) {
    write("tetrahedron.off", samples::off(4, samples::tetrahedron));
    samples::Faces mirrored = samples::tetrahedron;
    for (auto& face : mirrored)
        std::swap(face[1], face[2]);
    write("mirrored.off", samples::off(4, mirrored));
    const Json json =
        run_json({"path", "tetrahedron.off", "mirrored.off", "-o", "log", "--shortest"});
    expect_as_documented("path", json);
    EXPECT_EQ(json["verdict"], "found");
    EXPECT_EQ(json["flips"], 2);
    EXPECT_EQ(run({"verify", "tetrahedron.off", "mirrored.off", "log"}).exit_code, 0);
    make("random", "torus", {"--vertices", "5", "--genus", "1", "--seed", "1"});
    make("random", "torus2", {"--vertices", "5", "--genus", "1", "--seed", "2"});
    EXPECT_EQ(run_json({"path", "torus", "torus2", "-o", "log"})["verdict"], "found");
    EXPECT_EQ(run({"verify", "torus", "torus2", "log"}).exit_code, 0);
}

TEST_F(Path, SaysWhereThereIsNone) {
    // Genus 3 with three vertices: no flip is defined.
    make("genus", "one", {"--vertices", "3", "--genus", "3", "--seed", "0"});
    std::string other = "0";
    do {
        other = std::to_string(std::stoi(other) + 1);
        make("genus", "other", {"--vertices", "3", "--genus", "3", "--seed", other});
    } while (run({"path", "one", "other", "-o", "log"}).exit_code == 0);
    std::filesystem::remove(path("log"));
    const Json json = run_json({"path", "one", "other", "-o", "log"}, 1);
    expect_as_documented("path", json);
    EXPECT_EQ(json["verdict"], "isolated");
    EXPECT_THAT(run({"path", "one", "other", "-o", "log"}).out, HasSubstr("there is no path"));
    EXPECT_FALSE(names().contains("log"));
}

TEST_F(Path, SaysWhereASearchIsUndecided) {
    make("random", "torus", {"--vertices", "60", "--genus", "1", "--seed", "1"});
    make("random", "torus2", {"--vertices", "60", "--genus", "1", "--seed", "2"});
    const Json json = run_json({"path", "torus", "torus2", "-o", "log", "--limit", "1000"}, 3);
    expect_as_documented("path", json);
    EXPECT_EQ(json["verdict"], "not_found");
    EXPECT_LE(json["states"], 1000);
    EXPECT_GE(json["least_flips"], 3);
    EXPECT_FALSE(names().contains("log"));
    Outcome stopped;
    for (auto wait = std::chrono::milliseconds(250); stopped.exit_code < 0; wait *= 2) {
        // A signal that comes before the command notes it ends the process: then wait longer.
        ASSERT_LT(wait, std::chrono::seconds(60));
        Running search(path(""), {"path", "a", "b", "-o", "log", "--shortest", "--json"}, {});
        std::this_thread::sleep_for(wait);
        search.send(SIGINT);
        stopped = search.finish();
    }
    EXPECT_EQ(stopped.exit_code, 3);
    EXPECT_EQ(stopped.object()["verdict"], "not_found");
    expect_wrong_usage({"path", "a", "b", "-o", "log", "--limit", "-1"}, {"--limit"});
}

TEST_F(Path, SaysInItsHelpThatLabelsAreKept) {
    EXPECT_THAT(run({"path", "--help"}).out, HasSubstr("Vertices keep their labels"));
}

}  // namespace
}  // namespace tightflip::tools
