#include "command_runner.hpp"
#include "documented_keys.hpp"
#include "samples.hpp"

#include <csignal>
#include <fstream>
#include <sys/stat.h>

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

const std::string without_end = "1000000000000000";  // flips: years

class Campaign : public CommandTest {
protected:
    /// Sends the signal to a campaign on two files while it reads the first, from a FIFO. By then
    /// it is under way, however slow the machine is.
    Outcome interrupted_by(int signal, std::vector<std::string> options) {
        run({"make", "torus", "-o", "torus"});
        EXPECT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
        options.insert(options.begin(), {"campaign", "fifo", "torus", "--flips", without_end});
        Running campaign(path("."), options, {});
        {
            std::ofstream fifo(path("fifo"));  // waits until the other end is opened
            fifo << read("torus");
        }
        campaign.send(signal);
        return campaign.finish();
    }
};

TEST_F(Campaign, KeysAreAsDocumented) {
    const Json json = run_json({"campaign", "--vertices", "10", "--flips", "1000"});
    expect_as_documented("campaign", json);
}

TEST_F(Campaign, CountsAddUp) {
    const Json json = run_json({"campaign", "--vertices", "10", "--flips", "1000", "--seed", "7"});
    EXPECT_EQ(json["verdict"], "holds");
    EXPECT_EQ(json["vertices"], 10);
    EXPECT_EQ(json["genus"], 0);
    EXPECT_EQ(json["seed"], 7);
    EXPECT_EQ(json["violations"], 0);
    EXPECT_EQ(json["flips_attempted"], 1000);
    EXPECT_GT(json["flips_done"], 0);
    EXPECT_GT(json["refused"], 0);
    EXPECT_EQ(json["flips_done"].get<int>() + json["refused"].get<int>(), 1000);
    const Outcome words = run({"campaign", "--vertices", "10", "--flips", "1000"});
    EXPECT_EQ(words.exit_code, 0);
    EXPECT_EQ(words.err, "");
    EXPECT_THAT(words.out, HasSubstr("holds"));
    EXPECT_THAT(words.out, HasSubstr("1000 flips attempted"));
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Campaign, TheSeedDecides) {
    const auto counts = [&](const std::string& seed) {
        Json json = run_json(
            {"campaign", "--vertices", "30", "--genus", "1", "--flips", "20000", "--seed", seed});
        json.erase("seconds");
        json.erase("flips_per_second");
        return json;
    };
    const Json one = counts("1");
    EXPECT_EQ(counts("1"), one);
    EXPECT_NE(counts("2")["flips_done"], one["flips_done"]);
}

TEST_F(Campaign, AuditsAsOftenAsAsked) {
    const auto audits = [&](const std::string& every) {
        return run_json({"campaign", "--vertices", "10", "--flips", "100", "--audit-every",
                         every})["audits"]
            .get<int>();
    };
    EXPECT_EQ(audits("1"), 101);  // and one at the start
    EXPECT_EQ(audits("30"), 5);   // at the start, after 30, 60 and 90, at the end
}

TEST_F(Campaign, WorksOnFilesAndEveryKind) {
    run({"make", "torus", "-o", "torus"});
    write("a.off", samples::off(4, samples::tetrahedron));
    const Outcome outcome = run({"campaign", "torus", "a.off", "--flips", "1000", "--json"});
    EXPECT_EQ(outcome.exit_code, 0);
    const auto objects = outcome.objects();
    ASSERT_EQ(objects.size(), 2U);
    EXPECT_EQ(objects[0]["file"], "torus");
    EXPECT_EQ(objects[0]["genus"], 1);
    EXPECT_EQ(objects[1]["file"], "a.off");
    EXPECT_EQ(objects[1]["vertices"], 4);
    const Json about = run_json({"info"});
    for (const Json& kind : about["kinds"]) {
        const Json json = run_json({"campaign", "--kind", kind["name"], "--flips", "1000"});
        EXPECT_EQ(json["verdict"], "holds") << kind;
        EXPECT_LE(json["vertices"], 1000) << kind;
    }
}

TEST_F(Campaign, GenusThreeHolds) {
    const Json json =
        run_json({"campaign", "--genus", "3", "--vertices", "40", "--flips", "50000"});
    EXPECT_EQ(json["verdict"], "holds");
    EXPECT_EQ(json["genus"], 3);
    EXPECT_GT(json["flips_done"], 0);
}

TEST_F(Campaign, OnTheTorusOfThreeVerticesEveryFlipIsRefused) {
    const Json json = run_json({"campaign", "--genus", "1", "--vertices", "3", "--flips", "500"});
    EXPECT_EQ(json["verdict"], "holds");
    EXPECT_EQ(json["flips_done"], 0);
    EXPECT_EQ(json["refused"], 500);
}

TEST_F(Campaign, RefusesWhatIsNoSurface) {
    const samples::Faces three = samples::with(samples::tetrahedron, {{0, 1, 4}});
    write("three.off", samples::off(5, three));
    expect_unusable({"campaign", "three.off"}, {"three.off:8: face 0, side 2", "tightflip check"});
    samples::Faces mixed = samples::tetrahedron;
    std::swap(mixed[2][0], mixed[2][1]);
    write("mixed.off", samples::off(4, mixed));
    expect_unusable({"campaign", "mixed.off"}, {"mixed.off", "--reorient"});
    EXPECT_EQ(run_json({"campaign", "mixed.off", "--reorient", "--flips", "100"})["verdict"],
              "holds");
    const Outcome both =
        run({"campaign", "--json", "three.off", "mixed.off", "--reorient", "--flips", "100"});
    EXPECT_EQ(both.exit_code, 2);
    EXPECT_EQ(both.objects().size(), 2U);
    EXPECT_THAT(names(), UnorderedElementsAre("three.off", "mixed.off"));
}

