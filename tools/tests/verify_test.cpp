#include "command_runner.hpp"
#include "documented_keys.hpp"
#include "samples.hpp"

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

/// Two surfaces, A and B, and a log between them.
class Verify : public CommandTest {
protected:
    Verify() {
        run({"make", "octasphere", "-o", "A"});
        run({"flip", "A", "--edges", "3,7,3,11", "-o", "B", "--log", "log"});
    }

    /// Refused with exit code 2, a message, and an object that says why.
    void expect_refused(const std::vector<std::string>& arguments, const std::string& fault,
                        const std::vector<std::string>& words) {
        std::vector<std::string> all{"verify", "--json"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Outcome outcome = run(all);
        EXPECT_EQ(outcome.exit_code, 2);
        const Json json = outcome.object();
        expect_as_documented("verify", json);
        EXPECT_EQ(json["verdict"], "refused");
        EXPECT_EQ(json["fault"], fault);
        for (const std::string& word : words) {
            EXPECT_THAT(json["reason"].get<std::string>(), HasSubstr(word));
            EXPECT_THAT(outcome.err, HasSubstr(word));
        }
        all.erase(all.begin() + 1);
        const Outcome in_words = run(all);
        EXPECT_EQ(in_words.exit_code, 2);
        EXPECT_EQ(in_words.out, "");
        EXPECT_EQ(in_words.err, outcome.err);
    }
};

TEST_F(Verify, HoldsForALogThatLeadsFromTheOneToTheOther) {
    const Json json = run_json({"verify", "A", "B", "log"});
    expect_as_documented("verify", json);
    EXPECT_EQ(json["verdict"], "holds");
    EXPECT_EQ(json["from"], "A");
    EXPECT_EQ(json["to"], "B");
    EXPECT_EQ(json["log"], "log");
    EXPECT_EQ(json["vertices"], 6);
    EXPECT_EQ(json["flips"], 4);
    EXPECT_EQ(json["flips_done"], 4);
    const Outcome in_words = run({"verify", "A", "B", "log"});
    EXPECT_EQ(in_words.exit_code, 0);
    EXPECT_THAT(in_words.out, HasSubstr("log: holds: 4 flips lead from A to B"));
    EXPECT_EQ(in_words.err, "");
    EXPECT_THAT(names(), UnorderedElementsAre("A", "B", "log"));
}

TEST_F(Verify, TakesEveryFormOfASurfaceAndALog) {
    write("mesh.off", samples::off(4, samples::tetrahedron));
    run({"flip", "mesh.off", "--edges", "0", "-o", "end", "--log", "mesh.log"});
    EXPECT_EQ(run_json({"verify", "mesh.off", "end", "mesh.log"})["flips"], 1);
    run({"make", "random", "--vertices", "40", "--seed", "1", "-o", "from"});
    run({"make", "random", "--vertices", "40", "--seed", "2", "-o", "to"});
    EXPECT_EQ(run({"path", "from", "to", "--binary", "-o", "binary"}).exit_code, 0);
    EXPECT_EQ(run_json({"verify", "from", "to", "binary"})["verdict"], "holds");
}

TEST_F(Verify, RefusesLogsThatDoNotLeadThere) {
    expect_refused({"B", "A", "log"}, "log_starts_elsewhere", {"vertex 0 has degree"});
    expect_refused({"A", "A", "log"}, "log_ends_elsewhere", {"after all 4 flips"});
    run({"make", "book", "--vertices", "6", "-o", "book"});
    run({"make", "octasphere", "--vertices", "18", "-o", "large"});
    expect_refused({"A", "large", "log"}, "ends_differ", {"6 vertices", "18 vertices"});
    run({"make", "random", "--vertices", "6", "--genus", "1", "-o", "torus"});
    expect_refused({"torus", "A", "log"}, "ends_differ", {"genus 1", "genus 0"});
}

TEST_F(Verify, NamesTheFirstBadFlip) {
    // Three vertices: no flip is defined. The tool itself would not write such a log.
    write("sphere", samples::smallest_sphere);
    run({"flip", "sphere", "--edges", "1", "-o", "end", "--log", "refused"});
    const Outcome path = run({"path", "sphere", "sphere", "-o", "empty"});
    ASSERT_EQ(path.exit_code, 0);
    EXPECT_EQ(run_json({"verify", "sphere", "sphere", "empty"})["flips"], 0);
    const std::string text =
        "tightflip-flip-log 1\nvertices 3\nhalfedges 6\n# next halfedge and origin of halfedge 0, "
        "1, 2, ...\n2 0\n5 1\n4 1\n1 2\n0 2\n3 0\nflips 1\n1\ncheck ";
    write("log", text + "d3bdca1b130e9440\n");
    write(
        "table",
        "tightflip-triangulation 1\nvertices 3\nhalfedges 6\n2 0\n5 1\n4 1\n1 2\n0 2\n3 0\nend\n");
    expect_refused({"table", "table", "log"}, "flip_not_defined", {"flip 1 of 1, edge 1", "loop"});
}

TEST_F(Verify, RefusesALogThatIsNotSpelledAsItWasWritten) {
    const std::string text = read("log");
    for (const std::string& spelling :
         {text + "\n", "tightflip-flip-log 1\n# a remark" + text.substr(20), text + "# the end",
          text.substr(0, text.size() - 1)}) {
        write("log", spelling);
        EXPECT_EQ(run({"replay", "log"}).exit_code, 0);
        expect_unusable({"verify", "A", "B", "log"}, {"log:", "every byte counts"});
    }
}

TEST_F(Verify, RefusesWhatCannotBeRead) {
    expect_unusable({"verify", "A", "missing", "log"}, {"missing: cannot be opened"});
    expect_unusable({"verify", "A", "B", "A"}, {"A: byte 0: this is no flip log"});
    expect_unusable({"verify", "log", "B", "log"}, {"log: this is a flip log, not a surface"});
    const Outcome all = run({"verify", "--json", "x", "y", "z"});
    EXPECT_EQ(all.exit_code, 2);
    ASSERT_EQ(all.objects().size(), 3U);
    EXPECT_EQ(all.objects()[1]["file"], "y");
    expect_wrong_usage({"verify", "A", "B"}, {"LOG"});
    std::string broken = read("A");
    const std::size_t table = broken.find("...\n") + 4;
    broken.replace(table, broken.find('\n', table) - table, "99 0");
    write("broken", broken);
    expect_refused({"broken", "B", "log"}, "from_is_no_surface", {"halfedge 0"});
    expect_refused({"A", "broken", "log"}, "to_is_no_surface", {"halfedge 0"});
}

}  // namespace
}  // namespace tightflip::tools
