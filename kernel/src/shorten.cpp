#include <tightflip/kernel/shorten.hpp>

#include <limits>
#include <numeric>
#include <stdexcept>

namespace tightflip::kernel {
namespace {

template <class Items>
auto& nth(Items& items, Index i) {
    return items[static_cast<std::size_t>(i)];
}

/// One pass: flips go in one by one, and what has been kept of them is at every moment a log from
/// the start to the surface held, bit for bit.
///
/// The last kept flip of each edge is at hand, and with each kept flip the one of the same edge
/// before it. That is all the past a relation needs: a flip changes only faces of its own
/// quadrilateral, and an edge just flipped lies in the faces it changed. So where a face has
/// changed since some moment, the last flip that changed it was of an edge that is still a side of
/// it; and where no side of a quadrilateral or a pentagon has been flipped since, nothing but its
/// diagonals has.
class Pass {
public:
    explicit Pass(const Triangulation& start)
        : surface_(start),
          last_(static_cast<std::size_t>(start.edge_count()), none),
          name_(last_.size()),
          named_(last_.size()) {
        std::iota(name_.begin(), name_.end(), 0);
        std::iota(named_.begin(), named_.end(), 0);
    }

    void take(Edge taken) {
        if (taken.id < 0 || taken.id >= surface_.edge_count()) refuse();
        const Edge e{nth(name_, taken.id)};
        if (const Index since = nth(last_, e.id); since != none) {
            const LaterSides later = later_sides(e, since);
            if (later.count == 0) return cancel(e);
            if (later.count == 1 && is_pentagon(later.side, since)) {
                return go_round_the_pentagon(e, later.side);
            }
        }
        if (!surface_.flip(e)) refuse();
        kept_.push_back({e, nth(last_, e.id)});
        nth(last_, e.id) = static_cast<Index>(kept_.size() - 1);
    }

    /// The kept flips in order.
    void write_to(std::vector<Edge>& flips) const {
        flips.clear();
        for (const Kept& kept : kept_) {
            if (kept.edge.is_valid()) flips.push_back(kept.edge);
        }
    }

private:
    static constexpr Index none = -1;

    /// A flip that is kept; its edge is invalid once it has been cancelled.
    struct Kept {
        Edge edge;
        Index before;  ///< the kept flip of the same edge before this one
    };

    [[noreturn]] static void refuse() { throw std::invalid_argument("the log does not replay"); }

    /// Of the four sides of the quadrilateral about an edge, how many have been flipped since a
    /// kept flip, and one of them.
    struct LaterSides {
        int count = 0;
        Edge side;
    };
    [[nodiscard]] LaterSides later_sides(Edge e, Index since) const {
        const auto q = Quadrilateral::around(surface_.table(), e);
        LaterSides later;
        for (const Halfedge h : {q.h1, q.h2, q.t1, q.t2}) {
            if (nth(last_, edge_of(h).id) <= since) continue;
            ++later.count;
            later.side = edge_of(h);
        }
        return later;
    }

    void cancel(Edge e) {
        static_cast<void>(surface_.unflip(e));
        Kept& cancelled = nth(kept_, nth(last_, e.id));
        nth(last_, e.id) = cancelled.before;
        cancelled = {};
    }

    /// For the one side f of the quadrilateral about an edge e that has been flipped since e was:
    /// whether it was so once, and the sides of the pentagon about e and f have not been.
    [[nodiscard]] bool is_pentagon(Edge f, Index since) const {
        return nth(kept_, nth(last_, f.id)).before < since && later_sides(f, since).count == 0;
    }

    /// Of the kept e, f and the e that comes now: f, e, and the names exchanged.
    void go_round_the_pentagon(Edge e, Edge f) {
        bool done = static_cast<bool>(surface_.unflip(f)) && surface_.unflip(e);
        done = done && surface_.flip(f) && surface_.flip(e);
        // Of the five diagonals of the pentagon each was an edge, so none is a loop.
        if (!done) throw std::logic_error("a flip was refused that theory allows");
        const Index first = nth(last_, e.id);
        const Index second = nth(last_, f.id);
        const Index before_e = nth(kept_, first).before;
        nth(kept_, first) = {f, nth(kept_, second).before};
        nth(kept_, second) = {e, before_e};
        std::swap(nth(last_, e.id), nth(last_, f.id));
        std::swap(nth(name_, nth(named_, e.id)), nth(name_, nth(named_, f.id)));
        std::swap(nth(named_, e.id), nth(named_, f.id));
    }

    Triangulation surface_;
    std::vector<Kept> kept_;
    std::vector<Index> last_;   ///< the last kept flip of each edge
    std::vector<Index> name_;   ///< what an edge of the log is called now
    std::vector<Index> named_;  ///< and the reverse
};

}  // namespace

FlipLog shorten(FlipLog log, const ShortenOptions& options) {
    if (log.flips.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
        throw std::length_error("a flip log holds at most 2^31 - 1 flips; cut it into several");
    }
    for (int pass = 0; pass < options.most_passes; ++pass) {
        const std::size_t before = log.flips.size();
        Pass shortened(log.start);
        for (const Edge e : log.flips)
            shortened.take(e);
        shortened.write_to(log.flips);
        if (log.flips.size() == before) break;
    }
    return log;
}

}  // namespace tightflip::kernel
