#include "hostile_stream.hpp"
#include "refusals.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/surface_text.hpp>

#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using testing::expect_refused_in_line;
using testing::refusal_of;

template <class Surface>
std::string text_of(const Surface& surface) {
    std::ostringstream out;
    write_text(out, surface);
    return out.str();
}

RawSurface parse(const std::string& text) {
    return parse_surface(text, "test.tft");
}

std::string replaced_everywhere(const std::string& text, const std::string& from,
                                const std::string& to) {
    std::string result;
    std::size_t start = 0;
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, start)) {
        result += text.substr(start, at - start) + to;
        start = at + from.size();
    }
    return result + text.substr(start);
}

/// The two-face sphere in both formats, written by hand.
const std::string table_text =
    "tightflip-triangulation 1\n"  // 1
    "vertices 3\n"                 // 2
    "halfedges 6\n"                // 3
    "2 0\n"
    "5 1\n"
    "4 1\n"
    "1 2\n"
    "0 2\n"
    "3 0\n"   // 9
    "end\n";  // 10

const std::string gluing_text =
    "tightflip-gluing 1\n"  // 1
    "vertices 3\n"          // 2
    "faces 2\n"             // 3
    "0 1 2  5 4 3\n"
    "0 2 1  2 1 0\n"  // 5
    "end\n";          // 6

const std::vector<HalfedgeRecord> two_face_records = {{{2}, {0}}, {{5}, {1}}, {{4}, {1}},
                                                      {{1}, {2}}, {{0}, {2}}, {{3}, {0}}};

/// Surfaces whose tables are no longer in the order in which a builder makes them.
std::vector<Triangulation> flipped_surfaces() {
    std::vector<Triangulation> surfaces{families::book(3), families::tetrahedron(),
                                        families::book(20), families::icosphere(1)};
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        surfaces.push_back(families::random(12, 0, seed));
        surfaces.push_back(families::random(5, 2, seed));
        surfaces.push_back(families::random(150, 1, seed));
    }
    return surfaces;
}

/// A gluing that says anything at all.
Gluing garbage_gluing(std::uint64_t seed) {
    RandomStream random(seed);
    constexpr Index least = std::numeric_limits<Index>::min();
    constexpr Index most = std::numeric_limits<Index>::max();
    const auto number = [&]() -> Index {
        switch (random.below(5)) {
            case 0:
                return static_cast<Index>(random.bits() >> 32);
            case 1:
                return random.below(2) == 0 ? least : most;
            case 2:
                return -static_cast<Index>(random.below(4));
            default:
                return static_cast<Index>(random.below(30));
        }
    };
    Gluing gluing;
    gluing.vertex_count = number();
    gluing.faces.resize(random.below(12));
    for (GluedFace& face : gluing.faces) {
        for (Index& corner : face.corners)
            corner = number();
        for (SideGluing& side : face.sides) {
            if (const auto kind = random.below(3); kind != 0) {
                side = kind == 1 ? SideGluing::coherent(number()) : SideGluing::reversed(number());
            }
        }
    }
    return gluing;
}

// ---- what the formats say ----

TEST(SurfaceText, ReadsATableWrittenByHand) {
    const RawSurface raw = parse(table_text);
    EXPECT_EQ(raw, RawSurface(RawTable{3, two_face_records}));
    const BuildResult built = build(raw);
    ASSERT_TRUE(built);
    EXPECT_EQ(built.value().vertex_count(), 3);
    EXPECT_EQ(built.value().face_count(), 2);
}

TEST(SurfaceText, ReadsAGluingWrittenByHand) {
    EXPECT_EQ(parse(gluing_text), RawSurface(testing::two_face_sphere()));
    const Gluing expected{
        .vertex_count = 7,
        .faces = {{.corners = {-4, 9, 9},
                   .sides = {SideGluing(), SideGluing::coherent(12), SideGluing::reversed(3)}}}};
    EXPECT_EQ(parse("tightflip-gluing 1\nvertices 7\nfaces 1\n-4 9 9  - 12 3~\nend"),
              RawSurface(expected));
}

