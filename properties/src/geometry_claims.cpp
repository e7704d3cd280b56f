#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/curvature.hpp>
#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/geometry/quadrilateral.hpp>
#include <tightflip/geometry/surface_measures.hpp>
#include <tightflip/properties/geometry_claims.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <sstream>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace tightflip::properties {
namespace {

using geometry::Criterion;
using geometry::CriterionInfo;
using geometry::CriterionKind;
using geometry::EdgeShape;
using geometry::Energy;
using geometry::Hinge;
using geometry::QuadrilateralType;
using geometry::Surface;
using geometry::SurfaceMeasures;
using geometry::SurfaceView;
using geometry::VertexCurvature;
using geometry::VertexType;
using kernel::Edge;
using kernel::Halfedge;
using kernel::Index;

using Result = std::optional<GeometryFinding>;

constexpr double pi = std::numbers::pi;

/// Whether two values are the same up to roundings of numbers of a size. Sums of n terms with a few
/// roundings each are wrong by some n epsilon of their size: for the surfaces that can be checked
/// flip by flip, far less than this.
bool agree(double a, double b, double size) {
    return a == b || std::abs(a - b) <= 1e-9 * size;
}

/// Of angles and their sums.
bool angles_agree(double a, double b, double size) {
    return agree(a, b, std::max(1.0, std::abs(size)));
}

/// What decides how much of a criterion may be roundings.
struct Sizing {
    int dimension = 0;         ///< the power of a length that it measures; 0: angles, numbers
    int thinness = 0;          ///< the power of the thinness of faces that it is sensitive to
    bool is_thinness = false;  ///< whether it measures that itself
};

Sizing sizing_of(CriterionKind kind) {
    switch (kind) {
        case CriterionKind::mean:
        case CriterionKind::abn:
        case CriterionKind::abn_squares:
            return {.thinness = 1};
        case CriterionKind::mean_weighted:
            return {.dimension = 1, .thinness = 1};
        case CriterionKind::edge_length:
            return {.dimension = 1};
        case CriterionKind::area:
            return {.dimension = 2};
        case CriterionKind::volume:
            return {.dimension = 3};
        case CriterionKind::delaunay:
            return {.thinness = 2, .is_thinness = true};
        default:
            return {};
    }
}

/// The size of a surface in space, as a power of two.
class Extent {
public:
    explicit Extent(geometry::Points points) {
        double half = 0;  // of the largest difference from the first point, lest it overflow
        for (const geometry::Point& point : points)
            half = std::max(half, (point * 0.5 - points.front() * 0.5).cwiseAbs().maxCoeff());
        exponent_ = half > 0 ? std::ilogb(half) + 2 : 0;
    }
    /// At least the largest measure of one edge or face of that dimension; empty where measures, or
    /// sums of many of them, leave the range of doubles.
    [[nodiscard]] std::optional<double> power(int dimension) const {
        const int exponent = dimension * exponent_;
        if (std::abs(exponent) > 900) return std::nullopt;
        return std::ldexp(1.0, exponent);
    }

private:
    int exponent_ = 0;
};

template <class... Parts>
Result found(GeometryClaim claim, const Parts&... parts) {
    std::ostringstream out;
    out.precision(17);
    (out << ... << parts);
    return GeometryFinding{claim, 0, out.str()};
}

Result vertex_claims_hold(const SurfaceView& surface, Halfedge h, const VertexCurvature& c) {
    const Index v = at(surface.table, h).origin.id;
    if (c.positive < 0 || c.negative < 0 ||
        c.absolute() < std::abs(c.deficit()) - 1e-9 * c.absolute() - 1e-12) {
        return found(GeometryClaim::curvature_signs, "vertex ", v, ": omega+ ", c.positive,
                     ", omega- ", c.negative, ", omega ", c.deficit());
    }
    if (!angles_agree(c.positive - c.negative, c.deficit(), c.absolute())) {
        return found(GeometryClaim::curvature_sum, "vertex ", v, ": omega+ ", c.positive,
                     ", omega- ", c.negative, ", omega ", c.deficit());
    }
    const bool may_be_positive = c.type == VertexType::convex || c.type == VertexType::mixed;
    const bool may_be_negative = c.type == VertexType::saddle || c.type == VertexType::mixed;
    if ((c.positive > 1e-9 && !may_be_positive) || (c.negative > 1e-9 && !may_be_negative)) {
        return found(GeometryClaim::vertex_types, "vertex ", v, " of type ",
                     static_cast<int>(c.type), ": omega+ ", c.positive, ", omega- ", c.negative);
    }
    return std::nullopt;
}

/// Before the flip of an edge, what it is and what the flip will make of it.
struct Before {
    EdgeShape shape;
    double volume;
    std::vector<Energy> changes;
};

/// What a criterion was worth when that was last computed from the surface, and what it announced
/// since.
struct Account {
    Energy value;
    Energy announced;
    Energy largest;  ///< of all values and changes since, level by level, without signs

