/// \file
/// A second, naive model of surfaces and flips to judge the kernel by. It shares no code with it.
#pragma once

#include <tightflip/kernel/build.hpp>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace tightflip::properties {

using kernel::Edge;
using kernel::Gluing;
using kernel::Index;
using kernel::Triangulation;

/// A closed surface as a topologist writes it: every face a cyclic word of three signed edges,
/// every edge in two places. An edge that occurs with both signs is glued coherently; with one sign
/// twice, reversed; so orientability is something this model could lose. The flip turns a face over
/// where it must. Lists and scans throughout: a flip takes time linear in the surface.
class ReferenceModel {
public:
    /// Edge e of the surface is edge e here, run through forwards by its even halfedge.
    explicit ReferenceModel(const Triangulation& surface);
    /// Any closed surface, orientable or not; edges are numbered by their first sides, which run
    /// through them forwards. Throws std::invalid_argument where the audit finds another fault.
    explicit ReferenceModel(const Gluing& gluing);

    [[nodiscard]] Index edge_count() const noexcept { return static_cast<Index>(ends_.size()); }
    [[nodiscard]] bool can_flip(Edge e) const;
    /// The EDF; false and unchanged where the two opposite corners coincide.
    bool flip(Edge e);
    /// Its inverse.
    bool unflip(Edge e);

    /// The raw data that the audit judges.
    [[nodiscard]] Gluing gluing() const;
    /// An edge at which the surface is not what this model says; empty where they are the same,
    /// edge by edge and face by face.
    [[nodiscard]] std::optional<Edge> difference(const Triangulation& surface) const;

private:
    using SignedEdge = Index;                ///< e + 1 forwards, -(e + 1) backwards
    using Word = std::array<SignedEdge, 3>;  ///< a face, up to rotation

    /// The two faces at an edge as words (+e, x, y) and (-e, p, q), and where they are kept.
    struct Pair {
        Index first_face, second_face;
        Word first, second;
    };

    [[nodiscard]] Index start(SignedEdge s) const;
    [[nodiscard]] Pair around(Edge e) const;

    std::vector<std::pair<Index, Index>> ends_;  ///< of each edge: from, to
    std::vector<Word> faces_;
    Index vertex_count_ = 0;
};

}  // namespace tightflip::properties
