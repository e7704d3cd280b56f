/// \file
/// The flip graph of isomorphism classes, explored to the end from a start.
///
/// A state is a class, kept as its canonical code of one byte an edge. Codes are spread over shards
/// by their hash; in each round the workers expand a slice of the states not yet expanded, and then
/// each shard takes in what was found for it. States are numbered by the order of their codes, so
/// the result depends on neither the start within a component, the rounds nor the number of
/// threads.
#pragma once

#include <tightflip/kernel/canonical_search.hpp>
#include <tightflip/kernel/exploration.hpp>
#include <tightflip/kernel/flip_graph_table.hpp>
#include <tightflip/kernel/triangulation.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace tightflip::kernel {

/// Which triangulations are states, and when two are one.
struct ClassRules {
    Mirror mirror = Mirror::distinct;
    /// Only simple graphs, and only flips that keep them simple (the classical flip).
    bool simple_only = false;
    /// Keep what each flip does to the numbers of vertices; the labelled graph needs it.
    bool keep_relabellings = false;

    friend constexpr bool operator==(ClassRules, ClassRules) noexcept = default;
};

/// All classes that flips reach from the starts, and the arcs between them: one for each legal
/// flip.
struct ClassGraph {
    Index vertex_count = 0;
    Index halfedge_count = 0;
    ClassRules rules;
    FlipGraphTable arcs;
    std::vector<std::uint8_t> codes;         ///< `code_length` bytes a state, ascending
    std::vector<std::uint32_t> symmetries;   ///< the order of each state's automorphism group
    std::vector<std::uint8_t> relabellings;  ///< V bytes an arc, where kept: see `relabelling`

    [[nodiscard]] std::size_t size() const noexcept { return arcs.size(); }
    [[nodiscard]] std::size_t code_length() const noexcept {
        return static_cast<std::size_t>(halfedge_count) / 2;
    }
    [[nodiscard]] std::span<const std::uint8_t> code(std::size_t state) const noexcept {
        return {codes.data() + state * code_length(), code_length()};
    }
    /// Where an arc sends the vertices: entry v is the number in the target's canonical numbering
    /// of the vertex that has number v in the source's.
    [[nodiscard]] std::span<const std::uint8_t> relabelling(std::size_t arc) const noexcept {
        const auto vertices = static_cast<std::size_t>(vertex_count);
        return {relabellings.data() + arc * vertices, vertices};
    }
    /// Rooted surfaces that the states stand for: the sum over states of roots / symmetries.
    [[nodiscard]] std::uint64_t rooted_count() const noexcept;
    /// The number of the class of a surface; `size()` where it is not among the states.
    [[nodiscard]] std::size_t find(const Triangulation& surface) const;
    /// A surface of the class, vertices in canonical numbers.
    [[nodiscard]] Triangulation surface(std::size_t state) const;
};

/// The most halfedges whose numbers fit the bytes of a code.
inline constexpr Index max_class_halfedges = 255;

/// Bytes that a state and its arcs take at the peak of an exploration, for estimates beforehand.
[[nodiscard]] std::uint64_t class_graph_bytes_per_state(Index halfedges, ClassRules rules) noexcept;

/// Explores from all starts, which have equal numbers of vertices and halfedges and, with
/// `simple_only`, are simple. Throws std::invalid_argument for other starts, ExplorationStopped
/// where the limits say so, and FileError for a checkpoint that cannot be used.
[[nodiscard]] ClassGraph explore_classes(std::span<const Triangulation> starts, ClassRules rules,
                                         const ExplorationLimits& limits = {});

}  // namespace tightflip::kernel