TEST_F(Campaign, RefusesWhatCannotBeMade) {
    expect_unusable({"campaign", "--kind", "cube"}, {"'cube'", "make --help"});
    expect_unusable({"campaign", "--kind", "torus", "--genus", "2"}, {"genus of a torus"});
    expect_unusable({"campaign", "--kind", "octasphere", "--vertices", "7"}, {"6, 18, 66"});
    expect_unusable({"campaign", "--vertices", "3"}, {"at least 4 vertices"});
}

TEST_F(Campaign, ATimeLimitLeavesItUndecided) {
    const Json json = run_json({"campaign", "--flips", without_end, "--time", "0.2"}, 3);
    expect_as_documented("campaign", json);
    EXPECT_EQ(json["verdict"], "undecided");
    EXPECT_EQ(json["violations"], 0);
    EXPECT_GT(json["flips_attempted"], 0);
    EXPECT_GE(json["seconds"], 0.2);
    const Outcome words = run({"campaign", "--flips", without_end, "--time", "0"});
    EXPECT_EQ(words.exit_code, 3);
    EXPECT_THAT(words.out, HasSubstr("undecided"));
    run({"make", "torus", "-o", "torus"});
    EXPECT_EQ(run({"campaign", "torus", "lost", "--time", "0"}).exit_code, 2);
}

TEST_F(Campaign, AnInterruptLeavesItUndecidedAndEveryInputIsTold) {
    for (const int signal : {SIGINT, SIGTERM}) {
        SCOPED_TRACE(signal);
        const Outcome outcome = interrupted_by(signal, {"--json"});
        EXPECT_EQ(outcome.signal, 0);
        EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
        const auto objects = outcome.objects();
        ASSERT_EQ(objects.size(), 2U);
        EXPECT_EQ(objects[0]["file"], "fifo");
        EXPECT_EQ(objects[1]["file"], "torus");
        for (const Json& json : objects)
            EXPECT_EQ(json["verdict"], "undecided");
        std::filesystem::remove(path("fifo"));
    }
}

// ---- what a violation looks like: the command with a flip broken on purpose ----

class BrokenCampaign : public CommandTest {
protected:
    [[nodiscard]] Outcome run_broken(std::vector<std::string> arguments) const {
        return run(std::move(arguments), {.executable = TIGHTFLIP_BROKEN_COMMAND});
    }
};

TEST_F(BrokenCampaign, StopsAndWritesALogThatShowsTheViolationAgain) {
    const Outcome outcome =
        run_broken({"campaign", "--json", "--vertices", "20", "--log", "bad.log"});
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    const Json json = outcome.object();
    expect_as_documented("campaign", json);
    EXPECT_EQ(json["verdict"], "violated");
    EXPECT_EQ(json["violations"], 1);
    EXPECT_EQ(json["log"], "bad.log");
    const Json& failure = json["failure"];
    EXPECT_EQ(failure["attempt"], json["flips_attempted"]);
    EXPECT_LE(failure["log_flips"], 4);
    EXPECT_LE(failure["log_vertices"], 20);

    const Outcome again = run_broken({"replay", "--json", "bad.log", "-o", "end"});
    EXPECT_EQ(again.exit_code, 1);
    const Json replayed = again.object();
    expect_as_documented("replay", replayed);
    EXPECT_EQ(replayed["verdict"], "violated");
    EXPECT_EQ(replayed["step"], failure["log_flips"]);
    ASSERT_EQ(replayed["violations"].size(), 1U);
    EXPECT_EQ(replayed["violations"][0], failure["log_violation"]);
    EXPECT_THAT(names(), UnorderedElementsAre("bad.log"));
    // The command that is not broken finds nothing in the same log.
    EXPECT_EQ(run_json({"replay", "bad.log"})["verdict"], "holds");
}

TEST_F(BrokenCampaign, SaysItInWords) {
    const Outcome outcome = run_broken({"campaign", "--vertices", "20"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.out, HasSubstr("violated"));
    EXPECT_THAT(outcome.out, HasSubstr("violation after attempt"));
    EXPECT_THAT(outcome.out, HasSubstr("tightflip replay tightflip-violation.log"));
    EXPECT_THAT(names(), UnorderedElementsAre("tightflip-violation.log"));
}

TEST_F(BrokenCampaign, EveryInputHasALogOfItsOwn) {
    run({"make", "torus", "-o", "torus"});
    run({"make", "octasphere", "-o", "sphere"});
    const Outcome outcome =
        run_broken({"campaign", "--json", "torus", "sphere", "--log", "bad.log"});
    EXPECT_EQ(outcome.exit_code, 1);
    const auto objects = outcome.objects();
    ASSERT_EQ(objects.size(), 2U);
    for (const Json& json : objects) {
        const Outcome again = run_broken({"replay", "--json", json["log"]});
        EXPECT_EQ(again.exit_code, 1);
        EXPECT_EQ(again.object()["genus"], json["genus"]);
    }
    EXPECT_NE(objects[0]["log"], objects[1]["log"]);
}

TEST_F(BrokenCampaign, AViolationIsToldEvenWhereItsLogCannotBeWritten) {
    const Outcome outcome =
        run_broken({"campaign", "--json", "--vertices", "20", "--log", "missing/bad.log"});
    EXPECT_EQ(outcome.exit_code, 2);
    const Json json = outcome.object();
    expect_as_documented("campaign", json);
    EXPECT_EQ(json["verdict"], "violated");
    EXPECT_THAT(json["error"].get<std::string>(), HasSubstr("missing/bad.log"));
    EXPECT_THAT(outcome.err, HasSubstr("missing/bad.log"));
}

}  // namespace
}  // namespace tightflip::tools
