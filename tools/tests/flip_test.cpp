#include "command_runner.hpp"
#include "documented_keys.hpp"
#include "samples.hpp"

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

class Flip : public CommandTest {
protected:
    Flip() { run({"make", "octasphere", "-o", "start"}); }
};

TEST_F(Flip, KeysAreAsDocumented) {
    expect_as_documented("flip", run_json({"flip", "start", "--edges", "1"}));
    expect_as_documented(
        "flip", run_json({"flip", "start", "--edges", "1,2", "-o", "end", "--log", "log"}));
    expect_as_documented("flip", run_json({"flip", "start", "--edges", "99"}, 1));
    expect_as_documented("flip", run_json({"flip", "start", "--random", "9", "-o", "end"}));
}

TEST_F(Flip, AtRandomItMakesStartsThatASeedNames) {
    const auto flipped = [&](const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"flip", "start", "--random", "200", "-o", "end"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Json json = run_json(arguments);
        EXPECT_EQ(json["flips"], 200);
        EXPECT_EQ(json["flips_done"], 200);
        return read("end");
    };
    const std::string multigraph = flipped({"--seed", "2", "--log", "log"});
    EXPECT_EQ(run_json({"check", "end"})["simple"], false);
    EXPECT_EQ(run_json({"replay", "log"})["flips_done"], 200);
    EXPECT_EQ(flipped({"--seed", "2"}), multigraph);
    EXPECT_NE(flipped({"--seed", "3"}), multigraph);
    EXPECT_EQ(flipped({"--seed", "0"}), flipped({}));
    EXPECT_NE(flipped({"--simple", "--seed", "2"}), multigraph);
    EXPECT_EQ(run_json({"check", "end"})["simple"], true);
}

TEST_F(Flip, AtRandomItStopsWhereNoEdgeCanBeFlipped) {
    write("a.off", samples::off(4, samples::tetrahedron));
    const Json json = run_json({"flip", "a.off", "--random", "3", "--simple", "-o", "end"}, 1);
    EXPECT_EQ(json["complete"], false);
    EXPECT_EQ(json["flips"], 3);
    EXPECT_EQ(json["flips_done"], 0);
    EXPECT_THAT(json["reason"].get<std::string>(), HasSubstr("flip 1 of 3: no edge can be"));
    EXPECT_THAT(names(), UnorderedElementsAre("start", "a.off"));
}

TEST_F(Flip, ChangesTheSurfaceAndNotItsTopology) {
    const std::string before = read("start");
    const Json json = run_json({"flip", "start", "--edges", "3,7,3", "-o", "end"});
    EXPECT_EQ(json["complete"], true);
    EXPECT_EQ(json["flips"], 3);
    EXPECT_EQ(json["flips_done"], 3);
    EXPECT_EQ(json["output"], "end");
    EXPECT_FALSE(json.contains("log"));
    EXPECT_EQ(read("start"), before);
    EXPECT_NE(read("end"), before);
    const Json end = run_json({"check", "end"});
    EXPECT_EQ(end["valid"], true);
    EXPECT_EQ(end["edges"], 12);
    EXPECT_EQ(end["genus"], 0);
    EXPECT_THAT(run({"flip", "start", "--edges", "3,7,3"}).out, HasSubstr("3 flips done"));
}

TEST_F(Flip, ThreeMoreFlipsUndoOne) {
    const std::string before = read("start");
    run_json({"flip", "start", "--edges", "5", "-o", "once"});
    EXPECT_NE(read("once"), before);
    run_json({"flip", "once", "--edges", "5,5,5", "-o", "again"});
    EXPECT_EQ(read("again"), before);
}

TEST_F(Flip, ItsLogCanBeReplayedAndFollowedAsAScript) {
    run_json({"flip", "start", "--edges", "3,7,0", "-o", "end", "--log", "log"});
    EXPECT_EQ(run_json({"replay", "log", "-o", "replayed"})["flips_done"], 3);
    EXPECT_EQ(read("replayed"), read("end"));
    EXPECT_EQ(run_json({"flip", "start", "--script", "log", "-o", "scripted"})["flips"], 3);
    EXPECT_EQ(read("scripted"), read("end"));
}

TEST_F(Flip, RefusesTheLogOfAnotherSurface) {
    run_json({"flip", "start", "--edges", "3", "-o", "end", "--log", "log"});
    expect_unusable({"flip", "end", "--script", "log", "-o", "more"},
                    {"log: ", "another surface", "end"});
    expect_unusable({"flip", "start", "--script", "start", "-o", "more"}, {"start", "no flip log"});
    expect_unusable({"flip", "start", "--script", "lost", "-o", "more"}, {"lost"});
    EXPECT_THAT(names(), UnorderedElementsAre("start", "end", "log"));
}

