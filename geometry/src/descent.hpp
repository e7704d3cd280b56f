/// \file
/// A surface on its way down: the searches that strategies are made of, one after the other.
#pragma once

#include "effort.hpp"
#include "escapes.hpp"
#include <tightflip/geometry/strategy.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace tightflip::geometry {

/// Criteria that lead out of minima of others (docs/optimisation.md).
inline constexpr std::array helpers{CriterionKind::area, CriterionKind::edge_length,
                                    CriterionKind::mean_weighted};
/// A round of these that gains less than this part of the energy is the last.
inline constexpr double least_gain_of_a_round = 1e-3;
inline constexpr Index edges_of_a_kick = 3;
inline constexpr std::int64_t kicks_per_vertex = 30;

/// A criterion, but for the flips that another one forbids.
class Within final : public Criterion {
public:
    Within(std::unique_ptr<Criterion> criterion, Criterion& bounds)
        : criterion_(std::move(criterion)), bounds_(bounds) {}

    [[nodiscard]] std::size_t level_count() const override { return criterion_->level_count(); }
    [[nodiscard]] bool has_exact_sign() const override { return criterion_->has_exact_sign(); }
    [[nodiscard]] Energy value() const override { return criterion_->value(); }
    [[nodiscard]] Energy change(Edge e) override {
        const Energy c = criterion_->change(e);
        return bounds_.change(e).is_forbidden() ? Energy::forbidden() : c;
    }
    void flipped(Edge e) override {
        criterion_->flipped(e);
        bounds_.flipped(e);
    }
    void append_affected(Edge e, std::vector<Edge>& edges) const override {
        criterion_->append_affected(e, edges);
        bounds_.append_affected(e, edges);
    }

private:
    std::unique_ptr<Criterion> criterion_;
    Criterion& bounds_;
};

/// Whether there are flips that the criterion does not allow.
inline bool forbids_flips(const Triangulation& surface, Criterion& criterion) {
    for (Index e = 0; e < surface.edge_count(); ++e) {
        if (surface.can_flip(Edge{e}) && criterion.change(Edge{e}).is_forbidden()) return true;
    }
    return false;
}

/// A surface on its way down, with the flips that led there and the best that it has been. The
/// wanted criterion is bound to the start, or the end of a path, and told every flip from there.
class Descent {
public:
    Descent(const Triangulation& start, Points points, const Goal& goal,
            const OptimiseOptions& options, Effort& effort)
        : surface_(start),
          points_(points),
          goal_(goal),
          wanted_(goal.make(view())),
          options_(options),
          effort_(effort),
          best_(wanted_->value()) {}

    /// Local search, and ahead if asked.
    void descend(bool looks_ahead) {
        search(*wanted_, true, looks_ahead);
        note();
    }

    void alternate() {
        const bool has_bounds = goal_.may_forbid_flips && forbids_flips(surface_, *wanted_);
        double before = 0;
        do {
            before = best_.first();
            for (const CriterionKind kind : helpers) {
                auto helper = make_criterion(kind, view());
                if (has_bounds) {
                    Within within(std::move(helper), *wanted_);
                    search(within, false, true);
                } else {
                    const std::size_t told = flips_.size();
                    search(*helper, false, true);
                    tell_wanted(told);
                }
            }
            descend(true);
        } while (!effort_.end() &&
                 best_.first() < before - least_gain_of_a_round * std::abs(before));
        go_back_to_best();
    }

    void kick() {
        Escapes escapes(surface_, points_, *wanted_, true, options_, effort_, flips_);
        kernel::RandomStream random(options_.seed);
        escapes.kick(kicks_per_vertex * surface_.vertex_count(), edges_of_a_kick, random);
        escapes.look_ahead();
        evaluated_ += escapes.evaluated();
        note();
    }

    /// False where the limits do not let it. The wanted criterion is bound anew at the end: on the
    /// way there are vertices of such degrees that each flip would cost it as much as all do now.
    bool follow(std::span<const Edge> path) {
        if (!effort_.has_flips(static_cast<std::int64_t>(path.size()))) return false;
        for (const Edge e : path) {
            static_cast<void>(surface_.flip(e));
            flips_.push_back(e);
            if (!effort_.made_flip()) break;
        }
        wanted_ = goal_.make(view());
        return !effort_.end();
    }

    /// Takes the surface for the best.
    void settle() {
        best_ = wanted_->value();
        best_length_ = flips_.size();
    }

    /// Takes back what did not help.
    void go_back_to_best() {
        while (flips_.size() > best_length_)
            unflip();
    }

    /// Of the surface after `go_back_to_best`.
    [[nodiscard]] Energy energy() const { return wanted_->value(); }
    [[nodiscard]] const Energy& best() const noexcept { return best_; }
    [[nodiscard]] std::int64_t evaluated() const noexcept { return evaluated_; }
    [[nodiscard]] std::vector<Edge>& flips() noexcept { return flips_; }

private:
    [[nodiscard]] SurfaceView view() const { return {surface_.table(), points_}; }

    void flip(Edge e) {
        static_cast<void>(surface_.flip(e));
        wanted_->flipped(e);
        flips_.push_back(e);
    }
    void unflip() {
        static_cast<void>(surface_.unflip(flips_.back()));
        wanted_->flipped(flips_.back());
        flips_.pop_back();
    }

    /// Does the flips from the one of that number on again, for the wanted criterion to see.
    void tell_wanted(std::size_t first) {
        const std::vector<Edge> untold(flips_.begin() + static_cast<std::ptrdiff_t>(first),
                                       flips_.end());
        for (; flips_.size() > first; flips_.pop_back())
            static_cast<void>(surface_.unflip(flips_.back()));
        for (const Edge e : untold)
            flip(e);
    }

    void search(Criterion& criterion, bool is_wanted, bool looks_ahead) {
        if (effort_.end()) return;
        OptimiseOptions options = effort_.rest();
        options.order = options_.order;
        options.trace_every = 0;
        if (!is_wanted) options.least_gain.reset();
        options.keep_going = [&](std::int64_t, const Energy& energy) {
            if (is_wanted) effort_.reached(energy);
            return effort_.made_flip();
        };
        const OptimiseResult result = optimise(surface_, points_, criterion, options);
        flips_.insert(flips_.end(), result.flips.begin(), result.flips.end());
        evaluated_ += result.evaluated;
        if (result.end != OptimiseEnd::local_minimum) effort_.stop(result.end);
        if (!looks_ahead || effort_.end()) return;
        Escapes escapes(surface_, points_, criterion, is_wanted, options_, effort_, flips_);
        escapes.look_ahead();
        evaluated_ += escapes.evaluated();
    }

    void note() {
        if (wanted_->value() < best_) settle();
    }

    Triangulation surface_;
    Points points_;
    const Goal& goal_;
    std::unique_ptr<Criterion> wanted_;
    const OptimiseOptions& options_;
    Effort& effort_;
    std::vector<Edge> flips_;
    Energy best_;
    std::size_t best_length_ = 0;
    std::int64_t evaluated_ = 0;
};

}  // namespace tightflip::geometry
