#include "written.hpp"
#include <tightflip/geometry/surface_text.hpp>

#include <locale>

#include <gmock/gmock.h>

namespace tightflip::geometry {
namespace {

using testing::HasSubstr;

std::string text_of(const Surface& surface) {
    std::ostringstream out;
    write_text(out, surface.view());
    return out.str();
}

std::string smallest() {
    return text_of(make_surface({{0, 1, 2}, {0, 2, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, -0.5, 1e30}}));
}

TEST(SurfaceText, IsAsDocumented) {
    EXPECT_EQ(smallest(),
              "tightflip-surface 1\nvertices 3\nhalfedges 6\n"
              "# next halfedge and origin of halfedge 0, 1, 2, ...\n"
              "2 0\n5 1\n4 1\n1 2\n0 2\n3 0\n"
              "points 3\n# x y z of vertex 0, 1, 2, ...\n0 0 0\n1 0 0\n0 -0.5 1e+30\nend\n");
}

TEST(SurfaceText, KeepsTablesAndEveryBitOfThePoints) {
    std::vector<Surface> surfaces{surface_of_odd_numbers()};
    for (const Triangulation& triangulation : all_families())
        surfaces.push_back(with_random_points(triangulation, 5));
    for (const Surface& surface : surfaces) {
        const RawSurface back = parse_surface(text_of(surface), "text");
        EXPECT_EQ(kernel::build(back.table.records, back.table.vertex_count).value(),
                  surface.triangulation());
        expect_same_points(back.points, surface.points());
    }
}

TEST(SurfaceText, NoLocaleChangesIt) {
    struct Grouped : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\1"; }
    };
    std::ostringstream out;
    out.imbue(std::locale(std::locale::classic(), new Grouped));
    out << std::hex << std::showpos;
    const Surface surface = with_random_points(kernel::families::book(30), 2);
    write_text(out, surface.view());
    EXPECT_EQ(out.str(), text_of(surface));
}

TEST(SurfaceText, IsRecognised) {
    EXPECT_TRUE(is_surface_text(smallest()));
    EXPECT_FALSE(is_surface_text("tightflip-triangulation 1\n"));
    EXPECT_FALSE(kernel::is_surface_text(smallest()));
}

TEST(SurfaceText, RefusesDamageWithTheLineAndTheReason) {
    const std::string good = smallest();
    const auto changed = [&](std::string_view from, std::string_view to) {
        const auto at = good.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return std::string(good).replace(at, from.size(), to);
    };
    struct Bad {
        std::string text;
        std::uint64_t line;
        std::string word;
    };
    const std::vector<Bad> bad{
        {changed("surface 1", "surface 2"), 1, "version"},
        {changed("surface 1", "surfaces 1"), 1, "tightflip-surface"},
        {changed("surface 1", "surface 1 x"), 1, "goes on with 'x'"},
        {changed("points 3", "points 4"), 11, "4 points are announced for 3 vertices"},
        {changed("points 3", "points 2"), 11, "2 points"},
        {changed("points 3", "points 2000000000"), 11, "2000000000"},
        {changed("vertices 3", "vertices 2000000000"), 11, "3 points are announced"},
        {changed("halfedges 6", "halfedges 2000000000"), 3, "2000000000"},
        {changed("1 0 0\n", "1 0\n"), 14, "z coordinate"},
        {changed("1 0 0\n", "1 0 0 0\n"), 14, "goes on with '0'"},
        {changed("1 0 0\n", "1 nan 0\n"), 14, "vertex 1 is not finite"},
        {changed("1 0 0\n", "1 -inf 0\n"), 14, "vertex 1 is not finite"},
        {changed("1 0 0\n", "1 1e400 0\n"), 14, "beyond the range"},
        {changed("1 0 0\n", ""), 15, "the x coordinate"},
        {changed("\nend\n", "\n"), 15, "'end'"},
        {good + "more\n", 17, "nothing should follow"}};
    for (const auto& [text, line, word] : bad) {
        SCOPED_TRACE(text);
        try {
            (void)parse_surface(text, "a.tfs");
            ADD_FAILURE() << "was read";
        } catch (const kernel::FileError& error) {
            EXPECT_EQ(error.source(), "a.tfs");
            EXPECT_EQ(error.position(), line) << error.what();
            EXPECT_THAT(error.reason(), HasSubstr(word));
        }
    }
    for (std::size_t size = 0; size + 1 < good.size(); ++size) {
        EXPECT_THROW((void)parse_surface(good.substr(0, size), "a.tfs"), kernel::FileError) << size;
    }
}

}  // namespace
}  // namespace tightflip::geometry
