/// \file
/// The flip graph as an implicit graph: nothing is stored, a state is asked for its neighbours.
///
/// boost_flip_graph.hpp shows it to Boost.Graph. Runs over all states are the business of
/// class_graph.hpp, which is faster and keeps its result as a FlipGraphTable.
#pragma once

#include <tightflip/kernel/canonical.hpp>
#include <tightflip/kernel/flip_graph_table.hpp>

#include <vector>

namespace tightflip::kernel {

/// The graph whose vertices are triangulations up to the equality given, as canonical codes, and
/// whose arcs are legal flips. A value without memory of what it was asked: calls may run at the
/// same time.
class FlipGraph {
public:
    /// With `simple_only`, states are simple graphs (Definition 2.1 of Alboul et al.) and flips
    /// those that keep them simple: the classical diagonal flip.
    explicit FlipGraph(Equality equality, bool simple_only = false) noexcept
        : equality_(equality), simple_only_(simple_only) {}

    [[nodiscard]] Equality equality() const noexcept { return equality_; }
    [[nodiscard]] bool simple_only() const noexcept { return simple_only_; }

    /// The state of a surface. Throws std::invalid_argument where only simple graphs are states and
    /// this is none.
    [[nodiscard]] CanonicalCode state(const Triangulation& surface) const;

    /// For each legal flip of `surface_of(state)`, by edges, the state it leads to: a state may
    /// come several times, and the state itself may be among them. To every arc there is one back,
    /// but where states have symmetries, not always as many as there. Throws std::invalid_argument
    /// for a code made for another equality. Linear time a flip.
    [[nodiscard]] std::vector<CanonicalCode> neighbours(const CanonicalCode& state) const;

private:
    Equality equality_;
    bool simple_only_;
};

}  // namespace tightflip::kernel
