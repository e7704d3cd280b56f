#include "command_runner.hpp"
#include "samples.hpp"

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Arguments = std::vector<std::string>;

class Usage : public CommandTest {};

TEST_F(Usage, HelpAndVersionAreNoErrors) {
    const Outcome help = run({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.err, "");
    EXPECT_THAT(help.out, HasSubstr("Exit codes"));
    for (const std::string verb :
         {"make", "check", "campaign", "flip", "replay", "explore", "path", "verify", "canonical",
          "isomorphic", "convert", "measure", "render", "optimise", "hull", "info"}) {
        EXPECT_THAT(help.out, HasSubstr("\n  " + verb + " "));
        const Outcome of_verb = run({verb, "--help"});
        EXPECT_EQ(of_verb.exit_code, 0) << verb;
        EXPECT_THAT(of_verb.out, HasSubstr(verb + " [OPTIONS]"));
        EXPECT_THAT(of_verb.out, HasSubstr("Exit codes"));
    }
    const Outcome version = run({"--version"});
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_EQ(version.out, "tightflip " + run_json({"info"})["version"].get<std::string>() + "\n");
}

TEST_F(Usage, WrongUsageIsExplainedOnStandardErrorAlone) {
    struct Case {
        Arguments arguments;
        Arguments words;
    };
    const std::vector<Case> cases{
        {{}, {"A verb is required", "--help"}},
        {{"polish"}, {"polish"}},
        {{"check"}, {"FILE"}},
        {{"check", "a", "--colour"}, {"--colour"}},
        {{"make"}, {"KIND"}},
        {{"make", "book"}, {"--output"}},
        {{"flip"}, {"FILE"}},
        {{"flip", "a"}, {"--script", "--edges", "--random"}},
        {{"flip", "a", "--edges", "1", "--random", "3"}, {"--random"}},
        {{"flip", "a", "--edges", "1", "--seed", "3"}, {"--seed", "--random"}},
        {{"flip", "a", "--edges", "1", "--simple"}, {"--simple", "--random"}},
        {{"flip", "a", "--random", "0"}, {"--random"}},
        {{"flip", "a", "--edges", "1", "--script", "b"}, {"--script"}},
        {{"flip", "a", "--edges", "1", "-o", "b", "--log", "b"}, {"--log"}},
        {{"measure"}, {"FILE"}},
        {{"measure", "a", "b", "--ply", "c"}, {"FILE", "must be one"}},
        {{"measure", "a", "--ply", "c", "--edges-csv", "c"}, {"--ply", "--edges-csv"}},
        {{"render", "a"}, {"--output"}},
        {{"render", "a", "-o", "a.gif"}, {"a.gif", ".svg", ".png"}},
        {{"render", "a", "-o", "svg"}, {".svg"}},
        {{"render", "a", "-o", "a.svg", "--style", "toon"}, {"--style", "wireframe"}},
        {{"render", "a", "-o", "a.svg", "--colour", "pink"}, {"--colour", "curvature"}},
        {{"replay"}, {"LOG"}},
        {{"campaign", "a", "--vertices", "9"}, {"--vertices", "FILE"}}};
    for (const auto& [arguments, words] : cases) {
        SCOPED_TRACE(::testing::PrintToString(arguments));
        expect_wrong_usage(arguments, words);
    }
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Usage, NumbersMustBeNumbersInTheirRange) {
    const std::vector<std::pair<Arguments, Arguments>> options{
        {{"campaign", "--flips"}, {"-5", "1e6", "ten", "1.5", "99999999999999999999"}},
        {{"campaign", "--seed"}, {"-1", "x"}},
        {{"campaign", "--vertices"}, {"-4", "0", "99999999999"}},
        {{"campaign", "--genus"}, {"-1", "99999999999"}},
        {{"campaign", "--audit-every"}, {"-1", "0"}},
        {{"campaign", "--time"}, {"-1", "nan", "inf", "soon"}},
        {{"make", "genus", "-o", "a", "--vertices"}, {"-4", "99999999999", "many"}},
        {{"make", "genus", "-o", "a", "--genus"}, {"-1", "one"}},
        {{"make", "random", "-o", "a", "--seed"}, {"-1"}},
        {{"flip", "a", "--edges"}, {"-1", "1,x", "1,-2", "99999999999"}},
        {{"render", "a", "-o", "a.svg", "--view"},
         {"30", "30,", ",20", "30,91", "30,20,1", "nan,0", "inf,0", "x,y", "30;20"}},
        {{"render", "a", "-o", "a.svg", "--size"}, {"99", "10001", "big", "-5"}},
        {{"replay", "a", "--audit-every"}, {"-1", "0"}}};
    for (const auto& [arguments, values] : options) {
        for (const std::string& value : values) {
            SCOPED_TRACE(::testing::PrintToString(arguments) + " " + value);
            Arguments all = arguments;
            all.push_back(value);
            expect_wrong_usage(all, {arguments.back()});
        }
    }
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Usage, JsonMayStandBeforeOrAfterTheVerb) {
    write("a", samples::smallest_sphere);
    const Outcome before = run({"--json", "check", "a"});
    EXPECT_EQ(before.object()["valid"], true);
    EXPECT_EQ(run({"check", "--json", "a"}).out, before.out);
    EXPECT_EQ(run({"check", "a", "--json"}).out, before.out);
}

}  // namespace
}  // namespace tightflip::tools
