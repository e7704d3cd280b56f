/// \file
/// All embedded triangulations of a few points in space, and what conventional flips join (Alboul
/// et al., section 4.2.1, the remark on [AAH00]).
///
/// A conventional flip replaces the edge ab between the faces abc and bad by cd where the graph has
/// no edge cd yet, and is done only where the surface stays free of self-intersections. So it walks
/// among the simple embedded triangulations, here of the sphere, whose vertices are all the points.
#pragma once

#include <tightflip/geometry/surface.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tightflip::properties {

using kernel::Index;

/// Faces on the vertices 0 to 7, whatever their orientation: bit number
/// a + b (b - 1) / 2 + c (c - 1) (c - 2) / 6 stands for the face with the corners a < b < c.
using FaceSet = std::uint64_t;

/// The corners of each face, ascending; faces in the order of their bits.
[[nodiscard]] std::vector<std::array<Index, 3>> faces_of(FaceSet faces);

/// All simple labelled triangulations of the sphere with 4 to 8 vertices, ascending: 1, 10, 195,
/// 5712 and 223440 of them. Found by flips that keep the graph simple, under which they are
/// connected (Wagner 1936). For 8 vertices some 0.3 s and 10 MB. Throws std::invalid_argument for
/// other numbers of vertices.
[[nodiscard]] std::vector<FaceSet> simple_spheres(Index vertices);

/// What keeps a conventional flip from being done.
enum class FlipObstacle : std::uint8_t {
    none,
    parallel_edge,      ///< the new edge joins two neighbours
    self_intersection,  ///< the graph stays simple, but faces would meet beyond what they share
};

/// The flip of an edge in a simple triangulation.
struct ConventionalFlip {
    std::array<Index, 2> edge;      ///< ascending
    std::array<Index, 2> new_edge;  ///< ascending
    FaceSet result = 0;             ///< empty for a parallel edge, which a set cannot tell
    FlipObstacle obstacle = FlipObstacle::none;
};

/// The embedded ones among all simple triangulations of the sphere on given points.
class EmbeddedTriangulations {
public:
    /// Throws std::invalid_argument for less than 4 or more than 8 points, and where they are not
    /// finite or not in general position, naming the points. Compares all pairs of faces exactly,
    /// sweeps once over all spheres and flips every edge of the embedded ones: some 10 ms for 8
    /// points (beside `simple_spheres`), of whose 223440 spheres some 2000 are embedded.
    explicit EmbeddedTriangulations(const std::vector<geometry::Point>& points);
    /// The same with the spheres on that many vertices at hand, for who asks of many sets of
    /// points.
    EmbeddedTriangulations(std::vector<geometry::Point> points, std::span<const FaceSet> spheres);

    /// Ascending.
    [[nodiscard]] const std::vector<FaceSet>& all() const noexcept { return all_; }
    /// What conventional flips join: each component ascending, the smallest first.
    [[nodiscard]] const std::vector<std::vector<FaceSet>>& components() const noexcept {
        return components_;
    }
    /// Whether no two of the faces meet beyond what they share.
    [[nodiscard]] bool are_embedded(FaceSet faces) const noexcept;
    /// The flip of every edge of a simple sphere, in ascending order of edges.
    [[nodiscard]] std::vector<ConventionalFlip> flips(FaceSet sphere) const;
    /// One of `all` as a surface on the points, its faces counter-clockwise seen from outside
    /// (decided exactly). Throws std::invalid_argument for any other set.
    [[nodiscard]] geometry::Surface surface(FaceSet sphere) const;

private:
    void find_components();

    std::vector<geometry::Point> points_;
    std::array<FaceSet, 64> conflicts_;  // by the bit of a face, those it meets
    std::vector<FaceSet> all_;
    std::vector<std::vector<FaceSet>> components_;
};

}  // namespace tightflip::properties
