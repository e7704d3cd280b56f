/// \file
/// A closed oriented triangulated surface that has passed the audit, and its flips.
///
/// \code
///     Triangulation surface = families::tetrahedron();
///     if (auto verdict = surface.can_flip(e)) surface.flip(e);
/// \endcode
#pragma once

#include <tightflip/kernel/circulation.hpp>
#include <tightflip/kernel/flip.hpp>
#include <tightflip/kernel/halfedge_audit.hpp>

#include <utility>
#include <vector>

namespace tightflip::kernel {

struct BuildResult;

/// A value: copyable, comparable, hashable. Vertices keep their labels for ever; halfedges and
/// edges keep their meaning through flips of other edges. Memory: 8 bytes a halfedge, that is
/// 48 bytes a vertex for large surfaces of small genus.
///
/// Every function that takes a handle checks that it exists and throws std::out_of_range where it
/// does not; `table()` offers the same tables without checks.
class Triangulation {
public:
    // ---- counts: constant time ----

    [[nodiscard]] Index vertex_count() const noexcept { return vertex_count_; }
    [[nodiscard]] Index halfedge_count() const noexcept {
        return static_cast<Index>(records_.size());
    }
    [[nodiscard]] Index edge_count() const noexcept { return halfedge_count() / 2; }
    [[nodiscard]] Index face_count() const noexcept { return halfedge_count() / 3; }
    [[nodiscard]] Index euler_characteristic() const noexcept {
        return vertex_count() - edge_count() + face_count();
    }
    [[nodiscard]] Index genus() const noexcept { return (2 - euler_characteristic()) / 2; }

    // ---- navigation: constant time, counter-clockwise seen from outside ----

    [[nodiscard]] Halfedge next(Halfedge h) const { return record(h).next; }
    [[nodiscard]] Halfedge previous(Halfedge h) const { return next(next(h)); }
    [[nodiscard]] Vertex origin(Halfedge h) const { return record(h).origin; }
    [[nodiscard]] Vertex target(Halfedge h) const { return origin(twin(h)); }
    /// The third corner of the face of `h`.
    [[nodiscard]] Vertex opposite(Halfedge h) const { return origin(previous(h)); }

    [[nodiscard]] Star star(Halfedge h) const { return {table(), checked(h)}; }
    [[nodiscard]] Link link(Halfedge h) const { return {table(), checked(h)}; }
    [[nodiscard]] Neighbours neighbours(Halfedge h) const { return {table(), checked(h)}; }
    [[nodiscard]] FaceSides face_sides(Halfedge h) const { return {table(), checked(h)}; }
    [[nodiscard]] FaceCorners face_corners(Halfedge h) const { return {table(), checked(h)}; }
    /// The degree (the paper: valence) of the origin of `h`; linear in it.
    [[nodiscard]] Index degree(Halfedge h) const;

    /// One halfedge that leaves each vertex, indexed by vertex; linear time. Flips of an edge make
    /// the entries that name its halfedges stale, and no others.
    [[nodiscard]] std::vector<Halfedge> outgoing() const;
    /// One halfedge of each face, its smallest, in ascending order; linear time.
    [[nodiscard]] std::vector<Halfedge> faces() const;

    // ---- flips: constant time, no allocation ----

    /// Whether the EDF is defined on `e`, or why not.
    [[nodiscard]] FlipVerdict can_flip(Edge e) const {
        return kernel::can_flip(table(), checked(e));
    }
    /// The EDF (see flip.hpp); where it is refused nothing changes.
    FlipVerdict flip(Edge e) { return kernel::flip(MutableHalfedgeTable(records_), checked(e)); }
    /// The exact inverse of `flip`.
    FlipVerdict unflip(Edge e) {
        return kernel::unflip(MutableHalfedgeTable(records_), checked(e));
    }
    /// Flips the edges of a list in order, as `flip` would one by one, hiding the latency of
    /// memory; returns how many were not refused. Throws std::out_of_range, before any flip, where
    /// an edge does not exist.
    std::size_t flip_all(std::span<const Edge> edges);

    // ---- the raw tables ----

    [[nodiscard]] HalfedgeTable table() const noexcept { return records_; }

    /// Equality of tables: the same handles mean the same. For equality of surfaces whatever their
    /// handles, see surface_equality.hpp.
    friend bool operator==(const Triangulation&, const Triangulation&) = default;

private:
    friend BuildResult build(std::vector<HalfedgeRecord> records, Index vertex_count);

    Triangulation(std::vector<HalfedgeRecord> records, Index vertex_count) noexcept
        : records_(std::move(records)), vertex_count_(vertex_count) {}

    [[nodiscard]] Halfedge checked(Halfedge h) const {
        if (static_cast<std::size_t>(h.id) >= records_.size()) refuse_handle("halfedge", h.id);
        return h;
    }
    [[nodiscard]] Edge checked(Edge e) const {
        if (static_cast<std::size_t>(e.id) >= records_.size() / 2) refuse_handle("edge", e.id);
        return e;
    }
    [[nodiscard]] const HalfedgeRecord& record(Halfedge h) const {
        return at(HalfedgeTable(records_), checked(h));
    }
    [[noreturn]] void refuse_handle(const char* kind, Index id) const;

    std::vector<HalfedgeRecord> records_;
    Index vertex_count_;
};

/// The full audit of the tables as they are; linear time.
[[nodiscard]] AuditReport audit(const Triangulation& surface, const AuditOptions& options = {});

}  // namespace tightflip::kernel

template <>
struct std::hash<tightflip::kernel::Triangulation> {
    /// A hash of the tables, consistent with operator==.
    std::size_t operator()(const tightflip::kernel::Triangulation& surface) const noexcept;
};
