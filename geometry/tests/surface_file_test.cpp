#include "samples.hpp"
#include "written.hpp"
#include <tightflip/geometry/surface_file.hpp>
#include <tightflip/geometry/surface_text.hpp>
#include <tightflip/kernel/file_error.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/flip_log.hpp>

#include <filesystem>
#include <set>
#include <system_error>
#include <unistd.h>

#include <gmock/gmock.h>

namespace tightflip::geometry {
namespace {

using kernel::FileError;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SurfaceFiles : public testing::Test {
protected:
    SurfaceFiles() {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "tightflip-files-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) {
            throw std::system_error(errno, std::generic_category(), "mkdtemp");
        }
        directory_ = pattern;
    }
    ~SurfaceFiles() override { std::filesystem::remove_all(directory_); }

    [[nodiscard]] std::filesystem::path path(const std::string& name) const {
        return directory_ / name;
    }
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        kernel::write_file(path(name), [&](std::ostream& out) { out << bytes; });
        return path(name);
    }
    [[nodiscard]] std::set<std::string> names() const {
        std::set<std::string> found;
        for (const auto& file : std::filesystem::directory_iterator(directory_))
            found.insert(file.path().filename().string());
        return found;
    }
    /// What the refusal says; fails where nothing is refused.
    template <class Action>
    static std::string refusal(Action action) {
        try {
            action();
        } catch (const FileError& error) {
            return error.what();
        }
        ADD_FAILURE() << "was not refused";
        return {};
    }

private:
    std::filesystem::path directory_;
};

TEST_F(SurfaceFiles, EveryFormatComesBackByItsName) {
    const Surface odd = surface_of_odd_numbers();
    for (const std::string name : {"a", "a.tfs", "a.obj", "a.off", "a.ply", "A.PLY"}) {
        for (const auto encoding : {MeshEncoding::text, MeshEncoding::binary}) {
            SCOPED_TRACE(name);
            write_surface_file(path(name), odd.view(), {}, {.encoding = encoding});
            expect_same_surface(read_surface_file(path(name)), odd);
        }
    }
    write_surface_file(path("a.stl"), odd.view(), {}, {.encoding = MeshEncoding::text});
    EXPECT_EQ(read_surface_file(path("a.stl")).triangulation().face_count(), 4);
    EXPECT_THAT(names(), ElementsAre("A.PLY", "a", "a.obj", "a.off", "a.ply", "a.stl", "a.tfs"));
}

TEST_F(SurfaceFiles, LosslessFormatsKeepMultigraphs) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Surface surface =
            with_random_points(kernel::families::random(6 + static_cast<Index>(seed),
                                                        static_cast<Index>(seed % 3), seed),
                               seed);
        for (const std::string name : {"a.tfs", "a.ply"}) {
            write_surface_file(path(name), surface.view());
            expect_same_surface(read_surface_file(path(name)), surface);
        }
        EXPECT_EQ(read_surface_file(path("a.tfs")).triangulation(), surface.triangulation());
    }
}

TEST_F(SurfaceFiles, TheFormatMayBeNamed) {
    const Surface surface = regular_tetrahedron();
    for (const auto format : {SurfaceFormat::tightflip_surface, SurfaceFormat::obj,
                              SurfaceFormat::off, SurfaceFormat::ply, SurfaceFormat::stl}) {
        write_surface_file(path("a.mesh"), surface.view(), format);
        EXPECT_EQ(SurfaceFile(path("a.mesh")).format(), name(format));
        EXPECT_EQ(surface_format_named(name(format)), format);
    }
    EXPECT_FALSE(surface_format_named("mesh"));
    EXPECT_FALSE(surface_format_of("a.mesh"));
    EXPECT_EQ(surface_format_of("directory.obj/a"), SurfaceFormat::tightflip_surface);
}

TEST_F(SurfaceFiles, WhatCannotBeWrittenLeavesWhatWasThere) {
    const Surface book = with_random_points(kernel::families::book(6), 1);
    for (const std::string name : {"a.obj", "a.off", "a.stl"}) {
        write(name, "what was here before");
        EXPECT_THAT(refusal([&] { write_surface_file(path(name), book.view()); }),
                    testing::AllOf(HasSubstr(path(name).string()), HasSubstr("which sides")));
        EXPECT_EQ(kernel::read_file(path(name)), "what was here before");
    }
    EXPECT_THAT(refusal([&] { write_surface_file(path("a.mesh"), book.view()); }),
                HasSubstr("--format"));
    EXPECT_THAT(refusal([&] { write_surface_file(path("missing/a"), book.view()); }),
                HasSubstr("cannot be written"));
    EXPECT_THAT(names(), ElementsAre("a.obj", "a.off", "a.stl"));
}