TEST(SurfaceText, ReadsTheEmptySurfaces) {
    EXPECT_EQ(parse("tightflip-gluing 1\nvertices 0\nfaces 0\nend\n"), RawSurface(Gluing{}));
    EXPECT_EQ(parse("tightflip-triangulation 1\nvertices 0\nhalfedges 0\nend\n"),
              RawSurface(RawTable{}));
}

TEST(SurfaceText, SaysNothingAboutValidity) {
    const RawSurface raw =
        parse("tightflip-triangulation 1\nvertices 2\nhalfedges 3\n-7 99\n5 0\n0 0\nend\n");
    EXPECT_EQ(raw, RawSurface(RawTable{2, {{{-7}, {99}}, {{5}, {0}}, {{0}, {0}}}}));
    EXPECT_TRUE(audit(raw).has(ViolationCode::halfedge_count_odd));
    EXPECT_FALSE(build(raw));
}

TEST(SurfaceText, RecognisesItsFormatsByTheirBeginning) {
    for (const std::string& text : {table_text, gluing_text}) {
        EXPECT_TRUE(is_surface_text(text));
        EXPECT_TRUE(is_surface_text(text.substr(0, text.find(' '))));
        EXPECT_FALSE(is_surface_text(text.substr(0, 9)));
        EXPECT_FALSE(is_surface_text("x" + text));
    }
    for (const std::string text : {"", "OFF\n3 1 0\n", "ply\n", "tightflip-flip-log 1\n"}) {
        EXPECT_FALSE(is_surface_text(text)) << text;
    }
}

// ---- lossless ----

TEST(SurfaceText, RoundTripKeepsTables) {
    for (const Triangulation& surface : flipped_surfaces()) {
        const std::string text = text_of(surface);
        EXPECT_TRUE(is_surface_text(text));
        const RawSurface raw = parse(text);
        const auto table = surface.table();
        EXPECT_EQ(raw, RawSurface(RawTable{surface.vertex_count(), {table.begin(), table.end()}}));
        EXPECT_EQ(build(raw).value(), surface);
    }
}

TEST(SurfaceText, RoundTripKeepsGluingsOfEveryKind) {
    for (const Gluing& gluing :
         {testing::tetrahedron(), testing::klein_bottle(), testing::projective_plane(),
          testing::moebius_strip(), testing::pinched_tetrahedra(), testing::looped_tetrahedron()}) {
        const RawSurface raw = parse(text_of(gluing));
        EXPECT_EQ(raw, RawSurface(gluing));
        EXPECT_EQ(audit(raw).violations, audit(gluing).violations);
    }
}

TEST(SurfaceText, RoundTripKeepsGarbage) {
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        const Gluing gluing = garbage_gluing(seed);
        ASSERT_EQ(parse(text_of(gluing)), RawSurface(gluing)) << "seed " << seed;
    }
}

TEST(SurfaceText, KeepsVertexCountsThatCannotBe) {
    for (const Index count : {Index{-3}, std::numeric_limits<Index>::min()}) {
        Gluing gluing = testing::tetrahedron();
        gluing.vertex_count = count;
        const RawSurface raw = parse(text_of(gluing));
        EXPECT_EQ(raw, RawSurface(gluing));
        EXPECT_TRUE(audit(raw).has(ViolationCode::corner_out_of_range));
        EXPECT_FALSE(build(raw));
    }
    const RawSurface empty = parse("tightflip-gluing 1\nvertices -1\nfaces 0\nend\n");
    EXPECT_FALSE(audit(empty).is_valid());
    EXPECT_FALSE(build(empty));
}

