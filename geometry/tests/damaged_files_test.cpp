/// \file
/// Damage in every place of a small file of every format: it is read as something valid or refused
/// with a FileError, in memory that its size bounds.
#include "allocation_count.hpp"
#include "reading.hpp"
#include "samples.hpp"
#include <tightflip/geometry/soup_gluing.hpp>
#include <tightflip/kernel/random.hpp>

namespace tightflip::geometry {
namespace {

/// Reads, and says whether the file was read. Anything but a sound soup or a FileError fails.
bool survives(const std::string& bytes, const std::string& name, const MeshFileOptions& options) {
    const std::size_t before = bytes_requested();
    bool was_read = false;
    try {
        const TriangleSoup soup = read_mesh(std::string_view(bytes), name, options);
        was_read = true;
        EXPECT_FALSE(soup.triangles.empty());
        EXPECT_EQ(soup.triangles.size(), soup.triangle_positions.size());
        EXPECT_EQ(soup.points.size(), soup.point_positions.size());
        for (const auto& triangle : soup.triangles) {
            for (const Index corner : triangle) {
                EXPECT_TRUE(corner >= 0 && corner < soup.vertex_count()) << corner;
            }
        }
        for (const auto& point : soup.points)
            EXPECT_TRUE(point.allFinite());
        EXPECT_TRUE(soup.glued_sides.empty() || soup.glued_sides.size() == soup.triangles.size());
        for (const auto& sides : soup.glued_sides) {
            for (const Index side : sides)
                EXPECT_TRUE(side >= -1 && side < 3 * std::ssize(soup.triangles)) << side;
        }
        (void)audit(glue(soup));
    } catch (const FileError& error) {
        EXPECT_EQ(error.source(), name);
        EXPECT_FALSE(error.reason().empty());
        if (error.unit() == FileError::Unit::byte) {
            EXPECT_LE(error.position(), bytes.size());
        }
        if (error.unit() == FileError::Unit::line) {
            EXPECT_GE(error.position(), 1U);
            EXPECT_LE(error.position(),
                      1U + static_cast<std::size_t>(std::ranges::count(bytes, '\n')));
        }
    }
    EXPECT_LE(bytes_requested() - before, 16384 + 64 * bytes.size());
    return was_read;
}

const std::vector<MeshFileOptions> both_ways{{}, {.triangulate_polygons = true}};

TEST(DamagedFiles, EveryPrefixIsReadOrRefused) {
    for (const auto& [name, bytes] : samples::all()) {
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            SCOPED_TRACE(name + " cut after " + std::to_string(size) + " bytes");
            const bool was_read = survives(bytes.substr(0, size), name, {});
            // Of all the formats only OBJ cannot tell that faces are missing. The others may lose
            // nothing but the line feed (and STL the name) after the last word.
            const bool nothing_lost =
                name == "text.stl" ? size >= bytes.rfind("endsolid") + 8 : size == bytes.size() - 1;
            const bool is_text = name.starts_with("text");
            if (name != "text.obj") {
                EXPECT_EQ(was_read, is_text && nothing_lost);
            }
        }
    }
}

TEST(DamagedFiles, EveryByteMayBecomeAnother) {
    for (const auto& [name, bytes] : samples::all()) {
        kernel::RandomStream random(20240607);
        for (std::size_t at = 0; at < bytes.size(); ++at) {
            for (int repeat = 0; repeat < 16; ++repeat) {
                std::string damaged = bytes;
                damaged[at] = static_cast<char>(random.below(256));
                SCOPED_TRACE(name + ", byte " + std::to_string(at) + ", try " +
                             std::to_string(repeat));
                survives(damaged, name, both_ways[random.below(2)]);
            }
        }
    }
}

TEST(DamagedFiles, ManyBytesMayBecomeOthersAtOnce) {
    constexpr std::string_view telling = "0123456789-+.eEnaif \n\r\t/#\\\0\xff";
    for (const auto& [name, bytes] : samples::all()) {
        kernel::RandomStream random(7);
        for (int repeat = 0; repeat < 3000; ++repeat) {
            std::string damaged = bytes;
            for (auto flips = 1 + random.below(8); flips > 0; --flips) {
                const auto at = random.below(static_cast<std::uint32_t>(damaged.size()));
                damaged[at] = telling[random.below(static_cast<std::uint32_t>(telling.size()))];
            }
            SCOPED_TRACE(name + ", try " + std::to_string(repeat));
            survives(damaged, name, both_ways[random.below(2)]);
        }
    }
}

TEST(DamagedFiles, HugeCountsTakeNoMemory) {
    const auto with = [](std::string text, std::string_view from, std::string_view to) {
        return text.replace(text.find(from), from.size(), to);
    };
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4000000000\n";
    for (const std::string count : {"1000", "4000000000", "9223372036854775807"}) {
        for (const auto& [name, bytes] : std::vector<samples::Sample>{
                 {"a.off", with(samples::off(), "4 4", count + " 4")},
                 {"a.off", with(samples::off(), "4 4", "4 " + count)},
                 {"a.off", with(samples::off(), "3 0 2 1", count + " 0 2 1")},
                 {"a.ply", with(samples::ply_ascii(), "vertex 4", "vertex " + count)},
                 {"a.ply", with(samples::ply_ascii(), "face 4", "face " + count)},
                 {"a.ply", with(samples::ply_ascii(), "3 0 2 1", count + " 0 2 1")},
                 {"a.ply", with(samples::ply_binary(std::endian::big), "face 4", "face " + count)},
                 {"a.ply", with(samples::ply_glued("ascii"), "3 9 6 3", count + " 9 6 3")},
                 {"a.ply", with(samples::ply_glued("ascii"), "3 9 6 3", "3 9 6 " + count)},
                 {"a.obj", with(obj, "4000000000", count)}}) {
            SCOPED_TRACE(name + "\n" + bytes.substr(0, 400));
            EXPECT_FALSE(survives(bytes, name, {.triangulate_polygons = true}));
        }
    }
}

}  // namespace
}  // namespace tightflip::geometry
