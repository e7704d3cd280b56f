#include <tightflip/kernel/canonical.hpp>
#include <tightflip/kernel/connect.hpp>
#include <tightflip/kernel/find_path.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tightflip::kernel {
namespace {

constexpr Equality as_labelled_surfaces{.labels = Labels::kept, .mirror = Mirror::distinct};

/// Codes of labelled surfaces of one size, packed into words.
class PackedCodes {
public:
    explicit PackedCodes(const Triangulation& surface)
        : vertex_count_(surface.vertex_count()),
          bits_(std::bit_ceil(static_cast<unsigned>(std::bit_width(static_cast<std::uint32_t>(
              std::max(surface.halfedge_count(), surface.vertex_count()) - 1))))),
          symbols_(code_length(static_cast<std::size_t>(surface.halfedge_count()), Labels::kept)),
          words_((symbols_.size() * bits_ + 63) / 64) {}

    [[nodiscard]] std::size_t words_a_code() const noexcept { return words_.size(); }

    /// The surface's code; stands until the next call.
    std::span<const std::uint64_t> operator()(HalfedgeTable table) {
        search_(table, vertex_count_, as_labelled_surfaces, std::span(symbols_));
        std::ranges::fill(words_, 0);
        std::size_t bit = 0;
        for (const Index symbol : symbols_) {
            words_[bit / 64] |= static_cast<std::uint64_t>(symbol) << (bit % 64);
            bit += bits_;
        }
        return words_;
    }

private:
    CanonicalSearch search_;
    Index vertex_count_;
    unsigned bits_;  // of a symbol; a power of two, so that none straddles two words
    std::vector<Index> symbols_;
    std::vector<std::uint64_t> words_;
};

using State = std::uint32_t;
constexpr State no_state = std::numeric_limits<State>::max();

/// The surfaces seen, each with the flip that first led to it. Those reached from the one end and
/// from the other stand in one table: they have met when a code turns up from the other end.
class SeenStates {
public:
    enum class End : std::uint8_t { from, to };
    struct Origin {
        State parent = no_state;
        Edge flipped;
        End end = End::from;
    };

    explicit SeenStates(std::size_t words_a_code)
        : words_a_code_(words_a_code), slots_(1024, no_state) {}

    /// Upper bound, vectors that grow included.
    [[nodiscard]] static std::size_t bytes_a_state(std::size_t words_a_code) noexcept {
        return 2 * (8 * words_a_code + sizeof(Origin)) + 4 * sizeof(State);
    }

    [[nodiscard]] std::size_t size() const noexcept { return origins_.size(); }
    [[nodiscard]] const Origin& origin(State state) const noexcept { return origins_[state]; }

    /// The state with this code, entered with its origin where it is new.
    std::pair<State, bool> enter(std::span<const std::uint64_t> code, const Origin& origin) {
        if (2 * (size() + 1) > slots_.size()) grow();
        State& slot = slots_[find(code)];
        if (slot != no_state) return {slot, false};
        slot = static_cast<State>(size());
        codes_.insert(codes_.end(), code.begin(), code.end());
        origins_.push_back(origin);
        return {slot, true};
    }

private:
    [[nodiscard]] std::span<const std::uint64_t> code(State state) const noexcept {
        return std::span(codes_).subspan(state * words_a_code_, words_a_code_);
    }
    /// Where the code stands, or the free slot where it would.
    [[nodiscard]] std::size_t find(std::span<const std::uint64_t> wanted) const noexcept {
        std::uint64_t hash = 0;
        for (const std::uint64_t word : wanted)
            hash = mix(hash ^ word) + word;
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = hash & mask;
        while (slots_[at] != no_state && !std::ranges::equal(code(slots_[at]), wanted))
            at = (at + 1) & mask;
        return at;
    }
    void grow() {
        slots_.assign(2 * slots_.size(), no_state);
        for (State state = 0; state < size(); ++state)
            slots_[find(code(state))] = state;
    }

    std::size_t words_a_code_;
    std::vector<std::uint64_t> codes_;
    std::vector<Origin> origins_;
    std::vector<State> slots_;  // a power of two of them, at least half free
};

using End = SeenStates::End;

/// Breadth-first search from both ends.
class TwoEndedSearch {
public:
    TwoEndedSearch(const Triangulation& from, const Triangulation& to, const PathOptions& options)
        : ends_{from, to},
          options_(options),
          codes_(from),
          seen_(codes_.words_a_code()),
          most_states_(std::min<std::size_t>(
              {options.most_states,
               options.most_bytes / SeenStates::bytes_a_state(codes_.words_a_code()),
               no_state - std::size_t{1}})) {}

    PathSearch run() {
        for (const End end : {End::from, End::to}) {
            const auto [state, is_new] =
                seen_.enter(codes_(surface(end).table()), SeenStates::Origin{no_state, {}, end});
            if (!is_new) return conclude(FlipLog{surface(End::from), {}});
            frontier(end) = {state};
        }
        while (true) {
            const End end =
                frontier(End::from).size() <= frontier(End::to).size() ? End::from : End::to;
            if (frontier(end).empty()) {
                const bool had_no_flip = reached_[static_cast<std::size_t>(end)] == 1;
                return conclude(had_no_flip ? PathOutcome::isolated : PathOutcome::not_connected);
            }
            if (auto ended = expand_level(end)) return *std::move(ended);
            ++complete_levels_;
        }
    }

private:
    [[nodiscard]] const Triangulation& surface(End end) const noexcept {
        return ends_[static_cast<std::size_t>(end)];
    }
    [[nodiscard]] std::vector<State>& frontier(End end) noexcept {
        return frontiers_[static_cast<std::size_t>(end)];
    }