TEST(SurfaceText, WritesTheSameWhateverTheStreamsLocaleAndFlags) {
    const Triangulation surface = families::random(150, 1, 7);
    EXPECT_EQ(testing::written_to_hostile_stream([&](auto& out) { write_text(out, surface); }),
              text_of(surface));
    const auto table = [&](std::ostream& out) {
        write_table(out, surface.table(), surface.vertex_count());
    };
    std::ostringstream plain;
    table(plain);
    EXPECT_EQ(testing::written_to_hostile_stream(table), plain.str());
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Gluing gluing = garbage_gluing(seed);
        const std::string text =
            testing::written_to_hostile_stream([&](auto& out) { write_text(out, gluing); });
        EXPECT_EQ(text, text_of(gluing)) << "seed " << seed;
        EXPECT_EQ(parse(text), RawSurface(gluing)) << "seed " << seed;
    }
}

TEST(SurfaceText, IgnoresCommentsBlankLinesAndLineEndings) {
    for (const std::string& text : {table_text, gluing_text, text_of(families::random(9, 1, 4)),
                                    text_of(testing::klein_bottle())}) {
        const RawSurface expected = parse(text);
        EXPECT_EQ(parse(replaced_everywhere(text, "\n", "\r\n")), expected);
        EXPECT_EQ(parse(replaced_everywhere(text, "\n", " # 1 2 end\n\n#\n \t\n")), expected);
        EXPECT_EQ(parse(replaced_everywhere(text, " ", " \t ")), expected);
        EXPECT_EQ(parse("\n# a comment before the header\n" + text + "\n# and after the end\n\n"),
                  expected);
        EXPECT_EQ(parse(text.substr(0, text.size() - 1)), expected) << "without the last newline";
    }
}

TEST(SurfaceText, TheRawSurfaceIsJudgedAndBuiltLikeItsContent) {
    const Gluing gluing = testing::pinched_tetrahedra();
    EXPECT_EQ(audit(RawSurface(gluing)).topology, audit(gluing).topology);
    EXPECT_TRUE(audit(RawSurface(gluing)).has(ViolationCode::vertex_with_several_fans));
    EXPECT_FALSE(build(RawSurface(gluing)));
    EXPECT_TRUE(audit(RawSurface(gluing)).degrees.has_value());
    EXPECT_FALSE(audit(RawSurface(gluing), {.statistics = false}).degrees.has_value());

    const RawSurface table(RawTable{3, two_face_records});
    EXPECT_TRUE(audit(table).is_valid());
    EXPECT_FALSE(audit(RawSurface(RawTable{4, two_face_records})).is_valid());
    EXPECT_EQ(build(RawSurface(testing::octahedron())).value(),
              build(testing::octahedron()).value());
}

// ---- refusals ----

struct Malformed {
    const char* name;
    std::string text;
    std::uint64_t line;
    const char* word;
};

void PrintTo(const Malformed& malformed, std::ostream* out) {
    *out << malformed.name;
}

/// One of the two texts above with one piece of it replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

class MalformedSurfaceText : public ::testing::TestWithParam<Malformed> {};

TEST_P(MalformedSurfaceText, IsRefusedWithLineAndReason) {
    const auto refusal = refusal_of([&] { return parse(GetParam().text); });
    expect_refused_in_line(refusal, GetParam().line, GetParam().word);
    ASSERT_TRUE(refusal);
    EXPECT_EQ(refusal->source(), "test.tft");
}

