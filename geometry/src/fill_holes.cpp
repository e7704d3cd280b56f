#include "fill_holes.hpp"

#include <tightflip/geometry/soup_gluing.hpp>

#include <algorithm>
#include <limits>
#include <span>

namespace tightflip::geometry {
namespace {

using Side = Index;

/// The boundary sides as the edges of a graph, and a walk over each of them once. Directions do not
/// matter: the faces need not be oriented alike.
class BoundaryWalk {
public:
    explicit BoundaryWalk(const TriangleSoup& soup) : soup_(soup) {
        const kernel::FaceListReading reading = glue(soup);
        std::vector<bool> is_ambiguous(3 * soup.triangles.size(), false);
        for (const Side side : ambiguous_sides(reading))
            is_ambiguous[static_cast<std::size_t>(side)] = true;
        for (Side s = 0; s < 3 * std::ssize(soup.triangles); ++s) {
            const auto& face = reading.gluing.faces[static_cast<std::size_t>(s / 3)];
            const bool is_open = !face.sides[static_cast<std::size_t>(s % 3)].is_glued();
            if (!is_open || is_ambiguous[static_cast<std::size_t>(s)] || start(s) == end(s))
                continue;
            at_vertex_.push_back({start(s), s});
            at_vertex_.push_back({end(s), s});
        }
        std::ranges::sort(at_vertex_, {},
                          [](const Incidence& i) { return std::pair(i.vertex, i.side); });
        next_at_.resize(soup.points.size(), at_vertex_.size());
        for (std::size_t i = at_vertex_.size(); i > 0; --i)
            next_at_[static_cast<std::size_t>(at_vertex_[i - 1].vertex)] = i - 1;
        is_used_.resize(3 * soup.triangles.size(), false);
        place_on_path_.resize(soup.points.size(), absent);
    }

    [[nodiscard]] Index start(Side s) const { return corner(s / 3, s % 3); }
    [[nodiscard]] Index end(Side s) const { return corner(s / 3, (s + 1) % 3); }

    /// The sides of each loop that passes no vertex twice, in their order about the hole.
    [[nodiscard]] std::vector<std::vector<Side>> loops() {
        std::vector<std::vector<Side>> found;
        for (const Incidence& incidence : at_vertex_)
            walk_from(incidence.vertex, found);
        return found;
    }
    [[nodiscard]] Index side_count() const {
        return static_cast<Index>(std::ssize(at_vertex_) / 2);
    }

private:
    struct Incidence {
        Index vertex;
        Side side;
    };
    struct Step {
        Index from;
        Side side;
    };
    static constexpr std::size_t absent = std::numeric_limits<std::size_t>::max();

    [[nodiscard]] Index corner(Index face, Index i) const {
        return soup_.triangles[static_cast<std::size_t>(face)][static_cast<std::size_t>(i)];
    }

    /// Sides that join the same two vertices as two or more others: no boundary, but a fault.
    [[nodiscard]] std::vector<Side> ambiguous_sides(const kernel::FaceListReading& reading) const {
        std::vector<Side> sides;
        for (const kernel::Violation& violation : reading.violations) {
            const auto ends = std::minmax({start(violation.place), end(violation.place)});
            for (const std::int64_t face : violation.witness) {
                for (Index i = 0; i < 3; ++i) {
                    const Side s = kernel::side_of(static_cast<Index>(face), static_cast<int>(i));
                    if (std::minmax({start(s), end(s)}) == ends) sides.push_back(s);
                }
            }
        }
        return sides;
    }

    /// A side at the vertex that was not walked yet, or -1.
    Side take_side(Index vertex) {
        std::size_t& next = next_at_[static_cast<std::size_t>(vertex)];
        while (next < at_vertex_.size() && at_vertex_[next].vertex == vertex) {
            const Side side = at_vertex_[next++].side;
            if (is_used_[static_cast<std::size_t>(side)]) continue;
            is_used_[static_cast<std::size_t>(side)] = true;
            return side;
        }
        return -1;
    }

    /// Walks on as long as there are sides; what closes is cut off as a loop.
    void walk_from(Index vertex, std::vector<std::vector<Side>>& found) {
        std::vector<Step> path;
        place_on_path_[static_cast<std::size_t>(vertex)] = 0;
        for (Side s = take_side(vertex); s >= 0; s = take_side(vertex)) {
            path.push_back({vertex, s});
            vertex = start(s) == vertex ? end(s) : start(s);
            std::size_t& place = place_on_path_[static_cast<std::size_t>(vertex)];
            if (place == absent) {
                place = path.size();
            } else {
                cut_loop(path, place, found);
            }
        }
        for (const Step& step : path)
            place_on_path_[static_cast<std::size_t>(step.from)] = absent;
        place_on_path_[static_cast<std::size_t>(vertex)] = absent;
    }