    PathSearch conclude(PathOutcome outcome) const {
        const bool undecided =
            outcome == PathOutcome::not_found || outcome == PathOutcome::interrupted;
        return {.outcome = outcome,
                .path = std::nullopt,
                .states = seen_.size(),
                .least_length = undecided ? complete_levels_ + 1 : 0};
    }
    PathSearch conclude(FlipLog path) const {
        return {.outcome = PathOutcome::found,
                .path = std::move(path),
                .states = seen_.size(),
                .least_length = 0};
    }

    /// Flips everything at the frontier of one end; empty where the search must go on. When all
    /// within a flips of the one end and b of the other are known and none is common to both, a
    /// meeting in the next level makes a + b + 1 flips: no path is shorter.
    std::optional<PathSearch> expand_level(End end) {
        std::vector<State> next;
        for (const State state : frontier(end)) {
            if (options_.interrupted && options_.interrupted()) {
                return conclude(PathOutcome::interrupted);
            }
            if (seen_.size() + static_cast<std::size_t>(surface(end).edge_count()) > most_states_) {
                return conclude(PathOutcome::not_found);
            }
            if (auto meeting = expand(state, end, next)) return meeting;
        }
        reached_[static_cast<std::size_t>(end)] += next.size();
        frontier(end) = std::move(next);
        return std::nullopt;
    }

    std::optional<PathSearch> expand(State state, End end, std::vector<State>& next) {
        const HalfedgeTable start = surface(end).table();
        records_.assign(start.begin(), start.end());
        for (const Edge e : flips_to(state))
            static_cast<void>(flip(MutableHalfedgeTable(records_), e));
        for (Index id = 0; id < surface(end).edge_count(); ++id) {
            const Edge e{id};
            if (e == seen_.origin(state).flipped) continue;  // would only lead back
            if (!flip(MutableHalfedgeTable(records_), e)) continue;
            const auto [reached, is_new] =
                seen_.enter(codes_(records_), {.parent = state, .flipped = e, .end = end});
            if (is_new) {
                next.push_back(reached);
            } else if (seen_.origin(reached).end != end) {
                return conclude(joined(state, e, reached, end));
            }
            static_cast<void>(unflip(MutableHalfedgeTable(records_), e));
        }
        return std::nullopt;
    }

    /// The flips from a state's end to it.
    [[nodiscard]] std::vector<Edge> flips_to(State state) const {
        std::vector<Edge> flips;
        for (; seen_.origin(state).parent != no_state; state = seen_.origin(state).parent)
            flips.push_back(seen_.origin(state).flipped);
        std::ranges::reverse(flips);
        return flips;
    }

    /// The path through a meeting: the flip of `e` at `state` gives the surface of `met`, which was
    /// reached from the other end. Flipping the same edges again leads back, so the way from the
    /// far end is only to be turned round and told in the near end's numbers of edges.
    [[nodiscard]] FlipLog joined(State state, Edge e, State met, End end) const {
        std::vector<Edge> there = flips_to(state);
        there.push_back(e);
        std::vector<Edge> back = flips_to(met);
        if (end == End::to) std::swap(there, back);
        const Triangulation middle = replay({surface(End::from), there}).surface;
        const Triangulation other = replay({surface(End::to), back}).surface;
        const auto map = isomorphism(other, middle, as_labelled_surfaces);
        if (!map) throw std::logic_error("two surfaces of one canonical code are not isomorphic");
        for (std::size_t k = back.size(); k-- > 0;) {
            const auto h = static_cast<std::size_t>(halfedge_of(back[k]).id);
            there.push_back(edge_of(map->halfedges[h]));
        }
        return {surface(End::from), std::move(there)};
    }

    std::array<Triangulation, 2> ends_;
    const PathOptions& options_;
    PackedCodes codes_;
    SeenStates seen_;
    std::size_t most_states_;
    std::array<std::vector<State>, 2> frontiers_;
    std::array<std::size_t, 2> reached_{1, 1};  // from either end, itself included
    std::int64_t complete_levels_ = 0;          // of both ends together
    std::vector<HalfedgeRecord> records_;
};

struct OutcomeWords {
    std::string_view name;
    std::string_view words;
};

constexpr std::array<OutcomeWords, 6> outcomes{{
    {"found", "there is a path"},
    {"isolated", "there is no path: the two differ, and from one of them no flip leads away"},
    {"not_connected",
     "there is no path: everything that flips of the one lead to was seen, and the other is not "
     "among it"},
    {"not_found", "no path was found before a limit was reached; there may be one"},
    {"interrupted", "the search was stopped; there may be a path"},
    {"ends_differ", "there is no path: flips keep the number of vertices and the genus"},
}};

}  // namespace

std::string_view name(PathOutcome outcome) noexcept {
    return outcomes[static_cast<std::size_t>(outcome)].name;
}

std::string_view describe(PathOutcome outcome) noexcept {
    return outcomes[static_cast<std::size_t>(outcome)].words;
}

PathSearch find_path(const Triangulation& from, const Triangulation& to,
                     const PathOptions& options) {
    if (from.vertex_count() != to.vertex_count() || from.genus() != to.genus()) {
        return {.outcome = PathOutcome::ends_differ, .path = {}, .states = 0, .least_length = 0};
    }
    if (from.genus() == 0 && !options.shortest) {
        return {.outcome = PathOutcome::found,
                .path = connect(from, to).value(),
                .states = 0,
                .least_length = 0};
    }
    return TwoEndedSearch(from, to, options).run();
}

}  // namespace tightflip::kernel
