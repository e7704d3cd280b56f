#include "bound_surface.hpp"
#include "criteria.hpp"
#include "directions.hpp"
#include "star_cones.hpp"

#include <array>
#include <numbers>
#include <vector>

namespace tightflip::geometry {
namespace {

constexpr double pi = std::numbers::pi;

/// Omega_abs = 2 sum(omega+) - sum(omega). By Gauss and Bonnet the second sum is 2 pi chi on a
/// closed surface; where a marked vertex takes some vertices out, it changes with the angles.
class TightCriterion final : public Criterion {
public:
    TightCriterion(const SurfaceView& surface, Vertex marked)
        : surface_(surface, marked), cones_(surface), counts_(surface.points.size(), 1) {
        if (!marked.is_valid()) return;
        for (Index id = 0; id < static_cast<Index>(surface.table.size()); ++id) {
            const Halfedge h{id};
            if (kernel::at(surface.table, h).origin != marked) continue;
            counts_[index(marked)] = 0;
            counts_[index(kernel::at(surface.table, twin(h)).origin)] = 0;
        }
    }

    [[nodiscard]] Energy value() const override {
        const StarCones cones(surface_.view());
        double positive = 0;
        double angles = 0;
        double full_turns = 0;
        std::vector<char> seen(counts_.size(), 0);
        for (Index id = 0; id < static_cast<Index>(surface_.table().size()); ++id) {
            const Halfedge h{id};
            const Vertex v = kernel::at(surface_.table(), h).origin;
            if (counts_[index(v)] == 0) continue;
            if (surface_.marked().is_valid()) angles += angle_at(h);
            if (seen[index(v)] != 0) continue;
            seen[index(v)] = 1;
            full_turns += 1;
            positive += cones.positive_curvature(h);
        }
        if (!surface_.marked().is_valid()) {
            // The angles of the faces add up to pi each.
            angles = pi / 3 * static_cast<double>(surface_.table().size());
        }
        return 2 * positive - 2 * pi * full_turns + angles;
    }

    [[nodiscard]] Energy change(Edge e) override {
        const auto q = kernel::Quadrilateral::around(surface_.table(), e);
        const HingeCorners corners = HingeCorners::at(surface_.table(), q);
        if (!surface_.counts(corners)) return Energy::forbidden();
        double positive = 0;
        if (counts_[index(corners.c)] != 0) positive += cones_.change_across(q.h);
        if (counts_[index(corners.d)] != 0) positive += cones_.change_across(q.t);
        if (counts_[index(corners.a)] != 0) positive += cones_.change_without(q.h);
        if (counts_[index(corners.b)] != 0) positive += cones_.change_without(q.t);
        if (!surface_.marked().is_valid()) return 2 * positive;
        return 2 * positive + angles_of(corners.flipped().faces()) - angles_of(corners.faces());
    }

    /// Edges more only lower omega+, and edges less only raise it: without any more, none improves.
    [[nodiscard]] Energy improvement(Edge e) override {
        if (surface_.marked().is_valid()) return change(e);
        const Halfedge h = halfedge_of(e);
        const Halfedge t = twin(h);
        double positive = cones_.change_across(h) + cones_.change_across(t);
        if (positive < 0) positive += cones_.change_without(h);
        if (positive < 0) positive += cones_.change_without(t);
        return 2 * positive;
    }

    void flipped(Edge e) override { cones_.flipped(e); }

    void append_affected(Edge /*e*/, std::vector<Edge>& edges) const override {
        edges.insert(edges.end(), cones_.affected().begin(), cones_.affected().end());
    }

private:
    static std::size_t index(Vertex v) { return static_cast<std::size_t>(v.id); }

    [[nodiscard]] double angle(Vertex apex, Vertex p, Vertex q) const {
        return face_angle(direction(surface_.exact(apex), surface_.exact(p)),
                          direction(surface_.exact(apex), surface_.exact(q)));
    }
    [[nodiscard]] double angle_at(Halfedge h) const {
        const Halfedge h1 = kernel::at(surface_.table(), h).next;
        const Halfedge h2 = kernel::at(surface_.table(), h1).next;
        return angle(kernel::at(surface_.table(), h).origin,
                     kernel::at(surface_.table(), h1).origin,
                     kernel::at(surface_.table(), h2).origin);
    }
    /// The angles at the corners that count.
    [[nodiscard]] double angles_of(const std::array<FaceCorners, 2>& faces) const {
        double sum = 0;
        for (const auto& [a, b, c] : faces) {
            if (counts_[index(a)] != 0) sum += angle(a, b, c);
            if (counts_[index(b)] != 0) sum += angle(b, c, a);
            if (counts_[index(c)] != 0) sum += angle(c, a, b);
        }
        return sum;
    }

    BoundSurface surface_;
    StarCones cones_;
    std::vector<char> counts_;  // by vertex: whether its curvature counts
};

}  // namespace

std::unique_ptr<Criterion> make_tight_criterion(CriterionKind kind, const SurfaceView& surface,
                                                Vertex marked) {
    if (kind != CriterionKind::tight) return nullptr;
    return std::make_unique<TightCriterion>(surface, marked);
}

}  // namespace tightflip::geometry