TEST_F(SurfaceFiles, FormatsWithoutCoordinatesAreSurfacesWithoutPoints) {
    const Triangulation book = kernel::families::book(5);
    kernel::write_file(path("table"), [&](std::ostream& out) { write_text(out, book); });
    EXPECT_EQ(SurfaceFile(path("table")).triangulation(), book);
    EXPECT_THAT(refusal([&] { (void)read_surface_file(path("table")); }),
                HasSubstr("tightflip-triangulation has no coordinates"));
    kernel::write_file(path("log"), [&](std::ostream& out) {
        write_text(out, kernel::FlipLog{book, {}});
    });
    EXPECT_THAT(refusal([&] { (void)SurfaceFile(path("log")); }), HasSubstr("flip log"));
}

TEST_F(SurfaceFiles, DamageIsRefusedWithItsPlace) {
    std::ostringstream good;
    write_text(good, regular_tetrahedron().view());
    const std::string text = good.str();
    const auto changed = [&](std::string_view from, std::string_view to) {
        return std::string(text).replace(text.find(from), from.size(), to);
    };
    EXPECT_THAT(refusal([&] { (void)SurfaceFile(write("a", changed("points 4", "points 5"))); }),
                HasSubstr("a:17: 5 points"));
    // What is wrong with the table is for the audit to say.
    const std::size_t line = text.find("\n", text.find("# next")) + 1;
    std::string table = text;
    table.replace(line, table.find('\n', line) - line, "0 0");
    const SurfaceFile damaged(write("b", table));
    EXPECT_FALSE(damaged.audit().is_valid());
    EXPECT_THAT(refusal([&] { (void)damaged.surface(); }), HasSubstr("halfedge"));
    const SurfaceFile open(write("b.obj", samples::obj() + "v 9 9 9\n"));
    EXPECT_THAT(refusal([&] { (void)open.surface(); }), HasSubstr("b.obj:11: vertex 4"));
    EXPECT_THAT(refusal([&] { (void)SurfaceFile(write("c.obj", "")); }), HasSubstr("empty"));
    EXPECT_THAT(refusal([&] { (void)SurfaceFile(write("c", "hello\n")); }),
                HasSubstr("OBJ, OFF, PLY"));
}

TEST_F(SurfaceFiles, RefusalsNameTheOptionThatMends) {
    const std::string obj = samples::obj();
    struct Case {
        std::string text;
        std::string option;
        SurfaceFileOptions options;
    };
    const std::string loose =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 1\n"
        "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 5\n";
    const std::vector<Case> cases{
        {obj.substr(0, obj.size() - 8), "--fill-holes", {.repair = {.fill_holes = true}}},
        {loose, "--weld", {.repair = {.weld = 0.0}}},
        {obj + "v 9 9 9\n", "--drop-unused", {.repair = {.drop_unused = true}}},
        {obj + "f 4 3 1\n", "--drop-faces", {.repair = {.drop_faces = true}}},
        {obj + "f 4 4 1\n", "--drop-faces", {.repair = {.drop_faces = true}}},
        {obj.substr(0, obj.size() - 8) + "f 1 3 4\n", "--reorient", {.reorient = true}},
        {"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 4 3 2\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 "
         "5\n",
         "--triangulate",
         {.triangulate_polygons = true}}};
    for (const auto& [text, option, options] : cases) {
        SCOPED_TRACE(option);
        write("a.obj", text);
        EXPECT_THAT(refusal([&] { (void)read_surface_file(path("a.obj")); }), HasSubstr(option));
        EXPECT_TRUE(SurfaceFile(path("a.obj"), options).audit().is_valid());
        EXPECT_GE(read_surface_file(path("a.obj"), options).triangulation().vertex_count(), 4);
    }
}

TEST_F(SurfaceFiles, RepairsAreReportedWhereTheyWereAskedFor) {
    write("a.obj", samples::obj() + "v 9 9 9\n");
    EXPECT_FALSE(SurfaceFile(path("a.obj")).repairs());
    const SurfaceFile mended(path("a.obj"), {.repair = all_repairs});
    EXPECT_EQ(mended.repairs(), RepairReport{.vertices_unused = 1});
    EXPECT_EQ(mended.surface().points().size(), 4U);
    write_surface_file(path("a.tfs"), regular_tetrahedron().view());
    EXPECT_FALSE(SurfaceFile(path("a.tfs"), {.repair = all_repairs}).repairs());
}

}  // namespace
}  // namespace tightflip::geometry