    explicit Account(const Energy& now) : value(now) { note(now); }
    void add(const Energy& change) {
        announced += change;
        note(change);
        note(expected());
    }
    [[nodiscard]] Energy expected() const { return value + announced; }
    void note(const Energy& energy) {
        for (std::size_t i = 0; i < Energy::max_levels; ++i)
            largest.levels[i] = std::max(largest.levels[i], std::abs(energy.levels[i]));
    }
};

class ScriptCheck {
public:
    explicit ScriptCheck(Surface surface)
        : surface_(std::move(surface)), extent_(surface_.points()) {
        for (const CriterionInfo& info : geometry::all_criteria()) {
            if (info.needs_heights) continue;
            infos_.push_back(&info);
            criteria_.push_back(make_criterion(info.kind, surface_.view()));
            accounts_.emplace_back(criteria_.back()->value());
        }
    }

    [[nodiscard]] const Surface& surface() const { return surface_; }

    /// What can be said of the edge, of its flip and of the vertices whose stars that changes.
    [[nodiscard]] Result flip(Edge e) {
        if (auto finding = edge_claims_hold(e)) return finding;
        if (!surface_.triangulation().can_flip(e)) return std::nullopt;
        const Before before = look(e);
        static_cast<void>(surface_.triangulation().flip(e));
        ++flips_;
        last_ = e;
        for (std::size_t k = 0; k < criteria_.size(); ++k) {
            criteria_[k]->flipped(e);
            accounts_[k].add(before.changes[k]);
        }
        if (auto finding = shapes_hold(e, before)) return finding;
        return corners_hold(e);
    }

    /// Whether the criteria's values changed as they announced for the flips since last time.
    [[nodiscard]] Result accounts_hold() {
        if (flips_ == 0) return std::nullopt;
        std::vector<Energy> now;
        double thinness = 0;
        for (std::size_t k = 0; k < criteria_.size(); ++k) {
            now.push_back(criteria_[k]->value());
            accounts_[k].note(now[k]);
            if (sizing_of(infos_[k]->kind).is_thinness) {
                thinness = std::max(thinness, accounts_[k].largest.levels[1]);
            }
        }
        for (std::size_t k = 0; k < criteria_.size(); ++k) {
            if (auto finding = account_holds(*infos_[k], accounts_[k], now[k], thinness)) {
                return finding;
            }
            accounts_[k] = Account(now[k]);
        }
        flips_ = 0;
        return std::nullopt;
    }

private:
    [[nodiscard]] Result edge_claims_hold(Edge e) const {
        const EdgeShape shape = edge_shape(surface_.view(), e);
        const QuadrilateralType type = quadrilateral_type(surface_.view(), e);
        const bool holds = type == QuadrilateralType::none ||
                           (type == QuadrilateralType::cc || type == QuadrilateralType::rc
                                ? shape == EdgeShape::convex
                                : shape == EdgeShape::concave);
        if (holds) return std::nullopt;
        return found(GeometryClaim::quadrilaterals_and_edges, "edge ", e.id, " of shape ",
                     static_cast<int>(shape), " and type ", static_cast<int>(type));
    }

    [[nodiscard]] Before look(Edge e) const {
        const Hinge h = Hinge::at(surface_.view(), e);
        Before before{edge_shape(h), (h.b - h.a).cross(h.c - h.a).dot(h.d - h.a) / 6, {}};
        for (const auto& criterion : criteria_)
            before.changes.push_back(criterion->change(e));
        return before;
    }

