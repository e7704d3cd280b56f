#include "command_runner.hpp"
#include "documented_keys.hpp"
#include "samples.hpp"

namespace tightflip::tools {
namespace {

using samples::gluing;
using samples::off;
using samples::with;
using ::testing::HasSubstr;

class Check : public CommandTest {
protected:
    static std::set<int> codes(const Json& report) {
        std::set<int> codes;
        for (const Json& violation : report["violations"])
            codes.insert(violation["code"].get<int>());
        return codes;
    }
    static Json first(const Json& report, int code) {
        for (const Json& violation : report["violations"]) {
            if (violation["code"] == code) return violation;
        }
        ADD_FAILURE() << "no violation " << code << " in " << report;
        return Json::object();
    }
};

TEST_F(Check, KeysAreAsDocumented) {
    write("valid", samples::smallest_sphere);
    write("violations.off", off(4, {{0, 1, 2}}));
    write("broken", gluing(3, {"0 1 9  5 4 3", "0 2 1  2 1 0"}));
    expect_as_documented("check", run_json({"check", "valid"}));
    expect_as_documented("check", run_json({"check", "violations.off"}, 1));
    const Json broken = run_json({"check", "broken"}, 1);
    expect_as_documented("check", broken);
    for (const char* key : {"components", "euler_characteristic", "orientable", "genus", "simple",
                            "degrees", "parallel_edges"}) {
        EXPECT_TRUE(broken[key].is_null()) << key;
    }
}

TEST_F(Check, SaysWhatAValidSurfaceIs) {
    write("a.off", off(4, samples::tetrahedron));
    const Json report = run_json({"check", "a.off"});
    const Json expected{
        {"file", "a.off"},
        {"format", "off"},
        {"valid", true},
        {"vertices", 4},
        {"edges", 6},
        {"faces", 4},
        {"components", 1},
        {"euler_characteristic", 2},
        {"orientable", true},
        {"genus", 0},
        {"simple", true},
        {"coherently_stored", true},
        {"degrees", {{"min", 3}, {"max", 3}, {"degree_two_vertices", 0}}},
        {"parallel_edges", {{"loops", 0}, {"pairs_joined_twice", 0}, {"max_multiplicity", 1}}},
        {"violation_count", 0},
        {"violations", Json::array()}};
    EXPECT_EQ(report, expected) << Json::diff(expected, report);
    const Outcome words = run({"check", "a.off"});
    EXPECT_EQ(words.exit_code, 0);
    EXPECT_EQ(words.err, "");
    EXPECT_THAT(words.out, HasSubstr("a.off: valid: a sphere, Definition 2.1"));
    EXPECT_THAT(words.out, HasSubstr("4 vertices, 6 edges, 4 faces"));
}

TEST_F(Check, ParallelEdgesAndDegreeTwoAreAllowed) {
    run_json({"make", "book", "--vertices", "6", "-o", "book"});
    const Json report = run_json({"check", "book"});
    EXPECT_EQ(report["valid"], true);
    EXPECT_EQ(report["simple"], false);
    EXPECT_EQ(report["degrees"]["degree_two_vertices"], 4);
    EXPECT_EQ(report["parallel_edges"]["max_multiplicity"], 4);
    EXPECT_EQ(report["parallel_edges"]["pairs_joined_twice"], 1);
}

TEST_F(Check, FindsWhatWasPlantedInAGluing) {
    struct Case {
        std::string what;
        std::string text;
        std::set<int> codes;
    };
    const std::vector<Case> cases{
        {"no faces", gluing(0, {}), {101}},
        {"a corner too far", gluing(3, {"0 1 2  5 4 3", "0 2 7  2 1 0"}), {102, 301}},
        {"a side too far", gluing(3, {"0 1 2  5 4 30", "0 2 1  2 1 0"}), {103, 202}},
        {"more vertices than corners", gluing(7, {"0 1 2  5 4 3", "0 2 1  2 1 0"}), {104}},
        {"glued to itself", gluing(3, {"0 1 2  0 4 3", "0 2 1  2 1 5"}), {201}},
        {"not glued back", gluing(3, {"0 1 2  5 4 3", "0 2 1  2 1 1"}), {202}},
        {"a boundary", gluing(3, {"0 1 2  - 4 3", "0 2 1  2 1 -"}), {203}},
        {"different ends", gluing(3, {"0 1 2  3 4 5", "0 2 1  0 1 2"}), {301, 602}},
        {"turned over by the bit alone", gluing(3, {"0 1 2  5~ 4 3", "0 2 1  2 1 0~"}), {302}},
        {"loops", gluing(1, {"0 0 0  3 4 5", "0 0 0  0 1 2"}), {401}},
        {"an unused vertex", gluing(4, {"0 1 2  5 4 3", "0 2 1  2 1 0"}), {601}},
        {"two spheres",
         gluing(6, {"0 1 2  5 4 3", "0 2 1  2 1 0", "3 4 5  11 10 9", "3 5 4  8 7 6"}),
         {501, 701, 702}},
        {"two spheres pinched together",
         gluing(5, {"0 1 2  5 4 3", "0 2 1  2 1 0", "0 3 4  11 10 9", "0 4 3  8 7 6"}),
         {501, 602, 702}}};
    for (const auto& [what, text, expected] : cases) {
        SCOPED_TRACE(what);
        write("a", text);
        const Json report = run_json({"check", "a"}, 1);
        EXPECT_EQ(report["valid"], false);
        EXPECT_EQ(report["format"], "tightflip-gluing");
        EXPECT_EQ(codes(report), expected) << report;
        EXPECT_GE(report["violation_count"], report["violations"].size());
    }
}

TEST_F(Check, FindsWhatWasPlantedInAMeshAndSaysWhere) {
    struct Case {
        std::string what;
        std::string text;
        std::set<int> codes;
        int code;  ///< of which this is the first
        std::string where;
        Json witness;
    };
    const samples::Faces& tetrahedron = samples::tetrahedron;
    const samples::Faces second{{0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {5, 0, 6}};
    const samples::Faces apart{{4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}};
    const std::vector<Case> cases{
        {"an edge in three faces",
         off(5, with(tetrahedron, {{0, 1, 4}})),
         {203, 204, 602, 702},
         204,
         "a.off:8: face 0, side 2",
         {0, 1, 4}},
        {"a pinched vertex",
         off(7, with(tetrahedron, second)),
         {602, 702},
         602,
         "a.off:3: vertex 0",
         Json::array()},
        {"a hole",
         off(4, {tetrahedron.begin(), tetrahedron.end() - 1}),
         {203},
         203,
         "a.off:7: face 0, side 0",
         Json::array()},
        {"two components",
         off(8, with(tetrahedron, apart)),
         {701, 702},
         702,
         "a.off: surface",
         {4, 4}},
        {"an unused vertex", off(5, tetrahedron), {601}, 601, "a.off:7: vertex 4", Json::array()},
        {"a face twice",
         off(4, with(tetrahedron, {tetrahedron.front()})),
         {203, 204, 602, 702},
         204,
         "a.off:7: face 0, side 0",
         {0, 3, 4}},
        {"a face with two corners alike",
         off(4, with(tetrahedron, {{0, 0, 1}})),
         {401},
         401,
         "a.off:11: face 4",
         {0, 0, 1}}};
    for (const auto& [what, text, expected, code, where, witness] : cases) {
        SCOPED_TRACE(what);
        write("a.off", text);
        const Json report = run_json({"check", "a.off"}, 1);
        std::set<int> found = codes(report);
        if (code == 401) found = {found.contains(401) ? 401 : 0};  // the edges about it fall too
        EXPECT_EQ(found, expected) << report;
        const Json violation = first(report, code);
        EXPECT_EQ(violation["where"], where);
        EXPECT_EQ(violation["witness"], witness);
        EXPECT_THAT(run({"check", "a.off"}).out, HasSubstr(where));
    }
}

TEST_F(Check, SurfacesThatCannotBeOrientedGiveAWitness) {
    struct Case {
        std::string name;
        std::string text;
        int genus;
        int euler_characteristic;
    };
    const std::vector<Case> cases{{"projective-plane.off", off(6, samples::projective_plane), 1, 1},
                                  {"klein-bottle.off", off(16, samples::klein_bottle()), 2, 0}};
    for (const auto& [name, text, genus, euler_characteristic] : cases) {
        SCOPED_TRACE(name);
        write(name, text);
        const Json report = run_json({"check", name}, 1);
        EXPECT_EQ(report["orientable"], false);
        EXPECT_EQ(report["genus"], genus);
        EXPECT_EQ(report["euler_characteristic"], euler_characteristic);
        EXPECT_EQ(codes(report), std::set<int>{801});
        EXPECT_GE(first(report, 801)["witness"].size(), 3U);
        expect_unusable({"campaign", name}, {name, "orient"});
    }
}

TEST_F(Check, MixedOrientationIsValidAndSaid) {
    samples::Faces faces = samples::tetrahedron;
    std::swap(faces[2][0], faces[2][1]);
    write("a.off", off(4, faces));
    const Json report = run_json({"check", "a.off"});
    EXPECT_EQ(report["valid"], true);
    EXPECT_EQ(report["orientable"], true);
    EXPECT_EQ(report["coherently_stored"], false);
    EXPECT_THAT(run({"check", "a.off"}).out, HasSubstr("not stored in one orientation"));
}

TEST_F(Check, PolygonsAreRefusedOrCutOnRequest) {
    write("cube.obj",
          "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
          "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    expect_unusable({"check", "cube.obj"}, {"cube.obj:9:", "4 corners", "--triangulate"});
    const Json report = run_json({"check", "--triangulate", "cube.obj"});
    EXPECT_EQ(report["faces"], 12);
    EXPECT_EQ(report["genus"], 0);
}

TEST_F(Check, ReadsEveryMeshFormat) {
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    write("a.ply",
          "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
          "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n" +
              points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    std::string stl = "solid a\n";
    const std::vector<std::string> at{"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
    for (const auto& face : samples::tetrahedron) {
        stl += "facet normal 0 0 0\nouter loop\n";
        for (const int corner : face)
            stl += "vertex " + at[static_cast<std::size_t>(corner)] + "\n";
        stl += "endloop\nendfacet\n";
    }
    write("a.stl", stl + "endsolid a\n");
    write("a.off", off(4, samples::tetrahedron));
    for (const std::string format : {"obj", "ply", "stl", "off"}) {
        const Json report = run_json({"check", "a." + format});
        EXPECT_EQ(report["format"], format);
        EXPECT_EQ(report["vertices"], 4) << format;
        EXPECT_EQ(report["genus"], 0) << format;
    }
    std::filesystem::rename(path("a.ply"), path("misnamed.obj"));
    EXPECT_EQ(run_json({"check", "misnamed.obj"})["format"], "ply");
}

TEST_F(Check, ManyViolationsOfOneCodeAreCountedAndSixteenTold) {
    samples::Faces faces;
    for (int f = 0; f < 20; ++f)
        faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    write("a.off", off(60, faces));
    const Json report = run_json({"check", "a.off"}, 1);
    int unglued = 0;
    for (const Json& violation : report["violations"])
        unglued += violation["code"] == 203 ? 1 : 0;
    EXPECT_EQ(unglued, 16);
    EXPECT_GE(report["violation_count"], 60);
}

TEST_F(Check, SeveralInputsGiveOneObjectALineAndTheWorstExitCode) {
    write("valid", samples::smallest_sphere);
    write("open.off", off(3, {{0, 1, 2}}));
    write("damaged", "tightflip-gluing 1\nvertices 3\n");
    struct Case {
        std::vector<std::string> files;
        int exit_code;
    };
    const std::vector<Case> cases{{{"valid", "valid"}, 0},
                                  {{"valid", "open.off", "valid"}, 1},
                                  {{"damaged", "open.off", "valid"}, 2},
                                  {{"open.off", "missing", "valid"}, 2}};
    for (const auto& [files, exit_code] : cases) {
        std::vector<std::string> arguments{"--json", "check"};
        arguments.insert(arguments.end(), files.begin(), files.end());
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, exit_code);
        const std::vector<Json> objects = outcome.objects();
        ASSERT_EQ(objects.size(), files.size());
        for (std::size_t i = 0; i < files.size(); ++i) {
            EXPECT_EQ(objects[i]["file"], files[i]);
            const bool usable = files[i] == "valid" || files[i] == "open.off";
            EXPECT_EQ(objects[i].contains("error"), !usable);
            EXPECT_EQ(objects[i].value("valid", false), files[i] == "valid");
        }
    }
}

TEST_F(Check, ReadsStandardInputByName) {
    const Outcome outcome =
        run({"check", "--json", "/dev/stdin"}, {.input = samples::smallest_sphere});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.object()["vertices"], 3);
}

}  // namespace
}  // namespace tightflip::tools