INSTANTIATE_TEST_SUITE_P(
    Files, MalformedSurfaceText,
    ::testing::Values(
        Malformed{"Empty", "", 1, "ends"}, Malformed{"OnlyComments", "# none\n\n#\n", 3, "ends"},
        Malformed{"Foreign", "OFF\n3 1 0\n", 1, "formats"},
        Malformed{"ForeignAfterBlankLines", "\n\nsolid cube\n", 3, "formats"},
        Malformed{"HeaderInCapitals", with(table_text, "tight", "Tight"), 1, "formats"},
        Malformed{"HeaderTooLong", with(gluing_text, "gluing", "gluings"), 1, "formats"},
        Malformed{"BinaryGarbage", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), 1, "formats"},
        Malformed{"VersionTwo", with(table_text, " 1\n", " 2\n"), 1, "version"},
        Malformed{"VersionTwoOfGluing", with(gluing_text, " 1\n", " 2\n"), 1, "version"},
        Malformed{"VersionZero", with(table_text, " 1\n", " 0\n"), 1, "version"},
        Malformed{"VersionMissing", with(table_text, " 1\n", "\n"), 1, "version"},
        Malformed{"VersionInWords", with(gluing_text, " 1\n", " one\n"), 1, "version"},
        Malformed{"VersionWithMore", with(table_text, " 1\n", " 1 beta\n"), 1, "beta"},
        Malformed{"OnlyHeader", "tightflip-triangulation 1\n", 1, "vertices"},
        Malformed{"OnlyHeaderOfGluing", "tightflip-gluing 1\n", 1, "vertices"},
        Malformed{"VerticesMissing", with(table_text, "vertices 3\n", ""), 2, "vertices"},
        Malformed{"VertexCountMissing", with(table_text, " 3\n", "\n"), 2, "number of vertices"},
        Malformed{"VertexCountNegative", with(table_text, " 3\n", " -3\n"), 2, "-3"},
        Malformed{"VertexCountTooLarge", with(gluing_text, " 3\n", " 2147483648\n"), 2,
                  "2147483648"},
        Malformed{"VertexCountNoNumber", with(gluing_text, " 3\n", " 3.0\n"), 2, "3.0"},
        Malformed{"VertexCountTwice", with(table_text, " 3\n", " 3 3\n"), 2, "goes on with"},
        Malformed{"HalfedgesMissing", with(table_text, "halfedges 6\n", ""), 3, "halfedges"},
        Malformed{"HalfedgeCountMissing", with(table_text, " 6\n", "\n"), 3, "count"},
        Malformed{"HalfedgeCountNegative", with(table_text, " 6\n", " -6\n"), 3, "-6"},
        Malformed{"HalfedgeCountHuge", with(table_text, " 6\n", " 2147483647\n"), 3, "announced"},
        Malformed{"HalfedgeCountBeyondIndices", with(table_text, " 6\n", " 99999999999\n"), 3,
                  "99999999999"},
        Malformed{"HalfedgeCountTooLarge", with(table_text, " 6\n", " 7\n"), 10, "next halfedge"},
        Malformed{"HalfedgeCountTooSmall", with(table_text, " 6\n", " 5\n"), 9, "'end'"},
        Malformed{"FacesMissing", with(gluing_text, "faces 2\n", ""), 3, "faces"},
        Malformed{"HalfedgesInGluing", with(gluing_text, "faces 2\n", "halfedges 2\n"), 3, "faces"},
        Malformed{"FaceCountNegative", with(gluing_text, "faces 2\n", "faces -1\n"), 3, "-1"},
        Malformed{"FaceCountHuge", with(gluing_text, "faces 2\n", "faces 357913940\n"), 3,
                  "announced"},
        Malformed{"FaceCountTooLarge", with(gluing_text, "faces 2\n", "faces 3\n"), 6, "corner"},
        Malformed{"FaceCountTooSmall", with(gluing_text, "faces 2\n", "faces 1\n"), 5, "'end'"},
        Malformed{"RecordInWords", with(table_text, "5 1\n", "five 1\n"), 5, "five"},
        Malformed{"RecordTooShort", with(table_text, "5 1\n", "5\n"), 5, "origin"},
        Malformed{"RecordTooLong", with(table_text, "5 1\n", "5 1 0\n"), 5, "goes on with"},
        Malformed{"RecordTooLarge", with(table_text, "5 1\n", "5 3000000000\n"), 5, "3000000000"},
        Malformed{"RecordNotWhole", with(table_text, "5 1\n", "5.5 1\n"), 5, "5.5"},
        Malformed{"CornerNan", with(gluing_text, "0 2 1", "0 nan 1"), 5, "nan"},
        Malformed{"FaceWithoutSides", with(gluing_text, "  2 1 0", ""), 5, "side"},
        Malformed{"FaceWithTwoSides", with(gluing_text, "  2 1 0", "  2 1"), 5, "side"},
        Malformed{"FaceWithFourSides", with(gluing_text, "  2 1 0", "  2 1 0 0"), 5,
                  "goes on with"},
        Malformed{"SideOnlyTilde", with(gluing_text, "  2 1 0", "  2 ~ 0"), 5, "side"},
        Malformed{"SideTwoTildes", with(gluing_text, "  2 1 0", "  2 1~~ 0"), 5, "side"},
        Malformed{"SideTildeFirst", with(gluing_text, "  2 1 0", "  2 ~1 0"), 5, "side"},
        Malformed{"SideUngluedReversed", with(gluing_text, "  2 1 0", "  2 -~ 0"), 5, "side"},
        Malformed{"SideTwoDashes", with(gluing_text, "  2 1 0", "  2 -- 0"), 5, "side"},
        Malformed{"SideNotWhole", with(gluing_text, "  2 1 0", "  2 1.0 0"), 5, "side"},
        Malformed{"SideTooLarge", with(gluing_text, "  2 1 0", "  2 2147483648 0"), 5, "side"},
        Malformed{"ZeroByteInNumber", with(table_text, "5 1\n", std::string("5\0 1\n", 5)), 5,
                  "whole number"},
        Malformed{"EndMissing", with(table_text, "end\n", ""), 9, "'end'"},
        Malformed{"EndMissingInGluing", with(gluing_text, "end\n", ""), 5, "'end'"},
        Malformed{"EndWithMore", with(table_text, "end\n", "end of file\n"), 10, "of"},
        Malformed{"TextAfterEnd", table_text + "\nmore\n", 12, "nothing should follow"},
        Malformed{"SecondSurface", gluing_text + gluing_text, 7, "nothing should follow"}),
    [](const auto& instance) { return std::string(instance.param.name); });

