/// \file
/// From raw data to a Triangulation: audit first, then orient and number the halfedges.
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace tightflip::kernel {

/// A triangulation, or the report that says why there is none.
struct BuildResult {
    std::optional<Triangulation> triangulation;
    AuditReport report;

    [[nodiscard]] explicit operator bool() const noexcept { return triangulation.has_value(); }
    /// The triangulation; throws std::invalid_argument with the first violation where there is
    /// none.
    [[nodiscard]] const Triangulation& value() const&;
    [[nodiscard]] Triangulation&& value() &&;
};

/// A halfedge table as it stands: handles keep their meaning. Linear time.
[[nodiscard]] BuildResult build(std::vector<HalfedgeRecord> records, Index vertex_count);

/// A gluing, its faces turned over where needed to agree with face 0. Edges are numbered in the
/// order of their first sides, and the even halfedge is that first side. Where the surface cannot
/// be oriented the report has the witness. Linear time.
[[nodiscard]] BuildResult build(const Gluing& gluing);

/// A gluing made from corner labels alone.
struct FaceListReading {
    Gluing gluing;
    std::vector<Violation> violations;  ///< where the list does not determine a gluing
};

/// Glues sides that join the same two vertices, in either direction, and leaves a side that no
/// other meets unglued. A face list does not determine the gluing where more than two sides join
/// the same two vertices: these are left unglued and reported (edge_in_more_than_two_faces).
/// O(F log F) time. Corners out of range are reported by the
/// audit of the result.
[[nodiscard]] FaceListReading glue_faces(std::span<const std::array<Index, 3>> faces,
                                         Index vertex_count);

/// A face list in which no directed vertex pair repeats, every face in its stored orientation.
/// Refused otherwise with the offending edge: the faces are not oriented coherently
/// (directed_edge_repeats), or parallel edges make the list ambiguous; `glue_faces` and a Gluing
/// serve such cases.
[[nodiscard]] BuildResult build(std::span<const std::array<Index, 3>> faces, Index vertex_count);

}  // namespace tightflip::kernel
