/// \file
/// Surfaces that are hard to write, and reading back what was written.
#pragma once

#include "shapes.hpp"
#include <tightflip/geometry/mesh_writer.hpp>
#include <tightflip/geometry/soup_gluing.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <bit>
#include <limits>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace tightflip::geometry {

/// A tetrahedron with the coordinates that are easily lost: -0, the least and largest doubles,
/// numbers that need all their digits.
inline Surface surface_of_odd_numbers() {
    constexpr double least = std::numeric_limits<double>::denorm_min();
    constexpr double most = std::numeric_limits<double>::max();
    return make_surface({{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}},
                        {{-0.0, least, -most},
                         {1e300, -1e-300, 0.1 + 0.2},
                         {1.0 / 3, 5 * least, 123456789.123456789},
                         {2.2250738585072011e-308, most, -0.0}});
}

/// Equal bit by bit, so that -0 is not 0.
inline void expect_same_points(Points found, Points expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t v = 0; v < found.size(); ++v) {
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(std::bit_cast<std::uint64_t>(found[v][axis]),
                      std::bit_cast<std::uint64_t>(expected[v][axis]))
                << "vertex " << v << ", axis " << axis << ": " << found[v][axis] << ", not "
                << expected[v][axis];
        }
    }
}

inline void expect_same_surface(const Surface& found, const Surface& expected) {
    EXPECT_TRUE(same_labelled_surface(found.triangulation(), expected.triangulation()));
    expect_same_points(found.points(), expected.points());
}

inline std::string written(const Surface& surface, MeshFormat format,
                           const MeshWriteOptions& options = {}) {
    std::ostringstream out;
    write_mesh(out, surface.view(), format, options);
    return out.str();
}

/// Reads a mesh, which must be a valid surface with its faces oriented alike.
inline Surface read_back(const std::string& bytes, MeshFormat format) {
    TriangleSoup soup = read_mesh(bytes, "written", {.format = format});
    const kernel::FaceListReading reading = glue(soup);
    EXPECT_TRUE(reading.violations.empty());
    EXPECT_TRUE(audit(reading).coherently_stored);
    return {kernel::build(reading.gluing).value(), std::move(soup.points)};
}

/// Whether corners alone say which sides are glued.
inline bool has_parallel_edges(const Triangulation& surface) {
    return kernel::audit(surface).parallels.value().pairs_joined_twice > 0;
}

}  // namespace tightflip::geometry
