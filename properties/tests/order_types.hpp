// Order types of up to seven points in general position, exactly.
//
// The order type of points in space is the sign of the orientation of every four of them, up to the
// points' names and to reflection. It determines which faces on the points meet: in general
// position, two triangles meet beyond their common corners only where a side of one crosses the
// other, which the signs of its five points tell. So embedded triangulations and the flips among
// them depend on the order type alone.
#pragma once

#include <tightflip/geometry/exact_predicates.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace tightflip::properties {

/// The signs of the orientations of all quadruples of points: the bit of a < b < c < d is set where
/// it is positive.
using Chirotope = std::uint64_t;

/// Four points by number, ascending.
using Quadruple = std::array<std::size_t, 4>;

/// Everything about the quadruples of so many points, in the order of their bits.
class Quadruples {
public:
    explicit Quadruples(std::size_t points) : points_(points) {
        for (std::size_t d = 3; d < points; ++d) {
            for (std::size_t c = 2; c < d; ++c) {
                for (std::size_t b = 1; b < c; ++b) {
                    for (std::size_t a = 0; a < b; ++a)
                        all_.push_back({a, b, c, d});
                }
            }
        }
        std::vector<std::size_t> names(points);
        std::iota(names.begin(), names.end(), std::size_t{0});
        do {
            renamings_.push_back(renamed(names));
        } while (std::ranges::next_permutation(names).found);
    }

    /// Empty where four of the points lie in a plane.
    [[nodiscard]] std::optional<Chirotope> chirotope(geometry::Points points) const {
        Chirotope signs = 0;
        for (std::size_t bit = 0; bit < all_.size(); ++bit) {
            const auto [a, b, c, d] = all_[bit];
            const auto sign = geometry::orientation(points[a], points[b], points[c], points[d]);
            if (sign == geometry::Sign::zero) return {};
            if (sign == geometry::Sign::positive) signs |= Chirotope{1} << bit;
        }
        return signs;
    }

    /// The same for all point sets of one order type, and for no others: the least under all
    /// renamings and reflections. Time: the factorial of the number of points, a few steps for
    /// each.
    [[nodiscard]] Chirotope order_type(Chirotope signs) const {
        Chirotope least = ~Chirotope{0};
        for (const std::vector<Place>& renaming : renamings_) {
            least = std::min(least, lesser(renaming, signs, least));
            least = std::min(least, lesser(renaming, ~signs, least));
        }
        return least;
    }

    /// All order types that projective transformations make of one: these turn the signs of some
    /// points over, so that no convex combination of points becomes zero (the reorientation is
    /// acyclic).
    [[nodiscard]] std::set<Chirotope> projective_class(Chirotope signs) const {
        std::set<Chirotope> types;
        // Turning all points over changes no sign of a quadruple: the last one may stay.
        for (unsigned turned = 0; turned < 1U << (points_ - 1); ++turned) {
            const Chirotope now = turned_over(signs, turned);
            if (is_acyclic(now)) types.insert(order_type(now));
        }
        return types;
    }

private:
    /// Where a sign is read, and whether it is turned over.
    struct Place {
        unsigned bit = 0;
        bool turned = false;
    };

    [[nodiscard]] unsigned bit_of(const Quadruple& quadruple) const {
        return static_cast<unsigned>(std::ranges::find(all_, quadruple) - all_.begin());
    }

    /// From the highest bit to the lowest.
    [[nodiscard]] std::vector<Place> renamed(const std::vector<std::size_t>& names) const {
        std::vector<Place> places;
        for (const Quadruple& q : all_) {
            Quadruple named{names[q[0]], names[q[1]], names[q[2]], names[q[3]]};
            bool turned = false;
            for (std::size_t i = 0; i < 4; ++i) {
                for (std::size_t j = i + 1; j < 4; ++j)
                    turned ^= named.at(i) > named.at(j);
            }
            std::ranges::sort(named);
            places.push_back({bit_of(named), turned});
        }
        std::ranges::reverse(places);
        return places;
    }

    /// The renamed signs where they are less than a bound, else any number that is not.
    [[nodiscard]] static Chirotope lesser(const std::vector<Place>& renaming, Chirotope signs,
                                          Chirotope bound) {
        Chirotope result = 0;
        auto remaining = static_cast<unsigned>(renaming.size());
        for (const Place& place : renaming) {
            const Chirotope sign = (signs >> place.bit & 1U) ^ (place.turned ? 1U : 0U);
            result = result << 1U | sign;
            if (result > bound >> --remaining) return bound;
        }
        return result;
    }

    [[nodiscard]] Chirotope turned_over(Chirotope signs, unsigned turned) const {
        for (std::size_t bit = 0; bit < all_.size(); ++bit) {
            for (const std::size_t point : all_[bit])
                signs ^= Chirotope{turned >> point & 1U} << bit;
        }
        return signs;
    }

    /// Among five points in general position the only dependence has the signs of the quadruples
    /// without one of them, taken alternately; all equal, it would be a convex combination that is
    /// zero.
    [[nodiscard]] bool is_acyclic(Chirotope signs) const {
        std::vector<bool> chosen(points_, false);
        std::fill(chosen.end() - 5, chosen.end(), true);
        do {
            std::vector<std::size_t> five;
            for (std::size_t point = 0; point < points_; ++point) {
                if (chosen[point]) five.push_back(point);
            }
            std::size_t positive = 0;
            for (std::size_t left_out = 0; left_out < five.size(); ++left_out) {
                Quadruple four{};
                std::remove_copy(five.begin(), five.end(), four.begin(), five[left_out]);
                const bool sign = (signs >> bit_of(four) & 1U) != 0;
                positive += sign != (left_out % 2 == 1) ? 1 : 0;
            }
            if (positive == 0 || positive == five.size()) return false;
        } while (std::next_permutation(chosen.begin(), chosen.end()));
        return true;
    }

    std::size_t points_;
    std::vector<Quadruple> all_;
    std::vector<std::vector<Place>> renamings_;
};

/// Points with integer coordinates that depend on the seed alone; some are drawn close to the
/// origin, so that rare order types come up.
inline std::vector<geometry::Point> points_of_seed(std::size_t count, std::uint64_t seed) {
    constexpr std::array<std::uint32_t, 4> sizes{1000, 1000, 400, 200};
    kernel::RandomStream random(seed);
    std::vector<geometry::Point> points(count);
    for (geometry::Point& point : points) {
        const std::uint32_t size = sizes.at(random.below(sizes.size()));
        for (double& coordinate : point)
            coordinate = static_cast<double>(random.below(2 * size + 1)) - size;
    }
    return points;
}

}  // namespace tightflip::properties
