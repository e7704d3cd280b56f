#include "command_runner.hpp"
#include "documented_keys.hpp"
#include "samples.hpp"

#include <filesystem>

namespace tightflip::tools {
namespace {

using ::testing::HasSubstr;

using ::testing::Not;
using ::testing::UnorderedElementsAre;

class Convert : public CommandTest {
protected:
    /// The tetrahedron without its last face, with a vertex that no face has.
    static std::string open_tetrahedron() {
        samples::Faces faces = samples::tetrahedron;
        faces.pop_back();
        return samples::off(5, faces);
    }
    /// The sphere with 3 edges between vertices 0 and 1, and a point for each vertex.
    void write_book(const std::string& name) const {
        run_json({"make", "book", "--vertices", "5", "-o", name});
        std::string text = read(name);
        text.replace(0, text.find('\n'), "tightflip-surface 1");
        text.replace(text.rfind("end"), 3,
                     "points 5\n0 0 1\n0 0 -1\n1 0 0\n0 1 0.1\n-1 -0 1e-320\nend");
        write(name, text);
    }
};

TEST_F(Convert, KnowsEveryFormatByTheNameOfTheOutput) {
    write("a.off", samples::off(4, samples::tetrahedron));
    for (const auto& [name, format] :
         std::vector<std::pair<std::string, std::string>>{{"b.obj", "obj"},
                                                          {"b.OFF", "off"},
                                                          {"b.ply", "ply"},
                                                          {"b.stl", "stl"},
                                                          {"b.tfs", "tightflip-surface"},
                                                          {"b", "tightflip-surface"}}) {
        SCOPED_TRACE(name);
        const Json json = run_json({"convert", "a.off", "-o", name});
        expect_as_documented("convert", json);
        EXPECT_EQ(json["file"], "a.off");
        EXPECT_EQ(json["format"], "off");
        EXPECT_EQ(json["output"], name);
        EXPECT_EQ(json["output_format"], format);
        EXPECT_EQ(json["vertices"], 4);
        EXPECT_EQ(json["edges"], 6);
        EXPECT_EQ(json["faces"], 4);
        EXPECT_EQ(json["genus"], 0);
        EXPECT_FALSE(json.contains("repairs"));
        const Json checked = run_json({"check", name});
        EXPECT_EQ(checked["format"], format);
        EXPECT_EQ(checked["valid"], true);
    }
}

TEST_F(Convert, GoesRoundThroughEveryLosslessFormat) {
    write_book("book");
    const std::string original = read("book");
    run_json({"convert", "book", "-o", "copy"});
    const std::string first = read("copy");  // numbers in their shortest form
    run_json({"convert", "copy", "-o", "again"});
    EXPECT_EQ(read("again"), first);
    run_json({"convert", "copy", "-o", "a.ply"});
    run_json({"convert", "a.ply", "-o", "b.ply", "--ascii"});
    run_json({"convert", "b.ply", "-o", "c.ply"});
    EXPECT_THAT(read("b.ply"), HasSubstr("glued_sides"));
    EXPECT_THAT(read("b.ply"), HasSubstr("\n-1 -0 1e-320\n"));
    for (const std::string name : {"a.ply", "b.ply", "c.ply", "copy"}) {
        EXPECT_EQ(run_json({"isomorphic", "--labelled", "book", name})["isomorphic"], true);
    }
    EXPECT_EQ(read("book"), original);
}

TEST_F(Convert, EveryVerbTakesWhatItWrote) {
    write_book("book.tfs");
    run_json({"convert", "book.tfs", "-o", "book.ply"});
    for (const std::string file : {"book.tfs", "book.ply"}) {
        SCOPED_TRACE(file);
        EXPECT_EQ(run_json({"info", file})["parallel_edges"]["max_multiplicity"], 3);
        EXPECT_EQ(run_json({"campaign", file, "--flips", "50"})["violations"], 0);
        run_json({"flip", file, "--edges", "0", "-o", "flipped", "--log", "log"});
        EXPECT_EQ(run_json({"verify", file, "flipped", "log"})["verdict"], "holds");
        EXPECT_EQ(run_json({"canonical", file})["vertices"], 5);
        EXPECT_EQ(run_json({"path", file, "flipped", "-o", "path"})["verdict"], "found");
    }
}

TEST_F(Convert, RefusesWhatAFormatCannotSayAndLeavesTheOutputAlone) {
    write_book("book");
    for (const std::string name : {"b.obj", "b.off", "b.stl"}) {
        write(name, "what was here before");
        expect_unusable({"convert", "book", "-o", name},
                        {name, "vertices 0 and 1", "write PLY or tightflip-surface"});
        EXPECT_EQ(read(name), "what was here before");
    }
    expect_unusable({"convert", "book", "-o", "b.mesh"}, {"b.mesh", "--format"});
    expect_unusable({"convert", "book", "-o", "missing/b"}, {"missing/b"});
    run_json({"make", "book", "--vertices", "5", "-o", "table"});
    expect_unusable({"convert", "table", "-o", "b.ply"}, {"table", "no coordinates"});
    EXPECT_THAT(names(), UnorderedElementsAre("book", "table", "b.obj", "b.off", "b.stl"));
}

TEST_F(Convert, NothingIsLostWhereTheDiskIsFull) {
    write("a.off", samples::off(4, samples::tetrahedron));
    run_json({"convert", "a.off", "-o", "a.ply", "--ascii"});
    const std::string before = read("a.ply");
    expect_unusable({"convert", "a.ply", "-o", "a.ply"}, {"a.ply", "writing failed"},
                    {.most_bytes_a_file = 100});
    EXPECT_EQ(read("a.ply"), before);
    EXPECT_THAT(names(), UnorderedElementsAre("a.off", "a.ply"));
    run_json({"convert", "a.ply", "-o", "a.ply"});
    EXPECT_NE(read("a.ply"), before);
    EXPECT_EQ(run_json({"check", "a.ply"})["valid"], true);
}

TEST_F(Convert, TheFormatMayBeNamed) {
    write("a.off", samples::off(4, samples::tetrahedron));
    EXPECT_EQ(run_json({"convert", "a.off", "-o", "b", "--format", "obj"})["output_format"], "obj");
    EXPECT_THAT(read("b"), HasSubstr("\nf "));
    const Json json =
        run_json({"convert", "a.off", "-o", "b", "--format", "tightflip-triangulation"});
    EXPECT_EQ(json["output_format"], "tightflip-triangulation");
    EXPECT_TRUE(read("b").starts_with("tightflip-triangulation 1\n"));
    expect_wrong_usage({"convert", "a.off", "-o", "b", "--format", "mesh"}, {"--format"});
    expect_wrong_usage({"convert", "a.off"}, {"--output"});
    expect_wrong_usage({"convert", "-o", "b"}, {"FILE"});
}

TEST_F(Convert, SaysWhatIsLost) {
    write("a.off", samples::off(4, samples::tetrahedron));
    EXPECT_THAT(run({"convert", "a.off", "-o", "b.stl"}).out, HasSubstr("rounded to float"));
    EXPECT_THAT(run({"convert", "a.off", "-o", "b.stl", "--ascii"}).out,
                Not(HasSubstr("rounded to float")));
    EXPECT_THAT(run({"convert", "a.off", "-o", "b.obj"}).out, HasSubstr("edge numbers"));
    EXPECT_THAT(run({"convert", "a.off", "-o", "b"}).out, Not(HasSubstr("not kept")));
}

TEST_F(Convert, MendsOnlyWhatItIsAskedTo) {
    write("a.off", open_tetrahedron());
    expect_unusable({"convert", "a.off", "-o", "b"}, {"a.off:", "--fill-holes"});
    expect_unusable({"convert", "a.off", "-o", "b", "--fill-holes"}, {"a.off:", "--drop-unused"});
    EXPECT_THAT(names(), UnorderedElementsAre("a.off"));
    const Json json = run_json({"convert", "a.off", "-o", "b", "--fill-holes", "--drop-unused"});
    expect_as_documented("convert", json);
    EXPECT_EQ(json["vertices"], 5);
    EXPECT_EQ(json["faces"], 6);
    EXPECT_EQ(json["repairs"]["holes_filled"], 1);
    EXPECT_EQ(json["repairs"]["faces_added"], 3);
    EXPECT_EQ(json["repairs"]["vertices_unused"], 1);
    EXPECT_EQ(json["repairs"]["points_welded"], 0);
    EXPECT_EQ(run_json({"convert", "a.off", "-o", "b", "--repair"})["repairs"], json["repairs"]);
    const Outcome words = run({"convert", "a.off", "-o", "b", "--repair"});
    EXPECT_THAT(words.out, HasSubstr("repair: 1 hole filled\n"));
    EXPECT_THAT(words.out, HasSubstr("repair: 1 vertex dropped that no face has\n"));
}

TEST_F(Convert, WeldsEqualPointsOrThoseWithinADistance) {
    const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 5\n";
    write("equal.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 1\n" + faces);
    write("near.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 1.001\n" + faces);
    expect_unusable({"convert", "equal.obj", "-o", "b"}, {"equal.obj:", "--weld"});
    // The file's name is not taken for the distance.
    EXPECT_EQ(run_json({"convert", "--weld", "equal.obj", "-o", "b"})["repairs"]["points_welded"],
              1);
    expect_unusable({"convert", "--weld", "near.obj", "-o", "b"}, {"near.obj:"});
    expect_unusable({"convert", "--weld=0.0005", "near.obj", "-o", "b"}, {"near.obj:"});
    EXPECT_EQ(run_json({"convert", "--weld=0.01", "near.obj", "-o", "b"})["vertices"], 4);
    EXPECT_EQ(run_json({"convert", "--repair", "--weld=0.01", "near.obj", "-o", "b"})["vertices"],
              4);
    for (const std::string distance : {"-1", "nan", "inf", "near", "0.1x"}) {
        expect_wrong_usage({"convert", "--weld=" + distance, "near.obj", "-o", "b"}, {"--weld"});
    }
}

TEST_F(Convert, CheckAndInfoMendAlike) {
    write("a.off", open_tetrahedron());
    EXPECT_EQ(run_json({"check", "a.off"}, 1)["valid"], false);
    const Json checked = run_json({"check", "a.off", "--repair"});
    expect_as_documented("check", checked);
    EXPECT_EQ(checked["valid"], true);
    EXPECT_EQ(checked["repairs"]["holes_filled"], 1);
    expect_as_documented("info FILE", run_json({"info", "a.off", "--repair"}));
    EXPECT_THAT(run({"check", "a.off", "--repair"}).out, HasSubstr("repair: 1 hole filled"));
    EXPECT_EQ(read("a.off"), open_tetrahedron());
}

TEST_F(Convert, TurnsFacesOverAndCutsPolygonsWhereAsked) {
    samples::Faces faces = samples::tetrahedron;
    std::swap(faces[2][0], faces[2][1]);
    write("mixed.off", samples::off(4, faces));
    expect_unusable({"convert", "mixed.off", "-o", "b"}, {"--reorient"});
    EXPECT_EQ(run_json({"convert", "mixed.off", "-o", "b.off", "--reorient"})["genus"], 0);
    EXPECT_EQ(run_json({"check", "b.off"})["coherently_stored"], true);
    write("quads.off", samples::off(5, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}));
    expect_unusable({"convert", "quads.off", "-o", "b"}, {"--triangulate"});
    EXPECT_EQ(run_json({"convert", "quads.off", "-o", "b", "--triangulate"})["faces"], 6);
}

TEST_F(Convert, DamagedGluingsAreRefusedWithTheirPlace) {
    write_book("book");
    run_json({"convert", "book", "-o", "a.ply", "--ascii"});
    const std::string good = read("a.ply");
    const std::size_t row = good.rfind("\n3 ") + 1;
    const auto with_last_row = [&](const std::string& last) { return good.substr(0, row) + last; };
    for (const auto& [last, word] : std::vector<std::pair<std::string, std::string>>{
             {"3 0 1 2 2 1 2\n", "glued sides"},
             {"3 0 1 2 3 1 2\n", "a glued side"},
             {"3 0 1 2 3 1 2 18\n", "glued to 18"},
             {"3 0 1 2 3 1 2 2000000000\n", "glued to 2000000000"},
             {"3 0 1 2 4000000000 1 2 3\n", "a glued side"}}) {
        write("bad.ply", with_last_row(last));
        expect_unusable({"convert", "bad.ply", "-o", "b"}, {"bad.ply:21: ", word});
    }
    write("bad.ply", good.substr(0, row));
    expect_unusable({"convert", "bad.ply", "-o", "b"}, {"bad.ply:"});
    // One that contradicts itself can be read, and is judged.
    std::string contradiction = good;
    contradiction.replace(row, std::string::npos, "3 0 1 2 3 0 1 2\n");
    write("bad.ply", contradiction);
    EXPECT_EQ(run_json({"check", "bad.ply"}, 1)["valid"], false);
    EXPECT_THAT(names(), UnorderedElementsAre("book", "a.ply", "bad.ply"));
}

}  // namespace
}  // namespace tightflip::tools
