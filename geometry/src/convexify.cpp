#include "axis_sweep.hpp"
#include "lexicographic.hpp"
#include "simplex.hpp"
#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/convexify.hpp>
#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/optimise.hpp>
#include <tightflip/kernel/doubled_fan.hpp>

#include <utility>

namespace tightflip::geometry {
namespace {

using Clock = std::chrono::steady_clock;

/// The limits, which hold for all stages together.
class Budget {
public:
    explicit Budget(const ConvexifyOptions& options) : options_(options) {}

    [[nodiscard]] std::chrono::duration<double> time_left() const {
        return options_.max_time - (Clock::now() - begin_);
    }
    /// Whether to stop, and why; `flips` are those of the present stage.
    [[nodiscard]] std::optional<ConvexifyEnd> ends(std::int64_t flips) const {
        if (flips > options_.max_flips) return ConvexifyEnd::flip_limit;
        if (time_left().count() < 0) return ConvexifyEnd::time_limit;
        if (options_.keep_going && !options_.keep_going(flips)) return ConvexifyEnd::stopped;
        return std::nullopt;
    }

private:
    const ConvexifyOptions& options_;
    Clock::time_point begin_ = Clock::now();
};

constexpr std::int64_t flips_between_looks = 4096;

/// What a stage came to: the surface it left, and whether it was stopped.
struct Stage {
    Triangulation surface;
    std::vector<Edge> flips;
    std::optional<ConvexifyEnd> stopped{};
};

Stage flip_concave_edges(const Triangulation& start, Points points, const Budget& budget) {
    Stage stage{start, {}};
    const auto criterion = make_criterion(CriterionKind::volume, {stage.surface.table(), points});
    OptimiseOptions options;
    options.keep_going = [&](std::int64_t flips, const Energy&) {
        if (flips % flips_between_looks == 0) stage.stopped = budget.ends(flips);
        return !stage.stopped;
    };
    stage.flips = optimise(stage.surface, points, *criterion, options).flips;
    return stage;
}

/// Grows a doubled fan into the hull, as the header says.
class Growth {
public:
    Growth(kernel::DoubledFan fan, const PerturbedPoints& points)
        : surface_(std::move(fan.surface)),
          flips_(std::move(fan.flips)),
          path_(std::move(fan.path)),
          points_(points) {}

    std::optional<ConvexifyEnd> run(const Budget& budget) {
        std::size_t next_look = 0;
        for (const Halfedge step : path_) {
            take(step);
            if (flips_.size() < next_look) continue;
            next_look = flips_.size() + flips_between_looks;
            if (const auto end = budget.ends(static_cast<std::int64_t>(flips_.size()))) return end;
        }
        return std::nullopt;
    }
    [[nodiscard]] Stage result(std::optional<ConvexifyEnd> stopped) && {
        return {std::move(surface_), std::move(flips_), stopped};
    }

private:
    /// Joins the target of `step`, the apex, to all faces that it sees. So far it is the tip of
    /// what hangs on the edge from the hub to the origin, by two faces lying on each other.
    void take(Halfedge step) {
        apex_ = surface_.target(step);
        opposite_ = {surface_.previous(step), surface_.next(twin(step))};
        while (!opposite_.empty()) {
            const Halfedge side = opposite_.back();
            opposite_.pop_back();
            if (!sees_beyond(side) || !surface_.flip(edge_of(side))) continue;
            flips_.push_back(edge_of(side));
            const Halfedge spoke = surface_.origin(side) == apex_ ? side : twin(side);
            opposite_.push_back(surface_.next(spoke));
            opposite_.push_back(surface_.previous(twin(spoke)));
        }
    }
    [[nodiscard]] bool sees_beyond(Halfedge side) const {
        const Halfedge beyond = twin(side);
        return points_.side(surface_.origin(beyond), surface_.target(beyond),
                            surface_.opposite(beyond), apex_) == Sign::positive;
    }

