/// \file
/// Criteria made of criteria: weighted sums, and orders in which one decides where others tie.
#pragma once

#include <tightflip/geometry/criterion.hpp>

#include <string_view>
#include <vector>

namespace tightflip::geometry {

struct WeightedCriterion {
    double weight = 1;
    std::unique_ptr<Criterion> criterion;
};

/// The sum of the criteria, each times its weight, level by level. A flip is forbidden where one of
/// them forbids it. All are bound to one surface.
[[nodiscard]] std::unique_ptr<Criterion> weighted_sum(std::vector<WeightedCriterion> terms);

struct RankedCriterion {
    std::unique_ptr<Criterion> criterion;
    /// Changes of a level by this and less count as none, so that roundings decide nothing.
    double tolerance = 0;
};

/// The criteria one after the other, each with its levels. Throws std::invalid_argument for more
/// than Energy::max_levels levels, and for no criterion.
[[nodiscard]] std::unique_ptr<Criterion> lexicographic(std::vector<RankedCriterion> ranks);

/// A criterion as text says it: names of criteria, with weights, added up, and such sums in order
/// of rank: "tight", "area+0.5*edge_length", "tight,mean". Ranks but the last ignore changes up to
/// `tolerance`. Throws std::invalid_argument with the place in the text and the names there are,
/// and as `make_criterion` does.
[[nodiscard]] std::unique_ptr<Criterion> parse_criterion(std::string_view text,
                                                         const SurfaceView& surface,
                                                         Vertex marked = {},
                                                         double tolerance = 1e-9);

}  // namespace tightflip::geometry
