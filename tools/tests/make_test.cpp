#include "command_runner.hpp"
#include "documented_keys.hpp"

namespace tightflip::tools {
namespace {

using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

class Make : public CommandTest {};

TEST_F(Make, KeysAreAsDocumented) {
    expect_as_documented("make", run_json({"make", "torus", "-o", "a"}));
}

TEST_F(Make, EveryKindIsASurface) {
    const Json about = run_json({"info"});
    ASSERT_GE(about["kinds"].size(), 5U);
    for (const Json& kind : about["kinds"]) {
        const std::string name = kind["name"];
        SCOPED_TRACE(name);
        const Json made = run_json({"make", name, "-o", name});
        EXPECT_EQ(made["file"], name);
        EXPECT_EQ(made["kind"], name);
        const Json seen = run_json({"check", name});
        EXPECT_EQ(seen["valid"], true);
        EXPECT_EQ(seen["format"], "tightflip-triangulation");
        for (const char* key : {"vertices", "edges", "faces", "genus"})
            EXPECT_EQ(made[key], seen[key]) << key;
    }
}

TEST_F(Make, EveryDataSetIsASurfaceWithPoints) {
    const Json about = run_json({"info"});
    ASSERT_GE(about["data_sets"].size(), 5U);
    for (const Json& set : about["data_sets"]) {
        const std::string name = set["name"];
        SCOPED_TRACE(name);
        for (const auto& [extension, format] :
             {std::pair{"", "tightflip-surface"}, {".ply", "ply"}, {".off", "off"}}) {
            const std::string file = name + extension;
            const Json made = run_json({"make", name, "--seed", "3", "-o", file});
            EXPECT_EQ(made["kind"], name);
            EXPECT_EQ(made["vertices"], set["default_vertices"]);
            const Json seen = run_json({"check", file});
            EXPECT_EQ(seen["valid"], true);
            EXPECT_EQ(seen["format"], format);
            for (const char* key : {"vertices", "edges", "faces", "genus"})
                EXPECT_EQ(made[key], seen[key]) << key;
        }
    }
}

TEST_F(Make, DataSetsRefuseWhatTheyCannotHave) {
    expect_unusable({"make", "twisted-prism", "--vertices", "10", "-o", "a"}, {"9, 12, 15"});
    expect_unusable({"make", "cube-grid", "--vertices", "9", "-o", "a"}, {"8, 26, 56"});
    expect_unusable({"make", "head-cap", "--genus", "1", "-o", "a"}, {"genus of a head-cap"});
    expect_unusable({"make", "ellipsoid", "-o", "a.txt"}, {"a.txt"});
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Make, KindsAreWhatTheirNamesSay) {
    struct Case {
        std::vector<std::string> request;
        int vertices;
        int edges;
        int faces;
        int genus;
    };
    const std::vector<Case> cases{{{"tetrahedron"}, 4, 6, 4, 0},
                                  {{"book", "--vertices", "3"}, 3, 3, 2, 0},
                                  {{"double-wheel", "--vertices", "6"}, 6, 12, 8, 0},
                                  {{"octasphere", "--vertices", "66"}, 66, 192, 128, 0},
                                  {{"icosphere", "--vertices", "42"}, 42, 120, 80, 0},
                                  {{"torus", "--vertices", "12"}, 12, 36, 24, 1},
                                  {{"genus", "--genus", "1"}, 3, 9, 6, 1},
                                  {{"genus", "--genus", "3", "--vertices", "20"}, 20, 72, 48, 3},
                                  {{"random", "--genus", "2", "--vertices", "9"}, 9, 33, 22, 2}};
    for (const auto& [request, vertices, edges, faces, genus] : cases) {
        SCOPED_TRACE(request.front());
        std::vector<std::string> arguments{"make"};
        arguments.insert(arguments.end(), request.begin(), request.end());
        arguments.insert(arguments.end(), {"-o", "a"});
        const Json made = run_json(arguments);
        EXPECT_EQ(made["vertices"], vertices);
        EXPECT_EQ(made["edges"], edges);
        EXPECT_EQ(made["faces"], faces);
        EXPECT_EQ(made["genus"], genus);
        EXPECT_EQ(run_json({"check", "a"})["genus"], genus);
    }
}

TEST_F(Make, TheSeedDecides) {
    for (const std::string kind : {"stacked", "genus", "random"}) {
        const auto make = [&](const std::string& seed, const std::string& file) {
            run_json({"make", kind, "--vertices", "50", "--seed", seed, "-o", file});
            return read(file);
        };
        const std::string one = make("1", "a");
        EXPECT_EQ(make("1", "b"), one) << kind;
        EXPECT_NE(make("2", "c"), one) << kind;
        EXPECT_NE(make("18446744073709551615", "d"), one) << kind;
    }
}

TEST_F(Make, ReplacesAFileAndLeavesNothingElse) {
    write("a", "something");
    EXPECT_EQ(run({"make", "book", "--output", "a"}).exit_code, 0);
    EXPECT_EQ(run_json({"check", "a"})["valid"], true);
    EXPECT_THAT(names(), UnorderedElementsAre("a"));
}

TEST_F(Make, RefusesSizesNamingThoseThereAre) {
    struct Case {
        std::string kind;
        std::string vertices;
        std::string words;
    };
    const std::vector<Case> cases{{"tetrahedron", "5", "sizes are 4"},
                                  {"book", "2", "at least 3 vertices"},
                                  {"double-wheel", "4", "at least"},
                                  {"stacked", "3", "at least 4 vertices"},
                                  {"prism", "7", "6, 8, 10"},
                                  {"antiprism", "9", "6, 8, 10"},
                                  {"octasphere", "7", "6, 18, 66"},
                                  {"icosphere", "13", "12, 42, 162"},
                                  {"torus", "10", "9, 12, 15"},
                                  {"torus", "6", "at least"},
                                  {"genus", "3", "at least 4 vertices"},
                                  {"book", "2000000000", "fewer vertices"}};
    for (const auto& [kind, vertices, words] : cases) {
        SCOPED_TRACE(kind);
        expect_unusable({"make", kind, "--vertices", vertices, "-o", "a"}, {words});
    }
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Make, RefusesWhatAKindCannotHave) {
    expect_unusable({"make", "dodecahedron", "-o", "a"}, {"'dodecahedron'", "make --help"});
    expect_unusable({"make", "torus", "--genus", "2", "-o", "a"}, {"genus of a torus", "'random'"});
    expect_unusable({"make", "genus", "--genus", "2", "--vertices", "2", "-o", "a"},
                    {"at least 3"});
    EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Make, TheHelpNamesEveryKind) {
    const std::string help = run({"make", "--help"}).out;
    const Json about = run_json({"info"});
    for (const char* list : {"kinds", "data_sets"}) {
        for (const Json& kind : about[list])
            EXPECT_THAT(help, ::testing::HasSubstr(kind["name"].get<std::string>()));
    }
}

}  // namespace
}  // namespace tightflip::tools
