#include "allowed_flips.hpp"
#include <tightflip/geometry/optimise.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

namespace tightflip::geometry {
namespace {

/// The edges that wait to be looked at, each at most once, first come, first served.
class WaitingEdges {
public:
    explicit WaitingEdges(Index edges) : waits_(static_cast<std::size_t>(edges), 0) {}

    void push(Edge e) {
        char& waits = waits_[static_cast<std::size_t>(e.id)];
        if (waits != 0) return;
        waits = 1;
        edges_.push_back(e);
    }
    std::optional<Edge> pop() {
        if (edges_.empty()) return std::nullopt;
        const Edge e = edges_.front();
        edges_.pop_front();
        waits_[static_cast<std::size_t>(e.id)] = 0;
        return e;
    }

private:
    std::deque<Edge> edges_;
    std::vector<char> waits_;
};

/// The improvements found, the best on top: a heap in which each edge knows its place.
class Improvements {
public:
    explicit Improvements(Index edges)
        : changes_(static_cast<std::size_t>(edges)),
          places_(static_cast<std::size_t>(edges), nowhere) {}

    [[nodiscard]] bool empty() const { return heap_.empty(); }
    [[nodiscard]] Edge best() const { return heap_.front().edge; }
    [[nodiscard]] const Energy& change(Edge e) const {
        return changes_[static_cast<std::size_t>(e.id)];
    }

    void set(Edge e, const Energy& change) {
        changes_[static_cast<std::size_t>(e.id)] = change;
        std::size_t place = this->place(e);
        if (place == nowhere) {
            place = heap_.size();
            heap_.emplace_back();
        }
        settle(place, {change.first(), e});
    }
    void remove(Edge e) {
        const std::size_t place = this->place(e);
        if (place == nowhere) return;
        this->place(e) = nowhere;
        const Entry last = heap_.back();
        heap_.pop_back();
        if (last.edge != e) settle(place, last);
    }

private:
    struct Entry {
        double first = 0;  // the change's first level, which mostly decides
        Edge edge;
    };
    static constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
    static constexpr std::size_t fan = 4;

    [[nodiscard]] std::size_t& place(Edge e) { return places_[static_cast<std::size_t>(e.id)]; }

    /// Of equal ones the edge with the smaller number is better.
    [[nodiscard]] bool is_better(const Entry& a, const Entry& b) const {
        if (a.first != b.first) return a.first < b.first;
        if (change(a.edge) < change(b.edge)) return true;
        if (change(b.edge) < change(a.edge)) return false;
        return a.edge < b.edge;
    }
    void put(std::size_t place, const Entry& entry) {
        heap_[place] = entry;
        this->place(entry.edge) = place;
    }
    /// Puts an entry where it belongs, above or below a place that is free.
    void settle(std::size_t place, const Entry& entry) {
        while (place > 0 && is_better(entry, heap_[(place - 1) / fan])) {
            put(place, heap_[(place - 1) / fan]);
            place = (place - 1) / fan;
        }
        while (fan * place + 1 < heap_.size()) {
            const auto children = heap_.begin() + static_cast<std::ptrdiff_t>(fan * place + 1);
            const std::size_t count = std::min(fan, heap_.size() - (fan * place + 1));
            const auto better = [this](const Entry& a, const Entry& b) { return is_better(a, b); };
            const auto child =
                std::min_element(children, children + static_cast<std::ptrdiff_t>(count), better);
            if (!is_better(*child, entry)) break;
            put(place, *child);
            place = static_cast<std::size_t>(child - heap_.begin());
        }
        put(place, entry);
    }

    std::vector<Entry> heap_;
    std::vector<Energy> changes_;      // by edge
    std::vector<std::size_t> places_;  // by edge
};

class Optimiser {
public:
    Optimiser(Triangulation& surface, Points points, Criterion& criterion,
              const OptimiseOptions& options)
        : surface_(surface),
          points_(points),
          criterion_(criterion),
          options_(options),
          waiting_(surface.edge_count()),
          improvements_(options.order == FlipOrder::best ? surface.edge_count() : 0),
          locked_(static_cast<std::size_t>(surface.edge_count()), 0) {
        for (const Edge e : options.locked)
            locked_.at(static_cast<std::size_t>(e.id)) = 1;
        result_.before = criterion.value();
        energy_ = result_.before;
        sure_value_ = result_.before;
        flips_between_sure_ = std::int64_t{4} * surface.edge_count();
        const double share = std::abs(energy_.first()) / std::max(1, surface.edge_count());
        least_gain_ = options.least_gain.value_or(criterion.has_exact_sign() ? 0 : 1e-12 * share);
        enqueue_all();
    }

    OptimiseResult run() && {
        if (options_.trace_every > 0) trace();
        result_.end = options_.order == FlipOrder::first ? run_first() : run_best();
        if (options_.trace_every > 0 && result_.trace.back().flips != flips_done()) trace();
        result_.after = criterion_.value();
        return std::move(result_);
    }

private:
    void enqueue_all() {
        std::vector<Edge> edges(static_cast<std::size_t>(surface_.edge_count()));
        for (std::size_t e = 0; e < edges.size(); ++e)
            edges[e] = Edge{static_cast<Index>(e)};
        if (options_.seed != 0) kernel::RandomStream(options_.seed).shuffle(std::span(edges));
        for (const Edge e : edges)
            waiting_.push(e);
    }

