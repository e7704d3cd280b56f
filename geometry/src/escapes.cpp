#include "escapes.hpp"

#include "allowed_flips.hpp"

#include <cmath>

namespace tightflip::geometry {
namespace {

/// Of what an edge has of the value on average; less is not worth an attempt, and may be roundings.
constexpr double least_share = 1e-9;
/// Longer attempts have not been seen to succeed.
constexpr std::size_t most_flips_of_an_attempt = 40;

}  // namespace

void Escapes::Queue::push(Edge e) {
    char& waits = waits_[static_cast<std::size_t>(e.id)];
    if (waits != 0) return;
    waits = 1;
    edges_.push_back(e);
}

std::optional<Edge> Escapes::Queue::pop() {
    if (edges_.empty()) return std::nullopt;
    const Edge e = edges_.front();
    edges_.pop_front();
    waits_[static_cast<std::size_t>(e.id)] = 0;
    return e;
}

Escapes::Escapes(Triangulation& surface, Points points, Criterion& criterion, bool is_wanted,
                 const OptimiseOptions& options, Effort& effort, std::vector<Edge>& log)
    : surface_(surface),
      points_(points),
      criterion_(criterion),
      is_wanted_(is_wanted),
      options_(options),
      effort_(effort),
      log_(log),
      locked_(static_cast<std::size_t>(surface.edge_count()), 0),
      untried_(surface.edge_count()),
      near_(surface.edge_count()),
      energy_(criterion.value()),
      sure_(energy_),
      sure_length_(log.size()) {
    for (const Edge e : options.locked)
        locked_.at(static_cast<std::size_t>(e.id)) = 1;
    for (std::size_t i = 0; i < least_gain_.size(); ++i) {
        const double share = std::abs(energy_.levels[i]) / surface.edge_count();
        least_gain_[i] =
            std::max(least_share * share, is_wanted ? options.least_gain.value_or(0) : 0);
    }
}

void Escapes::look_ahead() {
    for (Index e = 0; e < surface_.edge_count(); ++e)
        untried_.push(Edge{e});
    while (may_go_on()) {
        const auto e = untried_.pop();
        if (!e) break;
        attempt(std::span(&*e, 1));
    }
    make_sure();
}

void Escapes::kick(std::int64_t count, Index size, kernel::RandomStream& random) {
    const auto edges = static_cast<std::uint32_t>(surface_.edge_count());
    std::vector<Edge> forced(static_cast<std::size_t>(size));
    while (count-- > 0 && may_go_on()) {
        Halfedge h{static_cast<Index>(random.below(2 * edges))};
        for (Edge& e : forced) {
            e = edge_of(h);
            for (std::uint32_t steps = 1 + random.below(3); steps > 0; --steps)
                h = surface_.next(random.below(2) == 0 ? h : twin(h));
        }
        attempt(forced);
    }
    make_sure();
}

void Escapes::attempt(std::span<const Edge> forced) {
    const std::size_t before = log_.size();
    sum_ = {};
    affected_.clear();
    for (const Edge e : forced) {
        const auto c = change(e);
        if (c && !flip(e, *c)) break;
    }
    if (log_.size() != before) repair(forced.front());
    while (near_.pop()) {
    }
    if (effort_.end() || !improves(sum_)) return take_back(before);
    energy_ += sum_;
    if (is_wanted_) effort_.reached(energy_);
    for (const Edge e : affected_)
        untried_.push(e);
}

/// Flips what improves near the flips made; the edge held, which would only go back, at the end.
void Escapes::repair(Edge held) {
    const std::size_t most = log_.size() + most_flips_of_an_attempt;
    bool is_held = true;
    while (log_.size() < most) {
        auto e = near_.pop();
        if (!e && !is_held) return;
        if (!e) is_held = false;
        if (e == held && is_held) continue;
        const Edge next = e.value_or(held);
        const auto c = change(next);
        if (c && improves(*c) && !flip(next, *c)) return;
    }
}

/// The change by a flip; empty where it is not allowed.
std::optional<Energy> Escapes::change(Edge e) {
    if (locked_[static_cast<std::size_t>(e.id)] != 0 || !surface_.can_flip(e)) return std::nullopt;
    ++evaluated_;
    const Energy c = criterion_.change(e);
    if (c.is_forbidden() || !is_allowed(options_.allowed, surface_, points_, e)) {
        return std::nullopt;
    }
    return c;
}

/// By the first level that changes by more than the least gain.
bool Escapes::improves(const Energy& change) const {
    for (std::size_t i = 0; i < least_gain_.size(); ++i) {
        if (std::abs(change.levels[i]) > least_gain_[i]) return change.levels[i] < 0;
    }
    return false;
}

/// False where the limits forbid it, or it was the last.
bool Escapes::flip(Edge e, const Energy& change) {
    if (!effort_.has_flips(1)) return false;
    static_cast<void>(surface_.flip(e));
    criterion_.flipped(e);
    log_.push_back(e);
    sum_ += change;
    const std::size_t first = affected_.size();
    criterion_.append_affected(e, affected_);
    for (std::size_t i = first; i < affected_.size(); ++i)
        near_.push(affected_[i]);
    return effort_.made_flip();
}

void Escapes::take_back(std::size_t length) {
    for (; log_.size() > length; log_.pop_back()) {
        static_cast<void>(surface_.unflip(log_.back()));
        criterion_.flipped(log_.back());
    }
}

bool Escapes::may_go_on() {
    if (++attempts_ % surface_.edge_count() == 0) make_sure();
    return !goes_in_circles_ && effort_.has_time();
}

/// Keeps what has been kept only if the energy has fallen.
void Escapes::make_sure() {
    if (log_.size() == sure_length_) return;
    energy_ = criterion_.value();
    if (energy_ < sure_) {
        sure_ = energy_;
        sure_length_ = log_.size();
        return;
    }
    take_back(sure_length_);
    energy_ = sure_;
    goes_in_circles_ = true;
}

}  // namespace tightflip::geometry