    Triangulation surface_;
    std::vector<Edge> flips_;
    std::vector<Halfedge> path_;
    const PerturbedPoints& points_;
    Vertex apex_;
    std::vector<Halfedge> opposite_;  // sides of faces at the apex, opposite to it, to look across
};

class Convexifier {
public:
    Convexifier(Triangulation& surface, Points points, const ConvexifyOptions& options)
        : surface_(surface), points_(points), options_(options), budget_(options) {}

    ConvexifyResult run() {
        if (surface_.genus() != 0) return {.end = ConvexifyEnd::not_a_sphere};
        std::array<Index, 4> corners{};
        if (const DataRefusal refusal = choose_corners(corners); refusal.fault != DataFault::none) {
            return {.end = ConvexifyEnd::unfit_data, .data = refusal};
        }
        if (is_convex(surface_)) return {};
        if (options_.concave_edges_first) {
            if (auto result = accept(flip_concave_edges(surface_, points_, budget_),
                                     ConvexifyWay::concave_edges)) {
                return *std::move(result);
            }
        }
        return construct(PerturbedPoints(points_, corners));
    }

private:
    [[nodiscard]] bool is_convex(const Triangulation& surface) const {
        return bool(is_convex_surface({surface.table(), points_}, FlatEdges::admitted));
    }
    [[nodiscard]] DataRefusal choose_corners(std::array<Index, 4>& corners) const {
        if (const auto bad = point_not_finite(points_)) return {DataFault::not_finite, {*bad, -1}};
        std::vector<std::array<Index, 2>> coincident;
        const std::vector<Index> labels = distinct_in_space(points_, coincident);
        if (!coincident.empty()) {
            const auto [label, first] = coincident.front();
            return {DataFault::coincident_points, {first, label}};
        }
        return {choose_simplex(points_, labels, corners)};
    }
    /// The result, if the stage is the last.
    [[nodiscard]] std::optional<ConvexifyResult> accept(Stage stage, ConvexifyWay way) const {
        if (std::ssize(stage.flips) > options_.max_flips) stage.stopped = ConvexifyEnd::flip_limit;
        if (stage.stopped) return ConvexifyResult{.end = *stage.stopped};
        if (!is_convex(stage.surface)) return std::nullopt;
        surface_ = std::move(stage.surface);
        return ConvexifyResult{.way = way, .flips = std::move(stage.flips)};
    }
    ConvexifyResult construct(const PerturbedPoints& perturbed) const {
        const auto sweep = axis_sweep(points_, perturbed, options_.seed);
        if (sweep) {
            kernel::DoubledFan fan = doubled_fan(surface_, sweep->hub, sweep->order);
            const auto before = static_cast<std::int64_t>(fan.flips.size());
            Growth growth(std::move(fan), perturbed);
            const auto stopped = growth.run(budget_);
            if (auto result =
                    accept(std::move(growth).result(stopped), ConvexifyWay::construction)) {
                if (*result) {
                    result->concave_flips =
                        static_cast<std::int64_t>(result->flips.size()) - before;
                }
                return *std::move(result);
            }
        }
        const DataConvexity data = is_convex_data(points_);
        if (data) return {.end = ConvexifyEnd::not_reached};
        return {.end = ConvexifyEnd::unfit_data,
                .data = {DataFault::interior_point, {data.interior_point, -1}}};
    }

    Triangulation& surface_;
    Points points_;
    const ConvexifyOptions& options_;
    Budget budget_;
};

}  // namespace

std::string message(const ConvexifyResult& result) {
    switch (result.end) {
        case ConvexifyEnd::convex:
            break;
        case ConvexifyEnd::not_a_sphere:
            return "the surface is no sphere, and so it has no convex triangulation";
        case ConvexifyEnd::unfit_data:
            return message(result.data);
        case ConvexifyEnd::not_reached:
            return "the points are too close to flat for coordinates to tell an axis that touches "
                   "their hull";
        case ConvexifyEnd::flip_limit:
            return "the limit of flips was reached";
        case ConvexifyEnd::time_limit:
            return "the limit of time was reached";
        case ConvexifyEnd::stopped:
            return "it was stopped";
    }
    return {};
}

ConvexifyResult convexify(Triangulation& surface, Points points, const ConvexifyOptions& options) {
    return Convexifier(surface, points, options).run();
}

}  // namespace tightflip::geometry
