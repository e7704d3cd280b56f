/// \file
/// From any triangulation of convex data on a sphere to the convex one, by flips alone (Alboul et
/// al., section 5).
///
/// \code
///     if (const ConvexifyResult done = convexify(surface, points)) ...  // done.flips led there
/// \endcode
#pragma once

#include <tightflip/geometry/data_refusal.hpp>
#include <tightflip/geometry/surface.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace tightflip::geometry {

/// How the end was reached.
enum class ConvexifyWay : std::uint8_t {
    none,           ///< it was convex already, or was not reached
    concave_edges,  ///< flipping concave edges, as they come, was enough
    construction,   ///< a doubled fan first, which then grows into the hull point by point
};

/// Why it ended.
enum class ConvexifyEnd : std::uint8_t {
    convex,        ///< certified by `is_convex_surface`, flat edges admitted
    not_a_sphere,  ///< the surface has another genus
    unfit_data,    ///< `data` says why
    not_reached,   ///< the points are too close to flat for coordinates to tell an axis
    flip_limit,
    time_limit,
    stopped,  ///< `keep_going` said so
};

struct ConvexifyOptions {
    /// Tried first. A try that fails leaves no trace but the time it took, less than the rest.
    bool concave_edges_first = true;
    /// Chooses the axis of the sweep.
    std::uint64_t seed = 1;
    std::int64_t max_flips = std::numeric_limits<std::int64_t>::max();
    std::chrono::duration<double> max_time = std::chrono::duration<double>::max();
    /// Called every few thousand flips, with those of the present stage; false stops.
    std::function<bool(std::int64_t flips)> keep_going{};
};

struct ConvexifyResult {
    ConvexifyEnd end = ConvexifyEnd::convex;
    DataRefusal data{};
    ConvexifyWay way = ConvexifyWay::none;
    std::vector<Edge> flips{};  ///< in order: with the triangulation before, a FlipLog
    /// Of these the ones that come after the doubled fan, each of a concave edge.
    std::int64_t concave_flips = 0;

    [[nodiscard]] explicit operator bool() const noexcept { return end == ConvexifyEnd::convex; }
};

/// Why there is no convex surface, in one line; empty where there is.
[[nodiscard]] std::string message(const ConvexifyResult& result);

/// Flips the surface until it is the boundary of the convex hull, with all points as vertices and
/// faces counter-clockwise seen from outside; convex up to flat edges where data are degenerate.
/// Any start on a sphere will do, self-intersecting, inside out, with parallel edges. Every end is
/// certified exactly; an end that is not convex leaves the surface as it was.
///
/// The construction: an axis touches the hull in a corner, the hub; half-planes turning about it
/// meet the other points in some order. The surface is brought into the doubled fan of that order
/// (kernel/doubled_fan.hpp): a flat sheet on the hub, of which the part before a point p has grown
/// into the hull of the points up to there, and the rest still hangs on the edge from the hub to
/// the last point x. Seen from the hub, p is beyond all that have been, x being the last, so that p
/// sees a face beside that edge. Where the sheet is folded over onto that face p becomes one of its
/// neighbours, with one flip, and then all faces are flipped that p sees across the edges opposite
/// it. The rest now hangs on the edge from the hub to p. Coplanar and collinear points are thought
/// to be moved outwards by symbolic amounts.
///
/// At most 2 V ceil(log2 V) + 4 V flips and those of concave edges, which are some 4 to 13 V for
/// points spread over a surface and O(V^2) at worst.
/// Refused: coplanar_points, coincident_points, interior_point, each with its witness, not_finite.
[[nodiscard]] ConvexifyResult convexify(Triangulation& surface, Points points,
                                        const ConvexifyOptions& options = {});

}  // namespace tightflip::geometry
