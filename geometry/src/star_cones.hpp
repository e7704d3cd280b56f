/// \file
/// The convex cones of all stars of a surface, kept so that what a flip does to them is quick to
/// say.
#pragma once

#include <tightflip/geometry/convex_cone.hpp>
#include <tightflip/geometry/surface.hpp>

#include <array>
#include <cstddef>
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
    [[nodiscard]] double change_without(Halfedge h);
    /// By how much it would change with one more edge, from the origin of `h` to `target`.
    [[nodiscard]] double change_with(Halfedge h, const Point& target);

    /// Looks at the star of the origin of `h` again.
    void update(Halfedge h);

private:
    struct Star {
        double positive = 0;
        Halfedge first;       ///< an extreme ray; none where there is no ray or no cone
        Index ray_count = 0;  ///< how many are extreme
        bool is_pointed = true;
        std::array<Halfedge, 4> line;  ///< where not pointed, rays that contain a line
    };
    /// Of a halfedge that is an extreme ray: its neighbours in the ring, counter-clockwise, and
    /// the angle to the one after it. Of others, none.
    struct Ray {
        Halfedge next;
        Halfedge previous;
        double angle = 0;
    };

    [[nodiscard]] const Star& star(Halfedge h) const {
        return stars_[static_cast<std::size_t>(kernel::at(surface_.table, h).origin.id)];
    }
    [[nodiscard]] const Ray& ray(Halfedge h) const { return rays_[static_cast<std::size_t>(h.id)]; }
    [[nodiscard]] Ray& ray(Halfedge h) { return rays_[static_cast<std::size_t>(h.id)]; }

    void read_star(Halfedge h, Halfedge left_out);
    [[nodiscard]] double positive_curvature_of_cone(const Point& apex) const;
    [[nodiscard]] double from_scratch(Halfedge h, Halfedge left_out, const Point* added);

    SurfaceView surface_;
    std::vector<Star> stars_;  // by vertex
    std::vector<Ray> rays_;    // by halfedge
    ConvexCone cone_;
    std::vector<Point> targets_;
    std::vector<Halfedge> halfedges_;  // of the targets
};

}  // namespace tightflip::geometry
