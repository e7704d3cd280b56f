/// \file
/// The optimality criteria for triangulations of given points (Alboul et al., section 4.1), behind
/// one interface: a value of the whole surface, and what one flip would change of it.
#pragma once

#include <tightflip/geometry/energy.hpp>
#include <tightflip/geometry/surface.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace tightflip::geometry {

/// A criterion bound to one surface, which it watches through a view: table and points outlive it
/// and stay where they are. Smaller is better.
class Criterion {
public:
    Criterion() = default;
    Criterion(const Criterion&) = delete;
    Criterion& operator=(const Criterion&) = delete;
    virtual ~Criterion() = default;

    /// How many levels of an Energy it uses, from the first on.
    [[nodiscard]] virtual std::size_t level_count() const { return 1; }

    /// Whether the sign of each change is exact, and 0 means none.
    [[nodiscard]] virtual bool has_exact_sign() const { return false; }

    /// The value of the surface as it is now, from scratch; linear time.
    [[nodiscard]] virtual Energy value() const = 0;

    /// By how much the flip of `e` would change `value()`, or Energy::forbidden() where the
    /// criterion does not allow it. Costs what the faces and stars at the edge's four corners cost,
    /// whatever the size of the surface; does not allocate. Precondition: the flip is defined.
    [[nodiscard]] virtual Energy change(Edge e) = 0;

    /// The same where the change is below zero; where it is not, perhaps another value that is not
    /// below zero either and is sooner known. (Up to roundings.)
    [[nodiscard]] virtual Energy improvement(Edge e) { return change(e); }

    /// To be called after each flip or unflip of an edge, done while no other was left unreported.
    virtual void flipped(Edge e) = 0;

    /// Appends the edges whose changes may be others since the flip of `e` was reported, `e` among
    /// them, some more than once. To be asked before the next flip.
    virtual void append_affected(Edge e, std::vector<Edge>& edges) const = 0;
};

enum class CriterionKind : std::uint8_t {
    tight,
    mean,
    mean_weighted,
    area,
    edge_length,
    volume,
    abn,
    abn_squares,
    delaunay,
    min_angle,
    jnd,
    delaunay_plane,
    bending,
};

/// What is known of a criterion without a surface.
struct CriterionInfo {
    CriterionKind kind{};
    std::string_view name;
    std::string_view description;  ///< one line
    bool needs_heights = false;    ///< defined for functional surfaces only
    bool has_exact_sign = false;   ///< the sign of each change is exact, and 0 means 0
};

// clang-format off
/// All criteria, in the order of their kinds.
///
/// | name           | minimises |
/// |----------------|-----------|
/// | tight          | Omega_abs, the sum of omega+ and omega- over the vertices (section 4.1.2) |
/// | mean           | H_abs, the sum of \|H(e)\| over the edges (section 4.1.2) |
/// | mean_weighted  | the sum of \|H(e)\| times the length of e |
/// | area           | the area (O'Rourke 1981) |
/// | edge_length    | the sum of the lengths of the edges |
/// | volume         | minus the signed volume: what flipping concave edges lowers, and nothing else |
/// | abn            | the angles between normals, summed over the edges (Dyn, Levin and Rippa 1990); twice H_abs |
/// | abn_squares    | the squares of these angles, summed |
/// | delaunay       | first the number of faces without area, then the cotangents of all angles: in a plane, flips lower it exactly where two opposite angles exceed pi together (Musin 1997) |
/// | min_angle      | pi/3 less the smallest angle of a face, summed over the faces |
/// | jnd            | the jumps of the normal derivative across the edges, summed (Dyn, Levin and Rippa 1990) |
/// | delaunay_plane | the volume under the points lifted to z = x^2 + y^2, which the Delaunay triangulation minimises (Rippa 1992) |
/// | bending        | the energy of a thin plate, the integral of f_xx^2 + 2 f_xy^2 + f_yy^2 over the cubic patches that heights and gradients at the vertices give (Quak and Schumaker 1990); the gradients are estimated once, from the surface the criterion is made for |
// clang-format on
[[nodiscard]] std::span<const CriterionInfo> all_criteria();

[[nodiscard]] const CriterionInfo& info(CriterionKind kind);

/// The criterion of that name; empty where there is none.
[[nodiscard]] std::optional<CriterionKind> criterion_by_name(std::string_view name);

/// Binds a criterion to a surface; linear time and memory.
///
/// A `marked` vertex closes the boundary of a functional surface: its faces count in no value, for
/// `tight` neither do the vertices on the boundary, and no edge of its star and link may flip.
/// Criteria that need heights want such a vertex, and every other face counter-clockwise seen from
/// above; they forbid flips that would fold the plane. Throws std::invalid_argument where that does
/// not hold, with the face, or where there is no such vertex.
[[nodiscard]] std::unique_ptr<Criterion> make_criterion(CriterionKind kind,
                                                        const SurfaceView& surface,
                                                        Vertex marked = {});

}  // namespace tightflip::geometry
