/// \file
/// The convex cones of all stars of a surface, kept so that what a flip does to them is quick to
/// say, and kept too what was said as long as it holds.
#pragma once

#include <tightflip/geometry/convex_cone.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/surface.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace tightflip::geometry {

/// Positive curvatures omega+ and, behind them, the extreme rays of each star's cone as a ring of
/// halfedges. Exact signs, floating angles; curvature.hpp has the definitions.
class StarCones {
public:
    explicit StarCones(const SurfaceView& surface);

    /// omega+ of the origin of `h`.
    [[nodiscard]] double positive_curvature(Halfedge h) const { return star(h).positive; }

    /// By how much omega+ of the origin of `h` would change without the edge of `h`.
    [[nodiscard]] double change_without(Halfedge h) {
        double& kept = ray(h).change_without;
        if (std::isnan(kept)) kept = find_change_without(h);
        return kept;
    }
    /// By how much omega+ of the corner opposite `h` in its face would change with one more edge,
    /// across `h` to the corner opposite it in the face beyond.
    [[nodiscard]] double change_across(Halfedge h) {
        double& kept = ray(h).change_across;
        if (std::isnan(kept)) kept = find_change_across(h);
        return kept;
    }

    /// To be called after each flip or unflip, done while no other was left unreported.
    void flipped(Edge e);

    /// The edges with a change among their halfedges' that may be another since the last flip;
    /// some more than once.
    [[nodiscard]] std::span<const Edge> affected() const { return affected_; }

private:
    struct Star {
        double positive = 0;
        Halfedge first;       ///< an extreme ray; none where there is no ray or no cone
        Index ray_count = 0;  ///< how many are extreme
        bool is_pointed = true;
        std::array<Halfedge, 4> line;  ///< where not pointed, rays that contain a line
    };
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    struct Ray {
        // Of a halfedge that is an extreme ray: its neighbours in the ring, counter-clockwise, and
        // the angle to the one after it. Of others, none.
        Halfedge next;
        Halfedge previous;
        double angle = 0;
        // What was said of the halfedge, or unknown.
        double change_without = unknown;
        double change_across = unknown;

        [[nodiscard]] bool is_extreme() const { return next.is_valid(); }
    };

    [[nodiscard]] const Star& star(Halfedge h) const {
        return stars_[static_cast<std::size_t>(kernel::at(surface_.table, h).origin.id)];
    }
    [[nodiscard]] const Ray& ray(Halfedge h) const { return rays_[static_cast<std::size_t>(h.id)]; }
    [[nodiscard]] Ray& ray(Halfedge h) { return rays_[static_cast<std::size_t>(h.id)]; }

    /// What became of the star of one vertex: an edge to `target` more, or less.
    struct Change {
        const Point& target;
        bool is_gain;
    };

    void update(Halfedge h, const Change& change);
    void forget_without(Halfedge h);
    void forget_across(Halfedge h);
    void forget_line(const Star& star);
    void forget_in_front_of(Halfedge h, const Point& target);
    [[nodiscard]] bool has_behind(Halfedge extreme, const Point& apex, const Point& target) const;
    [[nodiscard]] bool may_lose(Halfedge at, Edge lost) const;
    [[nodiscard]] bool may_gain(Halfedge gained) const;
    [[nodiscard]] Sign beyond(Halfedge side, const Point& apex, const Point& x) const;
    [[nodiscard]] Halfedge side_seen_from(const Star& star, const Point& apex,
                                          const Point& x) const;

    [[nodiscard]] double find_change_without(Halfedge h);
    [[nodiscard]] double find_change_across(Halfedge side);
    void read_star(Halfedge h, Halfedge left_out);
    [[nodiscard]] double positive_curvature_of_cone(const Point& apex) const;
    [[nodiscard]] double from_scratch(Halfedge h, Halfedge left_out, const Point* added);

    SurfaceView surface_;
    std::vector<Star> stars_;  // by vertex
    std::vector<Ray> rays_;    // by halfedge
    ConvexCone cone_;
    std::vector<Point> targets_;
    std::vector<Halfedge> halfedges_;  // of the targets
    std::vector<Ray> before_;          // of the targets
    std::vector<Edge> affected_;
};

}  // namespace tightflip::geometry