    /// The changes of several flips are wrong by several roundings of the largest.
    [[nodiscard]] Result account_holds(const CriterionInfo& info, const Account& account,
                                       const Energy& now, double thinness) const {
        for (std::size_t i = 0; i < Energy::max_levels; ++i) {
            const double change = account.announced.levels[i];
            const double difference = now.levels[i] - account.value.levels[i];
            const auto size = size_of(info.kind, account.largest.levels[i], thinness);
            if (!size || agree(change, difference, flips_ * *size)) continue;
            return found(GeometryClaim::local_change, info.name, ", the last ", flips_,
                         " flips, of edge ", last_.id, " at the end, level ", i, ": announced ",
                         change, ", is ", difference);
        }
        return std::nullopt;
    }

    /// Beside what the changes of a criterion count as roundings; empty where it is out of range.
    ///
    /// The normal of a thin face is wrong by some epsilon times its thinness, the sum of the
    /// squares of its sides over four times its area; so are the angles at its edges. Its area is
    /// wrong in the same proportion, and so is the thinness (which is the sum of its cotangents)
    /// itself.
    [[nodiscard]] std::optional<double> size_of(CriterionKind kind, double value,
                                                double thinness) const {
        constexpr double roundings = 1024 * std::numeric_limits<double>::epsilon() / 1e-9;
        const Sizing sizing = sizing_of(kind);
        const auto unit = extent_.power(sizing.dimension);
        if (!unit) return std::nullopt;
        double rough = sizing.thinness > 0 ? roundings : 1;
        for (int power = 0; power < sizing.thinness; ++power)
            rough *= thinness;
        return std::max({*unit, value, *unit * rough});
    }

    /// Whether the volume, its sign and the shape of the new edge are what the old one says.
    [[nodiscard]] Result shapes_hold(Edge e, const Before& before) const {
        const EdgeShape now = edge_shape(surface_.view(), e);
        const bool was_bent =
            before.shape == EdgeShape::convex || before.shape == EdgeShape::concave;
        const EdgeShape expected =
            before.shape == EdgeShape::convex ? EdgeShape::concave : EdgeShape::convex;
        if (was_bent ? now != expected : now == EdgeShape::convex || now == EdgeShape::concave) {
            return found(GeometryClaim::exchange_of_shapes, "edge ", e.id, ": shape ",
                         static_cast<int>(before.shape), " becomes ", static_cast<int>(now));
        }
        for (std::size_t k = 0; k < criteria_.size(); ++k) {
            if (infos_[k]->kind != CriterionKind::volume) continue;
            const double change = before.changes[k].first();
            const auto size = size_of(CriterionKind::volume, accounts_[k].largest.first(), 0);
            if (size && !agree(change, -before.volume, *size)) {
                return found(GeometryClaim::change_of_volume, "edge ", e.id, ": ", -change,
                             ", the tetrahedron has ", before.volume);
            }
            if ((change < 0) != (before.shape == EdgeShape::concave) ||
                (change > 0) != (before.shape == EdgeShape::convex)) {
                return found(GeometryClaim::sign_of_change, "edge ", e.id, ", shape ",
                             static_cast<int>(before.shape), ": ", change);
            }
        }
        return std::nullopt;
    }

    /// Of the four vertices whose stars a flip changed.
    [[nodiscard]] Result corners_hold(Edge e) {
        const SurfaceView surface = surface_.view();
        const auto q = kernel::Quadrilateral::around(surface.table, e);
        for (const Halfedge h : {q.h, q.t, q.h2, q.t2}) {
            if (auto finding = vertex_claims_hold(surface, h, meter_.measure(surface, h))) {
                return finding;
            }
        }
        return std::nullopt;
    }

