/// \file
/// A flip graph the naive way, to compare explorations with: every state by the least word of all
/// its walks, every flip done.
#pragma once

#include <tightflip/kernel/canonical_search.hpp>
#include <tightflip/kernel/triangulation.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

namespace tightflip::fuzz {

using NaiveCode = std::vector<kernel::Index>;

/// All that flips lead to, breadth first: states, arcs, and distances from the start.
struct NaiveGraph {
    std::map<NaiveCode, std::size_t> number;
    std::vector<kernel::Triangulation> surfaces;
    std::vector<std::vector<std::size_t>> arcs;
    std::vector<std::size_t> distance;
};

/// The least word of all walks.
[[nodiscard]] NaiveCode naive_code(const kernel::Triangulation& surface, kernel::Equality equality);

/// How many states there are at each distance from one.
[[nodiscard]] std::vector<std::uint64_t> levels(const NaiveGraph& graph, std::size_t from);

[[nodiscard]] bool is_simple(const kernel::Triangulation& surface);

/// The components of a flip graph, each explored when first asked for and kept: there are few
/// sizes, and what the naive way finds depends on nothing else.
class NaiveGraphs {
public:
    struct Place {
        std::size_t component;
        std::size_t state;
        friend auto operator<=>(const Place&, const Place&) = default;
    };

    NaiveGraphs(const kernel::Triangulation& start, kernel::Equality equality, bool simple_only);

    /// That of the start is the first.
    [[nodiscard]] const NaiveGraph& component(std::size_t k) const { return components_[k]; }
    [[nodiscard]] Place place(const kernel::Triangulation& surface);
    /// Of all states of the start's component.
    [[nodiscard]] const std::vector<std::size_t>& eccentricities();

private:
    kernel::Equality equality_;
    bool simple_only_;
    std::deque<NaiveGraph> components_;  // which references survive
    std::vector<std::size_t> eccentricities_;
};

}  // namespace tightflip::fuzz
