/// \file
/// The independent judge: what a raw gluing really is, and everything that is wrong with it.
///
/// It reads the raw tables alone and shares no traversal code with the rest of the library.
/// The ladder: table well formed; gluing an involution without boundary; labels agree across sides;
/// three distinct corners; the three-neighbour rule; one cycle of faces a vertex; connected,
/// strongly connected; orientable; Euler characteristic and genus. Tables that name what does not
/// exist end the climb after the faces; on every later rung a defective side counts as unglued, so
/// that one fault does not hide another.
#pragma once

#include <tightflip/kernel/gluing.hpp>
#include <tightflip/kernel/violation.hpp>

#include <optional>

namespace tightflip::kernel {

/// What to look at and how much to keep.
struct AuditOptions {
    std::int64_t max_per_code =
        16;                  ///< violations of a code kept with their place; all are counted
    bool statistics = true;  ///< degrees and parallel edges (about half as much work again)
};

/// Degrees (the paper: valence) over the vertices that are used; an edge counts at both ends.
struct DegreeStatistics {
    Index min = 0;
    Index max = 0;
    Index degree_two_vertices = 0;

    friend constexpr bool operator==(const DegreeStatistics&, const DegreeStatistics&) = default;
};

/// Edges that share both ends with another edge.
struct ParallelStatistics {
    Index loops = 0;               ///< edges whose two ends are one vertex
    Index pairs_joined_twice = 0;  ///< pairs of distinct vertices joined by more than one edge
    Index max_multiplicity = 0;    ///< the most edges between any two distinct vertices

    friend constexpr bool operator==(const ParallelStatistics&,
                                     const ParallelStatistics&) = default;
};

/// The numbers that the extended diagonal flip must keep (Theorem 4.2).
struct Topology {
    Index vertices = 0;
    Index edges = 0;  ///< glued pairs of sides, and unglued sides
    Index faces = 0;
    Index components = 0;  ///< of faces, joined by sides
    Index euler_characteristic = 0;
    bool orientable = false;
    /// Where nothing is wrong but perhaps orientability: (2 - chi) / 2 when orientable, else the
    /// number of cross-caps 2 - chi. Otherwise empty.
    std::optional<Index> genus;

    friend constexpr bool operator==(const Topology&, const Topology&) = default;
};

/// The judge's answer.
struct AuditReport {
    Topology topology;
    bool reached_top = false;           ///< false where broken tables ended the climb
    bool coherently_stored = false;     ///< every face is listed in one and the same orientation
    std::vector<Violation> violations;  ///< the first `max_per_code` of each code, by code
    std::int64_t violation_count = 0;
    std::optional<DegreeStatistics> degrees;
    std::optional<ParallelStatistics> parallels;

    /// An oriented surface of the allowed class (Definition 4.1).
    [[nodiscard]] constexpr bool is_valid() const noexcept { return violation_count == 0; }
    /// Allowed but for orientability: a closed connected surface with nothing else wrong.
    [[nodiscard]] constexpr bool is_closed_surface() const noexcept {
        return violation_count == (reached_top && !topology.orientable ? 1 : 0);
    }
    /// Definition 2.1, of a valid surface: the graph is simple. Empty without statistics.
    /// (The sphere of two faces is not simplicial: its faces share all three edges.)
    [[nodiscard]] constexpr std::optional<bool> is_simple() const noexcept {
        if (!parallels) return std::nullopt;
        return parallels->loops == 0 && parallels->pairs_joined_twice == 0 && topology.faces > 2;
    }
    /// Whether a violation of this code was kept.
    [[nodiscard]] constexpr bool has(ViolationCode code) const noexcept {
        for (const Violation& v : violations) {
            if (v.code == code) return true;
        }
        return false;
    }
};

/// Judges a gluing. Linear time; about 13 bytes of scratch a side. Never throws on bad data.
/// In constant expressions use `audit_ladder.hpp`.
[[nodiscard]] AuditReport audit(GluingView gluing, const AuditOptions& options = {});
[[nodiscard]] inline AuditReport audit(const Gluing& gluing, const AuditOptions& options = {}) {
    return audit(GluingView(gluing), options);
}

}  // namespace tightflip::kernel