    /// The part of the path since it first came by becomes a loop.
    void cut_loop(std::vector<Step>& path, std::size_t place,
                  std::vector<std::vector<Side>>& found) {
        std::vector<Side>& loop = found.emplace_back();
        for (std::size_t i = place; i < path.size(); ++i) {
            loop.push_back(path[i].side);
            if (i > place) place_on_path_[static_cast<std::size_t>(path[i].from)] = absent;
        }
        path.resize(place);
    }

    const TriangleSoup& soup_;
    std::vector<Incidence> at_vertex_;
    std::vector<std::size_t> next_at_;  // of a vertex, its next incidence that was not looked at
    std::vector<bool> is_used_;
    std::vector<std::size_t> place_on_path_;
};

/// The fan's vertex, within the range of its corners.
Eigen::Vector3d mean_of_corners(const TriangleSoup& soup, const BoundaryWalk& walk,
                                std::span<const Side> loop) {
    constexpr double largest = std::numeric_limits<double>::max();
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Side s : loop) {
        for (const Index v : {walk.start(s), walk.end(s)}) {
            mean +=
                soup.points[static_cast<std::size_t>(v)] / (2 * static_cast<double>(loop.size()));
        }
    }
    return mean.cwiseMin(largest).cwiseMax(-largest);
}

/// A face over each side, turned against it, and its two other sides to its neighbours in the fan.
void add_fan(TriangleSoup& soup, const BoundaryWalk& walk, std::span<const Side> loop) {
    const Index hub = soup.vertex_count();
    const auto first = static_cast<Index>(soup.triangles.size());
    const auto n = static_cast<Index>(loop.size());
    const auto position = [&](Side s) {
        return soup.triangle_positions[static_cast<std::size_t>(s / 3)];
    };
    soup.points.push_back(mean_of_corners(soup, walk, loop));
    soup.point_positions.push_back(position(loop.front()));
    const bool is_glued = !soup.glued_sides.empty();
    for (Index i = 0; i < n; ++i) {
        const Side s = loop[static_cast<std::size_t>(i)];
        const Side before = loop[static_cast<std::size_t>((i + n - 1) % n)];
        const Side after = loop[static_cast<std::size_t>((i + 1) % n)];
        const Index a = walk.start(s);
        const Index b = walk.end(s);
        soup.triangle_positions.push_back(position(s));
        if (is_glued) {
            // Side 1 of the new face starts at a, side 2 ends at b.
            const bool goes_along = a == walk.start(before) || a == walk.end(before);
            const auto spoke = [&](Index face, Side of, Index vertex) {
                return kernel::side_of(first + face, walk.start(of) == vertex ? 1 : 2);
            };
            const Index earlier = (i + n - 1) % n;
            const Index later = (i + 1) % n;
            const Index at_a = goes_along ? spoke(earlier, before, a) : spoke(later, after, a);
            const Index at_b = goes_along ? spoke(later, after, b) : spoke(earlier, before, b);
            soup.glued_sides.push_back({s, at_a, at_b});
            soup.glued_sides[static_cast<std::size_t>(s / 3)][static_cast<std::size_t>(s % 3)] =
                kernel::side_of(first + i, 0);
        }
        soup.triangles.push_back({b, a, hub});
    }
}

}  // namespace

FilledHoles fill_holes(TriangleSoup& soup) {
    BoundaryWalk walk(soup);
    const std::vector<std::vector<Side>> loops = walk.loops();
    FilledHoles filled;
    for (const auto& loop : loops)
        filled.faces += static_cast<Index>(loop.size());
    filled.holes = static_cast<Index>(loops.size());
    filled.sides_left_open = walk.side_count() - filled.faces;
    if (filled.faces > kernel::max_faces - static_cast<Index>(soup.triangles.size())) {
        throw FileError(soup.source, "closing its boundary would make more than " +
                                         std::to_string(kernel::max_faces) + " faces");
    }
    for (const auto& loop : loops)
        add_fan(soup, walk, loop);
    return filled;
}

}  // namespace tightflip::geometry