TEST_F(Flip, StopsAtARefusedFlipAndWritesNothing) {
    write("sphere", samples::smallest_sphere);  // the corners opposite each edge are one vertex
    const Json json = run_json({"flip", "sphere", "--edges", "0", "-o", "end", "--log", "log"}, 1);
    EXPECT_EQ(json["complete"], false);
    EXPECT_EQ(json["flips_done"], 0);
    EXPECT_THAT(json["reason"].get<std::string>(), HasSubstr("edge 0 cannot be flipped"));
    EXPECT_FALSE(json.contains("output"));
    EXPECT_FALSE(json.contains("log"));

    const Json missing = run_json({"flip", "start", "--edges", "1,12", "-o", "end"}, 1);
    EXPECT_EQ(missing["flips_done"], 1);
    EXPECT_THAT(missing["reason"].get<std::string>(), HasSubstr("edge 12 does not exist"));
    const Outcome words = run({"flip", "start", "--edges", "12", "-o", "end"});
    EXPECT_EQ(words.exit_code, 1);
    EXPECT_THAT(words.out, HasSubstr("nothing was written"));
    EXPECT_THAT(names(), UnorderedElementsAre("start", "sphere"));
}

TEST_F(Flip, WritesBothFilesOrNeither) {
    write("end", "what was here before");
    std::filesystem::create_directory(path("directory"));
    expect_unusable({"flip", "start", "--edges", "1", "-o", "end", "--log", "missing/log"},
                    {"missing/log"});
    expect_unusable({"flip", "start", "--edges", "1", "-o", "directory", "--log", "log"},
                    {"directory: is a directory"});
    EXPECT_EQ(read("end"), "what was here before");
    EXPECT_THAT(names(), UnorderedElementsAre("start", "end", "directory"));
}

TEST_F(Flip, MayReplaceItsInput) {
    run_json({"flip", "start", "--edges", "1", "-o", "end"});
    run_json({"flip", "start", "--edges", "1", "-o", "start"});
    EXPECT_EQ(read("start"), read("end"));
    EXPECT_THAT(names(), UnorderedElementsAre("start", "end"));
}

TEST_F(Flip, TakesMeshes) {
    samples::Faces faces = samples::tetrahedron;
    write("a.off", samples::off(4, faces));
    run_json({"flip", "a.off", "--edges", "0", "-o", "end"});
    EXPECT_EQ(run_json({"check", "end"})["valid"], true);
    std::swap(faces[2][0], faces[2][1]);
    write("mixed.off", samples::off(4, faces));
    expect_unusable({"flip", "mixed.off", "--edges", "0"}, {"mixed.off", "--reorient"});
    EXPECT_EQ(run_json({"flip", "mixed.off", "--edges", "0", "--reorient"})["complete"], true);
}

TEST_F(Flip, KeepsPointsWhereThereAreSome) {
    const auto points = [&](const std::string& name) {
        const std::string text = read(name);
        return text.substr(text.find("points"));
    };
    run_json({"make", "skewed-cylinder", "--vertices", "12", "-o", "data"});
    run_json({"flip", "data", "--edges", "1,6,7", "-o", "end"});
    EXPECT_EQ(points("end"), points("data"));
    const Json measured = run_json({"measure", "end"});
    EXPECT_EQ(measured["vertices"], 12);
    EXPECT_EQ(measured["concave_edges"], 1);

    run_json({"flip", "data", "--edges", "1,6,7", "-o", "end.off"});
    EXPECT_EQ(run_json({"isomorphic", "--labelled", "end", "end.off"})["isomorphic"], true);
    EXPECT_EQ(run_json({"measure", "end.off"})["concave_edges"], 1);
}

TEST_F(Flip, WritesNothingWhereTheFormatCannotHoldTheSurface) {
    write("a.off", samples::off(4, samples::tetrahedron));
    for (const std::string name : {"end.off", "end.mesh"}) {  // with parallel edges; unknown
        expect_unusable({"flip", "a.off", "--edges", "0", "-o", name, "--log", "log"}, {name});
    }
    EXPECT_THAT(names(), UnorderedElementsAre("start", "a.off"));
}

}  // namespace
}  // namespace tightflip::tools
