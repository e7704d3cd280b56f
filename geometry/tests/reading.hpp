/// \file
/// Reading texts in tests: what a soup holds in one comparable value, and how a refusal reads.
#pragma once

#include <tightflip/geometry/mesh_file.hpp>

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {

using Triangles = std::vector<std::array<Index, 3>>;
using Positions = std::vector<std::uint64_t>;

/// A file that must be refused: where, and a word of the reason.
struct BadFile {
    std::string text;
    FileError::Unit unit;
    std::uint64_t position;
    std::string word;
};

inline BadFile at_line(std::uint64_t line, std::string text, std::string word) {
    return {std::move(text), FileError::Unit::line, line, std::move(word)};
}
inline BadFile at_byte(std::uint64_t byte, std::string text, std::string word) {
    return {std::move(text), FileError::Unit::byte, byte, std::move(word)};
}
inline BadFile as_a_whole(std::string text, std::string word) {
    return {std::move(text), FileError::Unit::none, 0, std::move(word)};
}

inline void expect_refused(const std::vector<BadFile>& files, const std::string& name,
                           const MeshFileOptions& options) {
    for (const BadFile& file : files) {
        SCOPED_TRACE(file.word + " in\n" + file.text.substr(0, 300));
        try {
            (void)read_mesh(std::string_view(file.text), name, options);
            ADD_FAILURE() << "was read";
        } catch (const FileError& error) {
            EXPECT_EQ(error.source(), name);
            EXPECT_EQ(error.unit(), file.unit) << error.what();
            EXPECT_EQ(error.position(), file.position) << error.what();
            EXPECT_THAT(error.reason(), testing::HasSubstr(file.word));
        }
    }
}

inline const Triangles tetrahedron_faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// Whether a soup is the tetrahedron with its corners at the origin and on the axes.
inline void expect_tetrahedron(const TriangleSoup& soup) {
    const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    EXPECT_EQ(soup.points, points);
    EXPECT_EQ(soup.triangles, tetrahedron_faces);
    EXPECT_EQ(soup.point_positions.size(), 4U);
    EXPECT_EQ(soup.triangle_positions.size(), 4U);
}

}  // namespace tightflip::geometry