TEST(SurfaceText, RefusesEveryTruncation) {
    for (const std::string& text : {table_text, gluing_text, text_of(families::random(6, 1, 1)),
                                    text_of(testing::klein_bottle())}) {
        for (std::size_t size = 0; size + 1 < text.size(); ++size) {
            const auto refusal = refusal_of([&] { return parse(text.substr(0, size)); });
            ASSERT_TRUE(refusal) << "the first " << size << " bytes of\n" << text;
            EXPECT_EQ(refusal->unit(), FileError::Unit::line);
        }
    }
}

TEST(SurfaceText, DamagedBytesAreRefusedOrReadButNothingElse) {
    const std::vector<std::string> texts{table_text, gluing_text,
                                         text_of(families::random(6, 1, 1)),
                                         text_of(testing::klein_bottle())};
    RandomStream random(20240607);
    std::size_t refused = 0;
    std::size_t accepted = 0;
    for (int run = 0; run < 20000; ++run) {
        std::string text = texts[random.below(static_cast<std::uint32_t>(texts.size()))];
        for (auto damages = 1 + random.below(3); damages > 0; --damages) {
            const auto at = random.below(static_cast<std::uint32_t>(text.size()));
            // Half of the damage looks like the format, so that some of it gets past the reader.
            text[at] = random.below(2) == 0 ? "0123456789 -~#\n"[random.below(15)]
                                            : static_cast<char>(random.below(256));
        }
        RawSurface raw;
        if (refusal_of([&] { raw = parse(text); })) {
            ++refused;
            continue;
        }
        ++accepted;
        EXPECT_EQ(audit(raw).is_valid(), static_cast<bool>(build(raw))) << text;
    }
    EXPECT_GT(refused, 1000U);
    EXPECT_GT(accepted, 1000U);
}

}  // namespace
}  // namespace tightflip::kernel