    /// The change that a flip would make, where it is allowed and improves.
    std::optional<Energy> improvement(Edge e) {
        if (locked_[static_cast<std::size_t>(e.id)] != 0 || !surface_.can_flip(e)) {
            return std::nullopt;
        }
        ++result_.evaluated;
        const Energy change = criterion_.improvement(e);
        if (!improves(change)) return std::nullopt;
        if (is_allowed(e)) return change;
        turned_down_.push_back(e);
        return std::nullopt;
    }

    /// Whether edges wait, now that flips far away may have made way for those turned down.
    bool look_again() {
        if (turned_down_.empty() || result_.flips.size() == flips_seen_) return false;
        flips_seen_ = result_.flips.size();
        for (const Edge e : turned_down_)
            waiting_.push(e);
        turned_down_.clear();
        return true;
    }

    /// By the first level that changes by more than the least gain.
    [[nodiscard]] bool improves(const Energy& change) const {
        for (const double level : change.levels) {
            if (std::abs(level) > least_gain_) return level < 0;
        }
        return false;
    }

    [[nodiscard]] bool is_allowed(Edge e) const {
        return geometry::is_allowed(options_.allowed, surface_, points_, e);
    }

    /// Flips and says whether to stop, and why.
    std::optional<OptimiseEnd> flip(Edge e, const Energy& change) {
        static_cast<void>(surface_.flip(e));
        criterion_.flipped(e);
        energy_ += change;
        result_.flips.push_back(e);
        if (options_.trace_every > 0 && flips_done() % options_.trace_every == 0) trace();
        affected_.clear();
        criterion_.append_affected(e, affected_);
        for (const Edge affected : affected_)
            waiting_.push(affected);
        if (options_.keep_going && !options_.keep_going(flips_done(), energy_)) {
            return OptimiseEnd::stopped;
        }
        if (!criterion_.has_exact_sign() && flips_done() - sure_flips_ >= flips_between_sure_ &&
            !make_sure()) {
            return OptimiseEnd::local_minimum;
        }
        return std::nullopt;
    }

    /// Takes the value anew. Where it has not fallen since the last time, whatever the changes say,
    /// takes the flips since back.
    bool make_sure() {
        const Energy value = criterion_.value();
        if (value < sure_value_) {
            sure_value_ = value;
            sure_flips_ = flips_done();
            return true;
        }
        for (; flips_done() > sure_flips_; result_.flips.pop_back()) {
            static_cast<void>(surface_.unflip(result_.flips.back()));
            criterion_.flipped(result_.flips.back());
        }
        std::erase_if(result_.trace, [&](const EnergyAt& at) { return at.flips > sure_flips_; });
        energy_ = sure_value_;
        return false;
    }

    [[nodiscard]] std::int64_t flips_done() const {
        return static_cast<std::int64_t>(result_.flips.size());
    }
    void trace() { result_.trace.push_back({flips_done(), energy_}); }

    [[nodiscard]] bool is_out_of_flips() const { return flips_done() >= options_.max_flips; }
    /// The clock is looked at now and then only.
    bool is_out_of_time() {
        if (result_.evaluated < next_look_) return false;
        next_look_ = result_.evaluated + evaluations_between_looks;
        return std::chrono::duration<double>(Clock::now() - begin_) > options_.max_time;
    }

    OptimiseEnd run_first() {
        do {
            while (const auto e = waiting_.pop()) {
                if (is_out_of_time()) return OptimiseEnd::time_limit;
                const auto change = improvement(*e);
                if (!change) continue;
                if (is_out_of_flips()) return OptimiseEnd::flip_limit;
                if (const auto end = flip(*e, *change)) return *end;
            }
        } while (look_again());
        return OptimiseEnd::local_minimum;
    }

    OptimiseEnd run_best() {
        do {
            while (const auto e = best_improvement()) {
                if (is_out_of_time()) return OptimiseEnd::time_limit;
                if (is_out_of_flips()) return OptimiseEnd::flip_limit;
                if (const auto end = flip(*e, improvements_.change(*e))) return *end;
            }
        } while (look_again());
        return OptimiseEnd::local_minimum;
    }

    /// The edge that improves most, those that wait looked at first.
    std::optional<Edge> best_improvement() {
        while (const auto e = waiting_.pop()) {
            if (const auto change = improvement(*e)) {
                improvements_.set(*e, *change);
            } else {
                improvements_.remove(*e);
            }
        }
        while (!improvements_.empty()) {
            const Edge e = improvements_.best();
            // A flip far away may have closed the way.
            if (options_.allowed == AllowedFlips::all || is_allowed(e)) return e;
            improvements_.remove(e);
            turned_down_.push_back(e);
        }
        return std::nullopt;
    }

    static constexpr std::int64_t evaluations_between_looks = 64;
    using Clock = std::chrono::steady_clock;

    Triangulation& surface_;
    Points points_;
    Criterion& criterion_;
    const OptimiseOptions& options_;
    WaitingEdges waiting_;
    Improvements improvements_;
    std::vector<Edge> affected_;
    std::vector<Edge> turned_down_;
    std::size_t flips_seen_ = 0;
    std::int64_t next_look_ = 0;
    std::vector<char> locked_;
    double least_gain_ = 0;
    Energy energy_;
    /// The value from scratch, last taken after so many flips.
    Energy sure_value_;
    std::int64_t sure_flips_ = 0;
    std::int64_t flips_between_sure_ = 0;
    OptimiseResult result_;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace

OptimiseResult optimise(Triangulation& surface, Points points, Criterion& criterion,
                        const OptimiseOptions& options) {
    return Optimiser(surface, points, criterion, options).run();
}

}  // namespace tightflip::geometry