    Surface surface_;
    Extent extent_;
    geometry::StarMeter meter_;
    std::vector<const CriterionInfo*> infos_;
    std::vector<std::unique_ptr<Criterion>> criteria_;
    std::vector<Account> accounts_;
    int flips_ = 0;  ///< since accounts were settled
    Edge last_;
};

Result vertices_hold(const SurfaceView& surface) {
    geometry::StarMeter meter;
    std::vector<char> seen(surface.points.size(), 0);
    for (Index id = 0; id < static_cast<Index>(surface.table.size()); ++id) {
        const Halfedge h{id};
        char& is_seen = seen[static_cast<std::size_t>(at(surface.table, h).origin.id)];
        if (std::exchange(is_seen, 1) != 0) continue;
        if (auto finding = vertex_claims_hold(surface, h, meter.measure(surface, h))) {
            return finding;
        }
    }
    return std::nullopt;
}

Result sums_hold(const SurfaceView& surface) {
    const SurfaceMeasures sums = measure(surface);
    const double total = 2 * pi * sums.euler_characteristic;
    if (!angles_agree(sums.total_curvature, total, sums.total_absolute_curvature)) {
        return found(GeometryClaim::gauss_bonnet, sums.total_curvature, " instead of ", total);
    }
    if (!angles_agree(sums.total_absolute_curvature, sums.absolute_curvature_by_cones(),
                      sums.total_absolute_curvature)) {
        return found(GeometryClaim::cones_and_angles, sums.total_absolute_curvature, " and ",
                     sums.absolute_curvature_by_cones());
    }
    Index vertices = 0;
    for (const Index count : sums.vertex_types)
        vertices += count;
    if (vertices != static_cast<Index>(surface.points.size())) {
        return found(GeometryClaim::vertex_types, vertices, " vertices of some type");
    }
    if (sums.euler_characteristic == 2 && sums.total_absolute_curvature < 4 * pi * (1 - 1e-9)) {
        return found(GeometryClaim::least_total_curvature, sums.total_absolute_curvature);
    }
    return std::nullopt;
}

/// Where the whole surface is looked at, and criteria are computed from it.
enum class WholeSurface { after_each_flip, at_the_ends };

/// At the ends, vertices are looked at before the first flip (each flip looks at those that it
/// changes), sums after the last.
Result script_holds(Surface surface, std::span<const Edge> script, WholeSurface when) {
    const bool is_each = when == WholeSurface::after_each_flip;
    if (auto finding = vertices_hold(surface.view())) return finding;
    if (is_each || script.empty()) {
        if (auto finding = sums_hold(surface.view())) return finding;
    }
    ScriptCheck check(std::move(surface));
    const auto finding_at = [&](std::size_t step) -> Result {
        const bool is_whole = is_each || step + 1 == script.size();
        if (is_whole) {  // so that this flip answers for itself
            if (auto finding = check.accounts_hold()) return finding;
        }
        if (auto finding = check.flip(script[step])) return finding;
        if (!is_whole) return std::nullopt;
        if (auto finding = check.accounts_hold()) return finding;
        return sums_hold(check.surface().view());
    };
    for (std::size_t step = 0; step < script.size(); ++step) {
        Result finding = finding_at(step);
        if (!finding) continue;
        finding->step = step + 1;
        return finding;
    }
    return std::nullopt;
}

}  // namespace

std::string_view name(GeometryClaim claim) {
    constexpr std::array names{
        "gauss_bonnet",     "curvature_signs",         "curvature_sum",
        "vertex_types",     "cones_and_angles",        "least_total_curvature",
        "local_change",     "sign_of_change",          "exchange_of_shapes",
        "change_of_volume", "quadrilaterals_and_edges"};
    return names.at(static_cast<std::size_t>(claim) -
                    static_cast<std::size_t>(GeometryClaim::gauss_bonnet));
}

std::string describe(const GeometryFinding& finding) {
    return "after " + std::to_string(finding.step) +
           " flips: " + std::to_string(static_cast<int>(finding.claim)) + " " +
           std::string(name(finding.claim)) + ": " + finding.detail;
}

std::optional<GeometryFinding> curvature_claims_hold(const SurfaceView& surface) {
    Result finding = vertices_hold(surface);
    return finding ? finding : sums_hold(surface);
}

std::optional<GeometryFinding> geometry_claims_hold(Surface surface, std::span<const Edge> script) {
    return script_holds(std::move(surface), script, WholeSurface::after_each_flip);
}

std::optional<GeometryFinding> geometry_claims_hold_at_ends(Surface surface,
                                                            std::span<const Edge> script) {
    return script_holds(std::move(surface), script, WholeSurface::at_the_ends);
}

}  // namespace tightflip::properties
