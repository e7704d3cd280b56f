#include <tightflip/geometry/optimise.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/kernel/circulation.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <queue>

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

struct Improvement {
    Energy change;
    Edge edge;
    std::uint32_t version = 0;  ///< of the edge, when it was looked at

    /// The best comes first out of a heap; of equal ones the edge with the smaller number.
    friend bool operator<(const Improvement& a, const Improvement& b) {
        if (a.change < b.change) return false;
        if (b.change < a.change) return true;
        return b.edge < a.edge;
    }
};

/// The edges whose faces, or whose corners' stars, a flip has changed.
template <class Use>
void for_each_affected(kernel::HalfedgeTable table, Edge e, bool by_stars, const Use& use) {
    const auto q = kernel::Quadrilateral::around(table, e);
    if (by_stars) {
        for (const Halfedge h : {q.h, q.t, q.h2, q.t2}) {
            for (const Halfedge spoke : kernel::Star(table, h)) {
                use(edge_of(spoke));
                use(edge_of(at(table, spoke).next));
            }
        }
        return;
    }
    use(e);
    for (const Halfedge side : {q.h1, q.h2, q.t1, q.t2}) {
        for (const Halfedge h : kernel::FaceSides(table, twin(side)))
            use(edge_of(h));
    }
}

class Optimiser {
public:
    Optimiser(Triangulation& surface, Points points, Criterion& criterion,
              const OptimiseOptions& options)
        : surface_(surface),
          points_(points),
          criterion_(criterion),
          options_(options),
          waiting_(surface.edge_count()),
          versions_(static_cast<std::size_t>(surface.edge_count()), 0),
          locked_(static_cast<std::size_t>(surface.edge_count()), 0) {
        for (const Edge e : options.locked)
            locked_.at(static_cast<std::size_t>(e.id)) = 1;
        result_.before = criterion.value();
        energy_ = result_.before;
        const double share = std::abs(energy_.first()) / std::max(1, surface.edge_count());
        least_gain_ = options.least_gain.value_or(criterion.has_exact_sign() ? 0 : 1e-12 * share);
        enqueue_all();
    }

    OptimiseResult run() && {
        result_.end = options_.order == FlipOrder::first ? run_first() : run_best();
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
        const Energy change = criterion_.change(e);
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
        switch (options_.allowed) {
            case AllowedFlips::all:
                return true;
            case AllowedFlips::simple: {
                const Halfedge h = halfedge_of(e);
                const Vertex d = surface_.opposite(twin(h));
                const auto neighbours = surface_.neighbours(surface_.previous(h));
                return std::find(neighbours.begin(), neighbours.end(), d) == neighbours.end();
            }
            case AllowedFlips::embedded:
                return flip_keeps_embedded({surface_.table(), points_}, e);
        }
        return false;
    }

    /// Flips and says whether to stop, and why.
    std::optional<OptimiseEnd> flip(Edge e, const Energy& change) {
        static_cast<void>(surface_.flip(e));
        criterion_.flipped(e);
        energy_ += change;
        result_.flips.push_back(e);
        const auto done = static_cast<std::int64_t>(result_.flips.size());
        for_each_affected(surface_.table(), e, criterion_.depends_on_stars(), [&](Edge affected) {
            ++versions_[static_cast<std::size_t>(affected.id)];
            waiting_.push(affected);
        });
        if (options_.keep_going && !options_.keep_going(done, energy_)) return OptimiseEnd::stopped;
        return std::nullopt;
    }

    [[nodiscard]] bool is_out_of_flips() const {
        return static_cast<std::int64_t>(result_.flips.size()) >= options_.max_flips;
    }
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
            while (const auto next = best_improvement()) {
                if (is_out_of_time()) return OptimiseEnd::time_limit;
                if (is_out_of_flips()) return OptimiseEnd::flip_limit;
                if (const auto end = flip(next->edge, next->change)) return *end;
            }
        } while (look_again());
        return OptimiseEnd::local_minimum;
    }

    /// The best of all edges, those that wait looked at first.
    std::optional<Improvement> best_improvement() {
        while (const auto e = waiting_.pop()) {
            if (const auto change = improvement(*e)) {
                heap_.push({*change, *e, versions_[static_cast<std::size_t>(e->id)]});
            }
        }
        while (!heap_.empty()) {
            const Improvement next = heap_.top();
            heap_.pop();
            // Where a flip nearby came after the look, the edge has been looked at again.
            if (next.version != versions_[static_cast<std::size_t>(next.edge.id)]) continue;
            // A flip far away may have closed the way.
            if (options_.allowed == AllowedFlips::all || is_allowed(next.edge)) return next;
            turned_down_.push_back(next.edge);
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
    std::priority_queue<Improvement> heap_;
    std::vector<Edge> turned_down_;
    std::size_t flips_seen_ = 0;
    std::int64_t next_look_ = 0;
    std::vector<std::uint32_t> versions_;  // of edges: how often their change may have changed
    std::vector<char> locked_;
    double least_gain_ = 0;
    Energy energy_;
    OptimiseResult result_;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace

OptimiseResult optimise(Triangulation& surface, Points points, Criterion& criterion,
                        const OptimiseOptions& options) {
    return Optimiser(surface, points, criterion, options).run();
}

}  // namespace tightflip::geometry
