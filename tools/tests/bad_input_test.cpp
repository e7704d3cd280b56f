#include "command_runner.hpp"
#include "samples.hpp"

#include <cstdint>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace tightflip::tools {
namespace {

using samples::gluing;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TIGHTFLIP_ADDRESS_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define TIGHTFLIP_ADDRESS_SANITIZER
#endif

/// Far less than what the counts in damaged headers ask for. AddressSanitizer reserves its own
/// terabytes.
#if defined(TIGHTFLIP_ADDRESS_SANITIZER)
constexpr std::optional<rlim_t> little_memory;
#else
constexpr std::optional<rlim_t> little_memory = rlim_t{256} << 20;
#endif

const std::string ply_header =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

struct Bad {
    std::string name;
    std::string bytes;
    std::vector<std::string> words;
};

std::vector<Bad> bad_files() {
    const std::string garbage = [] {
        std::string bytes(3000, '\0');
        std::uint32_t state = 12345;
        for (char& byte : bytes)
            byte = static_cast<char>((state = 1664525 * state + 1013904223) >> 24);
        return bytes;
    }();
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
    const std::string ply = ply_header + points + "3 0 1 2\n";
    const std::string table =
        "tightflip-triangulation 1\nvertices 3\nhalfedges 6\n2 0\n5 1\n4 1\n1 2\n0 2\n3 0\nend\n";
    const std::string surface =
        replaced(replaced(table, "triangulation", "surface"), "end", "points 3\n" + points + "end");
    const std::string glued =
        replaced(ply_header, "end_header", "property list uchar int glued_sides\nend_header") +
        points;
    std::string binary_stl(80, 'x');
    binary_stl += "\xff\xff\xff\xff" + std::string(50, '\0');
    std::vector<Bad> files{
        {"empty", "", {"empty: the file is empty"}},
        {"empty.obj", "", {"empty.obj: the file is empty"}},
        {"unknown", "hello\n", {"unknown: ", "OBJ, OFF, PLY or STL"}},
        {"nothing.obj", "v 0 0 0\n", {"nothing.obj: ", "no faces"}},
        {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", {"index.obj:4: ", "vertex 4"}},
        {"zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", {"zero.obj:4: "}},
        {"word.obj", "v 0 0 0\nv 1 0 x\nv 0 1 0\nf 1 2 3\n", {"word.obj:2: "}},
        {"nan.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", {"nan.off:4: ", "finite"}},
        {"cut.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", {"cut.off:"}},
        {"huge.off", "OFF\n4000000000 4000000000 0\n" + points, {"huge.off:2: ", "4000000000"}},
        {"index.off", "OFF\n3 1 0\n" + points + "3 0 1 3\n", {"index.off:6: ", "vertex 3"}},
        {"corners.off", "OFF\n3 1 0\n" + points + "4000000000 0 1 2\n", {"corners.off:6: "}},
        {"huge.ply", replaced(ply, "vertex 3", "vertex 4000000000"), {"huge.ply:"}},
        {"faces.ply", replaced(ply, "face 1", "face 4000000000"), {"faces.ply:"}},
        {"header.ply", ply.substr(0, 60), {"header.ply:"}},
        {"index.ply", replaced(ply, "3 0 1 2", "3 0 1 9"), {"index.ply:13: ", "vertex 9"}},
        {"nan.ply", replaced(ply, "1 0 0", "nan 0 0"), {"nan.ply:11: "}},
        {"huge.stl", binary_stl, {"huge.stl: byte 80: ", "4294967295"}},
        {"cut.stl", "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\n", {"cut.stl:"}},
        {"cut-gluing", "tightflip-gluing 1\nvertices 3\nfaces 2\n0 1 2  5 4 3\n", {"cut-gluing:"}},
        {"huge-gluing",
         "tightflip-gluing 1\nvertices 3\nfaces 700000000\n0 1 2  5 4 3\n",
         {"huge-gluing:3: ", "700000000"}},
        {"side-gluing", gluing(3, {"0 1 2  5 4 x", "0 2 1  2 1 0"}), {"side-gluing:4: "}},
        {"cut-table", table.substr(0, table.size() - 4), {"cut-table:"}},
        {"huge-table", replaced(table, "halfedges 6", "halfedges 2000000000"), {"huge-table:3: "}},
        {"more-table", table + "more\n", {"more-table:11: "}},
        {"cut-surface", surface.substr(0, surface.size() - 4), {"cut-surface:"}},
        {"nan-surface", replaced(surface, "1 0 0", "1 nan 0"), {"nan-surface:12: ", "finite"}},
        {"points-surface", replaced(surface, "points 3", "points 2"), {"points-surface:10: "}},
        {"huge-surface",
         replaced(replaced(surface, "points 3", "points 2000000000"), "vertices 3",
                  "vertices 2000000000"),
         {"huge-surface:10: ", "2000000000"}},
        {"sides.ply", glued + "3 0 1 2 3 -1 -1 3\n", {"sides.ply:14: ", "glued to 3"}},
        {"short.ply", glued + "3 0 1 2 2 -1 -1\n", {"short.ply:14: ", "2 glued sides"}},
        {"long.ply", glued + "3 0 1 2 4000000000 -1 -1 -1\n", {"long.ply:14: ", "glued side"}},
        {"version-table",
         replaced(table, "triangulation 1", "triangulation 7"),
         {"version-table:1: "}}};
    for (const std::string extension : {"obj", "off", "ply", "stl", "bin"}) {
        files.push_back({"garbage." + extension, garbage, {"garbage." + extension}});
    }
    return files;
}

class BadInput : public CommandTest {};

TEST_F(BadInput, IsRefusedByEveryVerbWithFilePlaceAndReason) {
    for (const auto& [name, bytes, words] : bad_files()) {
        write(name, bytes);
        for (const std::vector<std::string>& arguments :
             {std::vector<std::string>{"check", name},
              {"info", name},
              {"campaign", name, "--flips", "10"},
              {"flip", name, "--edges", "0", "-o", "end", "--log", "log"}}) {
            SCOPED_TRACE(arguments[0] + " " + name);
            expect_unusable(arguments, words, {.most_memory = little_memory});
        }
        SCOPED_TRACE(name);
        expect_unusable({"replay", name, "-o", "end"}, {name}, {.most_memory = little_memory});
        EXPECT_EQ(read(name), bytes);
        EXPECT_THAT(names(), UnorderedElementsAre(name));  // and so nothing was written
        std::filesystem::remove(path(name));
    }
}

TEST_F(BadInput, NoRefusalIsForWantOfMemory) {
    for (const auto& [name, bytes, words] : bad_files()) {
        write(name, bytes);
        EXPECT_THAT(run({"check", name}, {.most_memory = little_memory}).err,
                    Not(HasSubstr("memory")));
    }
    // Counts that a judge reads without trusting them.
    write("vertices", gluing(2000000000, {"0 1 2  5 4 3", "0 2 1  2 1 0"}));
    EXPECT_EQ(run({"check", "vertices"}, {.most_memory = little_memory}).exit_code, 1);
    expect_unusable({"campaign", "vertices"}, {"vertices: ", "2000000000"},
                    {.most_memory = little_memory});
}

TEST_F(BadInput, WhatIsNoReadableFileIsRefused) {
    std::filesystem::create_directory(path("directory.obj"));
    std::filesystem::create_symlink("nowhere", path("link.obj"));
    for (const std::string verb : {"check", "info", "campaign", "replay"}) {
        SCOPED_TRACE(verb);
        expect_unusable({verb, "directory.obj"}, {"directory.obj: is a directory"});
        expect_unusable({verb, "missing.obj"}, {"missing.obj: ", "No such file"});
        expect_unusable({verb, "link.obj"}, {"link.obj: ", "No such file"});
        expect_unusable({verb, "/dev/null"}, {"/dev/null"});
    }
}

TEST_F(BadInput, NoPermissionIsSaid) {
    if (::geteuid() == 0) GTEST_SKIP() << "permissions do not bind the superuser";
    write("a", samples::smallest_sphere);
    std::filesystem::permissions(path("a"), std::filesystem::perms::none);
    expect_unusable({"check", "a"}, {"a: ", "Permission denied"});
    std::filesystem::create_directory(path("closed"));
    std::filesystem::permissions(
        path("closed"), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    expect_unusable({"make", "book", "-o", "closed/a"}, {"closed/a: ", "Permission denied"});
}

TEST_F(BadInput, NamesNeedNotBeUtf8) {
    const std::string name = "caf\xe9\xff";
    write(name, samples::smallest_sphere);
    const Outcome good = run({"check", "--json", name});
    EXPECT_EQ(good.exit_code, 0);
    EXPECT_EQ(good.object()["file"], "caf\xef\xbf\xbd\xef\xbf\xbd");
    const Outcome bad = run({"check", "--json", "\xfe.obj"});
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_TRUE(bad.object().contains("error"));
    EXPECT_THAT(bad.err, HasSubstr("\xfe.obj"));
}

TEST_F(BadInput, AFifoIsReadLikeAFile) {
    ASSERT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
    Running check(path("."), {"check", "--json", "fifo"}, {});
    std::ofstream(path("fifo")) << samples::smallest_sphere;
    const Outcome outcome = check.finish();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.object()["genus"], 0);
}

// ---- outputs ----

TEST_F(BadInput, OutputsThatCannotBeWrittenLeaveNothing) {
    std::filesystem::create_directory(path("directory"));
    expect_unusable({"make", "book", "-o", "missing/a"}, {"missing/a: ", "No such file"});
    expect_unusable({"make", "book", "-o", "directory"}, {"directory: is a directory"});
    EXPECT_THAT(names(), UnorderedElementsAre("directory"));
}

TEST_F(BadInput, AFullDiskLeavesWhatWasThere) {
    const Circumstances full_disk{.most_bytes_a_file = 4000};
    write("old", "what was here before");
    expect_unusable({"make", "book", "--vertices", "1000", "-o", "new"}, {"new: "}, full_disk);
    expect_unusable({"make", "book", "--vertices", "1000", "-o", "old"}, {"old: "}, full_disk);
    EXPECT_EQ(read("old"), "what was here before");
    EXPECT_THAT(names(), UnorderedElementsAre("old"));

    run({"make", "book", "--vertices", "1000", "-o", "start"});
    const std::string before = read("start");
    expect_unusable({"flip", "start", "--edges", "0", "-o", "start"}, {"start: "}, full_disk);
    expect_unusable({"flip", "start", "--edges", "0", "--log", "log"}, {"log: "}, full_disk);
    EXPECT_EQ(read("start"), before);
    EXPECT_THAT(names(), UnorderedElementsAre("old", "start"));
}

TEST_F(BadInput, ResultsThatNobodyGetsMakeTheRunUnusable) {
    write("a", samples::smallest_sphere);
    std::vector<Circumstances> losses{{.nobody_reads = true}};
    if (std::filesystem::is_character_file("/dev/full"))
        losses.push_back({.output_to = "/dev/full"});
    std::vector<std::string> many(200, "a");
    many.insert(many.begin(), {"check", "--json"});
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"check", "a"},
                                                      {"check", "a", "--json"},
                                                      many,
                                                      {"info"},
                                                      {"--help"}}) {
        SCOPED_TRACE(::testing::PrintToString(arguments));
        for (const Circumstances& lost : losses) {
            const Outcome outcome = run(arguments, lost);
            EXPECT_EQ(outcome.signal, 0);
            EXPECT_EQ(outcome.exit_code, 2);
            EXPECT_EQ(outcome.err,
                      "tightflip: the results could not be written to standard output\n");
        }
    }
}

TEST_F(BadInput, ResultsAreReadableWhileTheRunGoesOn) {
    write("a", samples::smallest_sphere);
    ASSERT_EQ(::mkfifo(path("later").c_str(), 0600), 0);
    Running check(path("."), {"check", "--json", "a", "later"}, {});
    const std::string line = check.line();
    ASSERT_THAT(line, HasSubstr("\"file\":\"a\""));
    std::ofstream(path("later")) << samples::smallest_sphere;
    const Outcome outcome = check.finish();
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.object()["file"], "later");
}

}  // namespace
}  // namespace tightflip::tools
