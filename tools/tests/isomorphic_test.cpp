#include "command_runner.hpp"
#include "documented_keys.hpp"
#include "samples.hpp"

#include <numeric>

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;
using Arguments = std::vector<std::string>;

/// A sphere with eight vertices and no symmetries, reversals included.
const samples::Faces chiral{{5, 4, 2}, {4, 5, 7}, {4, 6, 2}, {6, 4, 3}, {6, 5, 0}, {5, 6, 1},
                            {7, 5, 1}, {4, 7, 3}, {7, 6, 3}, {6, 7, 1}, {5, 2, 0}, {2, 6, 0}};

samples::Faces with_labels(samples::Faces faces, const std::vector<int>& label) {
    for (auto& face : faces) {
        for (int& corner : face)
            corner = label[static_cast<std::size_t>(corner)];
    }
    return faces;
}
samples::Faces turned_over(samples::Faces faces) {
    for (auto& face : faces)
        std::swap(face[1], face[2]);
    return faces;
}

class Isomorphic : public CommandTest {
protected:
    Isomorphic() {
        write("a.off", samples::off(8, chiral));
        write("relabelled.off", samples::off(8, with_labels(chiral, label)));
        write("mirrored.off", samples::off(8, turned_over(chiral)));
        write("both.off", samples::off(8, turned_over(with_labels(chiral, label))));
    }
    Json compare(const std::string& a, const std::string& b, const Arguments& options,
                 int exit_code) const {
        Arguments arguments{"isomorphic", a, b};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return run_json(arguments, exit_code);
    }

    const std::vector<int> label{3, 5, 0, 6, 1, 2, 7, 4};
};

TEST_F(Isomorphic, KeysAreAsDocumented) {
    expect_as_documented("isomorphic", compare("a.off", "relabelled.off", {}, 0));
    expect_as_documented("isomorphic", compare("a.off", "mirrored.off", {}, 1));
}

TEST_F(Isomorphic, FindsTheMapOfVertices) {
    const Json json = compare("a.off", "relabelled.off", {}, 0);
    EXPECT_EQ(json["from"], "a.off");
    EXPECT_EQ(json["to"], "relabelled.off");
    EXPECT_EQ(json["isomorphic"], true);
    EXPECT_EQ(json["mirrored"], false);
    EXPECT_EQ(json["vertex_map"], Json(label)) << "the surface has no symmetries";
    EXPECT_FALSE(json.contains("reason"));
    const Json mirrored = compare("a.off", "both.off", {"--mirror"}, 0);
    EXPECT_EQ(mirrored["mirrored"], true);
    EXPECT_EQ(mirrored["vertex_map"], Json(label));
    EXPECT_EQ(compare("a.off", "mirrored.off", {"--mirror", "--labelled"}, 0)["vertex_map"],
              Json({0, 1, 2, 3, 4, 5, 6, 7}));

    const Outcome words = run({"isomorphic", "a.off", "relabelled.off"});
    EXPECT_EQ(words.exit_code, 0);
    EXPECT_THAT(words.out, HasSubstr("a.off and relabelled.off are isomorphic"));
    EXPECT_THAT(words.out, HasSubstr(" 0>3 1>5 2>0 3>6 4>1 5>2 6>7 7>4"));
    EXPECT_THAT(run({"isomorphic", "a.off", "mirrored.off", "--mirror"}).out,
                HasSubstr("mirror image"));
}

TEST_F(Isomorphic, SaysWhyNot) {
    run_json({"make", "book", "--vertices", "7", "-o", "book7"});
    run_json({"make", "book", "--vertices", "8", "-o", "book8"});
    run_json({"make", "random", "--vertices", "8", "--genus", "1", "-o", "torus"});
    run_json({"make", "stacked", "--vertices", "9", "--seed", "6", "-o", "nine"});
    run_json({"make", "stacked", "--vertices", "9", "--seed", "7", "-o", "other9"});
    struct Case {
        std::string a;
        std::string b;
        Arguments options;
        std::string difference;
        std::string words;
    };
    const std::vector<Case> cases{
        {"book7", "book8", {}, "vertices", "7 vertices"},
        {"book8", "torus", {}, "genus", "genus 0"},
        {"book8", "a.off", {}, "degrees", "degrees"},
        {"nine", "other9", {"--mirror"}, "gluing", "glued"},
        {"nine", "other9", {"--labelled"}, "gluing", "glued"},
        {"a.off", "mirrored.off", {}, "orientation", "--mirror"},
        {"a.off", "mirrored.off", {"--labelled"}, "orientation", "--mirror"},
        {"a.off", "relabelled.off", {"--labelled"}, "labels", "labels"},
        {"a.off", "relabelled.off", {"--labelled", "--mirror"}, "labels", "labels"},
        {"a.off", "both.off", {"--labelled"}, "labels_and_orientation", "but for labels"},
        {"a.off", "both.off", {}, "orientation", "mirror image"}};
    for (const auto& [a, b, options, difference, words] : cases) {
        SCOPED_TRACE(::testing::PrintToString(Arguments{a, b}) + ::testing::PrintToString(options));
        const Json json = compare(a, b, options, 1);
        EXPECT_EQ(json["isomorphic"], false);
        EXPECT_EQ(json["difference"], difference);
        EXPECT_THAT(json["reason"].get<std::string>(), HasSubstr(words));
        EXPECT_FALSE(json.contains("vertex_map"));
        Arguments arguments{"isomorphic", a, b};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_THAT(outcome.out, HasSubstr("not isomorphic: " + json["reason"].get<std::string>()));
    }
}

TEST_F(Isomorphic, ShowsTheMapOfLargeSurfacesInJsonAlone) {
    run_json({"make", "stacked", "--vertices", "101", "-o", "large"});
    EXPECT_THAT(run({"isomorphic", "large", "large"}).out, HasSubstr("--json"));
    std::vector<int> identity(101);
    std::iota(identity.begin(), identity.end(), 0);
    EXPECT_EQ(compare("large", "large", {"--labelled"}, 0)["vertex_map"], Json(identity));
}

TEST_F(Isomorphic, RefusesWhatIsNoSurface) {
    write("open.off", samples::off(3, {{0, 1, 2}}));
    expect_unusable({"isomorphic", "a.off", "open.off"}, {"open.off:6: face 0, side 0"});
    expect_unusable({"isomorphic", "none", "a.off"}, {"none"});
    expect_wrong_usage({"isomorphic", "a.off"}, {"B"});
    const Outcome neither = run({"isomorphic", "--json", "none", "open.off"});
    EXPECT_EQ(neither.exit_code, 2);
    EXPECT_EQ(neither.objects().size(), 2U) << "each unusable input is named";
}

}  // namespace
}  // namespace tightflip::tools
