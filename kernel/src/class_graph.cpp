#include "checkpoint.hpp"
#include "parallel.hpp"
#include "vertex_numbers.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/circulation.hpp>
#include <tightflip/kernel/class_graph.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/flip.hpp>
#include <tightflip/kernel/rooted_decode.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>

namespace tightflip::kernel {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
}

std::uint64_t hash_of(std::span<const std::uint8_t> code) noexcept {
    Checksum sum;
    sum.add(std::as_bytes(code));
    return mix(sum.value());
}

/// Whether an edge joins the origin of `from` to `to`.
bool are_joined(HalfedgeTable table, Halfedge from, Vertex to) {
    return std::ranges::any_of(Neighbours(table, from), [to](Vertex v) { return v == to; });
}

/// A set of codes that numbers its elements in the order in which they come.
class CodeSet {
public:
    explicit CodeSet(std::size_t code_length) : code_length_(code_length), slots_(1 << 6) {}

    [[nodiscard]] std::size_t size() const noexcept { return codes_.size() / code_length_; }
    [[nodiscard]] std::span<const std::uint8_t> code(std::size_t i) const noexcept {
        return {codes_.data() + i * code_length_, code_length_};
    }
    [[nodiscard]] const std::vector<std::uint8_t>& codes() const noexcept { return codes_; }
    [[nodiscard]] std::uint64_t bytes() const noexcept {
        return codes_.size() + slots_.size() * sizeof(Slot);
    }

    /// The number of a code, and whether it is new.
    std::pair<std::uint32_t, bool> insert(std::span<const std::uint8_t> code, std::uint64_t hash) {
        Slot& slot = place_of(code, hash);
        if (slot.number != no_number) return {slot.number, false};
        const auto number = static_cast<std::uint32_t>(size());
        codes_.insert(codes_.end(), code.begin(), code.end());
        slot = {tag(hash), number};
        if (3 * size() > 2 * slots_.size()) rebuild(2 * slots_.size());
        return {number, true};
    }

    void restore(std::vector<std::uint8_t> codes) {
        codes_ = std::move(codes);
        rebuild(std::bit_ceil(2 * size() + 64));
    }

private:
    static constexpr std::uint32_t no_number = ~std::uint32_t{0};
    struct Slot {
        std::uint32_t tag = 0;
        std::uint32_t number = no_number;
    };
    static std::uint32_t tag(std::uint64_t hash) noexcept {
        return static_cast<std::uint32_t>(hash >> 24);
    }

    Slot& place_of(std::span<const std::uint8_t> wanted, std::uint64_t hash) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t place = static_cast<std::size_t>(hash) & mask;
        while (slots_[place].number != no_number &&
               (slots_[place].tag != tag(hash) ||
                !std::ranges::equal(code(slots_[place].number), wanted))) {
            place = (place + 1) & mask;
        }
        return slots_[place];
    }

    void rebuild(std::size_t slots) {
        slots_.assign(slots, {});
        for (std::size_t i = 0; i < size(); ++i) {
            const std::uint64_t hash = hash_of(code(i));
            place_of(code(i), hash) = {tag(hash), static_cast<std::uint32_t>(i)};
        }
    }

    std::size_t code_length_;
    std::vector<std::uint8_t> codes_;
    std::vector<Slot> slots_;
};

/// A state's number while the run goes on: its place in its shard, times the number of shards, plus
/// the shard.
using StateId = std::uint32_t;

class ClassExplorer {
public:
    ClassExplorer(Index vertices, Index halfedges, ClassRules rules,
                  const ExplorationLimits& limits)
        : vertices_(vertices),
          halfedges_(halfedges),
          rules_(rules),
          limits_(limits),
          workers_(thread_count(limits.threads)),
          scratch_(workers_) {
        shards_.assign(shard_count, Shard{CodeSet(code_length()), {}, {}});
    }

    /// Goes on where a checkpoint of a run with the same parameters stopped, if there is one.
    void resume() {
        if (limits_.checkpoint_directory.empty() || !std::filesystem::exists(checkpoint())) return;
        CheckpointReader reader(checkpoint(), checkpoint_kind);
        std::vector<std::uint64_t> found;
        reader.array(found);
        if (found != parameters()) reader.refuse("belongs to a run with other parameters");
        std::vector<std::vector<std::uint8_t>> codes(shard_count);
        std::vector<std::vector<std::uint32_t>> symmetries(shard_count);
        for (std::size_t s = 0; s < shard_count; ++s) {
            reader.array(codes[s]);
            reader.array(symmetries[s]);
        }
        std::vector<StateId> queue;
        FlipGraphTable table;
        std::vector<std::uint8_t> relabellings;
        reader.array(queue);
        reader.array(table.offsets);
        reader.array(table.targets);
        reader.array(relabellings);
        reader.finish();
        for (std::size_t s = 0; s < shard_count; ++s) {
            shards_[s].codes.restore(std::move(codes[s]));
            shards_[s].symmetries = std::move(symmetries[s]);
        }
        queue_ = std::move(queue);
        found_ = std::move(table);
        relabellings_ = std::move(relabellings);
        resumed_ = expanded();
    }

    void add_start(const Triangulation& start) {
        const std::vector<HalfedgeRecord> table(start.table().begin(), start.table().end());
        const std::uint64_t hash = canonicalise(scratch_[0], table);
        take_in(shard_of(hash), scratch_[0].code, hash, scratch_[0].search.best_roots().size());
        queue_fresh();
    }

    void run() {
        began_ = Clock::now();
        auto kept = Clock::now();
        while (expanded() < queue_.size()) {
            require_memory();
            expand_round();
            if (limits_.progress) {
                limits_.progress({"classes", expanded(), 0, seconds_since(began_), resumed_});
            }
            const bool is_interrupted = limits_.interrupted && limits_.interrupted();
            if (is_interrupted || seconds_since(kept) >= limits_.checkpoint_seconds) {
                keep();
                kept = Clock::now();
            }
            if (is_interrupted) {
                throw ExplorationStopped(ExplorationStopped::Reason::interrupted,
                                         "interrupted with " + std::to_string(queue_.size()) +
                                             " classes known and " + std::to_string(expanded()) +
                                             " expanded");
            }
        }
        keep();
    }

    /// The states in the order of their codes. The explorer is empty afterwards.
    ClassGraph take() {
        std::vector<StateId> order = queue_;
        std::ranges::sort(order, [this](StateId a, StateId b) {
            return std::ranges::lexicographical_compare(code(a), code(b));
        });
        std::vector<std::vector<std::uint32_t>> rank(shard_count);
        for (std::size_t s = 0; s < shard_count; ++s)
            rank[s].resize(shards_[s].codes.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            rank[order[i] % shard_count][order[i] / shard_count] = static_cast<std::uint32_t>(i);
        }
        const auto rank_of = [&](StateId id) { return rank[id % shard_count][id / shard_count]; };

        ClassGraph graph;
        graph.vertex_count = vertices_;
        graph.halfedge_count = halfedges_;
        graph.rules = rules_;
        graph.codes.reserve(order.size() * code_length());
        graph.symmetries.reserve(order.size());
        for (const StateId id : order) {
            const auto bytes = code(id);
            graph.codes.insert(graph.codes.end(), bytes.begin(), bytes.end());
            graph.symmetries.push_back(shards_[id % shard_count].symmetries[id / shard_count]);
        }
        std::vector<std::uint32_t> row_of(order.size());
        for (std::size_t row = 0; row < queue_.size(); ++row) {
            row_of[rank_of(queue_[row])] = static_cast<std::uint32_t>(row);
        }
        const auto width = rules_.keep_relabellings ? static_cast<std::size_t>(vertices_) : 0;
        graph.arcs.offsets.reserve(order.size() + 1);
        graph.arcs.targets.reserve(found_.targets.size());
        for (const std::uint32_t row : row_of) {
            for (const StateId id : found_.row(row))
                graph.arcs.targets.push_back(rank_of(id));
            graph.arcs.offsets.push_back(graph.arcs.targets.size());
            const auto first =
                relabellings_.begin() + static_cast<std::ptrdiff_t>(found_.offsets[row] * width);
            graph.relabellings.insert(
                graph.relabellings.end(), first,
                first + static_cast<std::ptrdiff_t>(found_.degree(row) * width));
        }
        return graph;
    }

private:
    // A round is a slice of the queue, cut into blocks that workers expand.
    static constexpr std::size_t shard_count = 16;
    static constexpr std::size_t block_states = 256;
    static constexpr std::size_t round_blocks = 128;

    struct Shard {
        CodeSet codes;
        std::vector<std::uint32_t> symmetries;
        std::vector<StateId> fresh;  // first met in this round
    };
    /// What a block found for one shard.
    struct Mail {
        std::vector<std::uint8_t> codes;
        std::vector<std::uint64_t> hashes;
        std::vector<std::uint32_t> symmetries;
        std::vector<std::uint32_t> arcs;  // the place of the arc among the block's arcs

        void clear() {
            codes.clear();
            hashes.clear();
            symmetries.clear();
            arcs.clear();
        }
    };
    struct Block {
        std::array<Mail, shard_count> mail;
        std::vector<std::uint32_t> degrees;
        std::vector<std::uint8_t> relabellings;
        std::uint32_t arcs = 0;
        std::uint64_t first_arc = 0;
    };
    struct Scratch {
        CanonicalSearch search;
        RootedWalk walk;
        std::vector<HalfedgeRecord> table;
        std::vector<std::uint8_t> code;
        std::vector<std::uint8_t> numbers;
    };

    [[nodiscard]] std::size_t code_length() const noexcept {
        return static_cast<std::size_t>(halfedges_) / 2;
    }
    /// Shards look at the top bits of a hash, places in a shard at the bottom ones.
    [[nodiscard]] static std::size_t shard_of(std::uint64_t hash) noexcept {
        return static_cast<std::size_t>(hash >> 60);
    }
    [[nodiscard]] std::size_t expanded() const noexcept { return found_.size(); }
    [[nodiscard]] std::span<const std::uint8_t> code(StateId id) const noexcept {
        return shards_[id % shard_count].codes.code(id / shard_count);
    }

    std::uint64_t canonicalise(Scratch& scratch, HalfedgeTable table) const {
        scratch.code.resize(code_length());
        scratch.search(table, vertices_, {Labels::ignored, rules_.mirror},
                       std::span<std::uint8_t>(scratch.code));
        return hash_of(scratch.code);
    }

    void expand_round() {
        const std::size_t begin = expanded();
        const std::size_t states = std::min(queue_.size() - begin, block_states * round_blocks);
        const std::size_t blocks = (states + block_states - 1) / block_states;
        blocks_.resize(std::max(blocks_.size(), blocks));
        for_each_task(workers_, blocks, [&](unsigned worker, std::size_t b) {
            const std::size_t first = begin + b * block_states;
            expand_block(scratch_[worker], blocks_[b], first,
                         std::min(first + block_states, begin + states));
        });
        for (std::size_t b = 0; b < blocks; ++b)
            append_rows(blocks_[b]);
        for_each_task(workers_, shard_count, [&](unsigned, std::size_t s) {
            for (std::size_t b = 0; b < blocks; ++b)
                deliver(s, blocks_[b]);
        });
        queue_fresh();
    }

    void expand_block(Scratch& scratch, Block& block, std::size_t first, std::size_t last) const {
        for (Mail& mail : block.mail)
            mail.clear();
        block.degrees.clear();
        block.relabellings.clear();
        block.arcs = 0;
        for (std::size_t i = first; i < last; ++i) {
            decode(code(queue_[i]), scratch.table);
            const std::uint32_t arcs_before = block.arcs;
            for (Index e = 0; e < halfedges_ / 2; ++e)
                expand_edge(scratch, block, {e});
            block.degrees.push_back(block.arcs - arcs_before);
        }
    }

    void expand_edge(Scratch& scratch, Block& block, Edge e) const {
        const MutableHalfedgeTable table(scratch.table);
        const auto sides = Quadrilateral::around(table, e);
        if (rules_.simple_only && are_joined(table, sides.h2, at(table, sides.t2).origin)) return;
        if (!flip(table, e)) return;
        const std::uint64_t hash = canonicalise(scratch, table);
        const auto roots = scratch.search.best_roots();
        Mail& mail = block.mail[shard_of(hash)];
        mail.codes.insert(mail.codes.end(), scratch.code.begin(), scratch.code.end());
        mail.hashes.push_back(hash);
        mail.symmetries.push_back(static_cast<std::uint32_t>(roots.size()));
        mail.arcs.push_back(block.arcs++);
        if (rules_.keep_relabellings) {
            number_vertices(scratch.walk, table, roots.front(), vertices_, scratch.numbers);
            block.relabellings.insert(block.relabellings.end(), scratch.numbers.begin(),
                                      scratch.numbers.end());
        }
        static_cast<void>(unflip(table, e));
    }

    void append_rows(Block& block) {
        block.first_arc = found_.targets.size();
        for (const std::uint32_t degree : block.degrees) {
            found_.offsets.push_back(found_.offsets.back() + degree);
        }
        found_.targets.resize(found_.targets.size() + block.arcs);
        relabellings_.insert(relabellings_.end(), block.relabellings.begin(),
                             block.relabellings.end());
    }

    void deliver(std::size_t s, const Block& block) {
        const Mail& mail = block.mail[s];
        for (std::size_t i = 0; i < mail.arcs.size(); ++i) {
            const std::span<const std::uint8_t> code(mail.codes.data() + i * code_length(),
                                                     code_length());
            found_.targets[block.first_arc + mail.arcs[i]] =
                take_in(s, code, mail.hashes[i], mail.symmetries[i]);
        }
    }

    StateId take_in(std::size_t s, std::span<const std::uint8_t> code, std::uint64_t hash,
                    std::size_t symmetries) {
        Shard& shard = shards_[s];
        const auto [number, is_new] = shard.codes.insert(code, hash);
        const auto id = static_cast<StateId>(number * shard_count + s);
        if (is_new) {
            shard.symmetries.push_back(static_cast<std::uint32_t>(symmetries));
            shard.fresh.push_back(id);
        }
        return id;
    }

    void queue_fresh() {
        for (Shard& shard : shards_) {
            queue_.insert(queue_.end(), shard.fresh.begin(), shard.fresh.end());
            shard.fresh.clear();
        }
    }

    // ---- limits and checkpoints ----

    void require_memory() const {
        std::uint64_t held = queue_.size() * sizeof(StateId) + relabellings_.size() +
                             found_.targets.size() * sizeof(StateId) +
                             found_.offsets.size() * sizeof(std::uint64_t);
        for (const Shard& shard : shards_) {
            held += shard.codes.bytes() + shard.symmetries.size() * sizeof(std::uint32_t);
        }
        // Arrays hold up to twice their content and are copied when they grow; a round is mail.
        const std::uint64_t round = block_states * round_blocks * code_length() *
                                    (code_length() + sizeof(std::uint64_t) * 2);
        const std::uint64_t needed = 3 * held + round;
        if (needed <= limits_.memory_bytes) return;
        throw ExplorationStopped(ExplorationStopped::Reason::memory,
                                 "to go on may take " + std::to_string(needed >> 20) +
                                     " MiB, more than the limit of " +
                                     std::to_string(limits_.memory_bytes >> 20) + " MiB; " +
                                     std::to_string(queue_.size()) + " classes known and " +
                                     std::to_string(expanded()) + " expanded");
    }

    [[nodiscard]] std::filesystem::path checkpoint() const {
        return limits_.checkpoint_directory / "classes.checkpoint";
    }
    [[nodiscard]] std::vector<std::uint64_t> parameters() const {
        return {static_cast<std::uint64_t>(vertices_),
                static_cast<std::uint64_t>(halfedges_),
                rules_.mirror == Mirror::identified ? 1U : 0U,
                rules_.simple_only ? 1U : 0U,
                rules_.keep_relabellings ? 1U : 0U,
                shard_count};
    }

    void keep() const {
        if (limits_.checkpoint_directory.empty()) return;
        write_file(checkpoint(), [this](std::ostream& out) {
            CheckpointWriter writer(out, checkpoint_kind);
            writer.array(parameters());
            for (const Shard& shard : shards_) {
                writer.array(shard.codes.codes());
                writer.array(shard.symmetries);
            }
            writer.array(queue_);
            writer.array(found_.offsets);
            writer.array(found_.targets);
            writer.array(relabellings_);
            writer.finish();
        });
    }

    static constexpr std::string_view checkpoint_kind = "tightflip classes 1";

    Index vertices_;
    Index halfedges_;
    ClassRules rules_;
    const ExplorationLimits& limits_;
    unsigned workers_;
    std::vector<Scratch> scratch_;
    std::vector<Shard> shards_;
    std::vector<StateId> queue_;  // every state; the first expanded() of them have their row
    FlipGraphTable found_;        // rows in the order of the queue
    std::vector<std::uint8_t> relabellings_;
    std::vector<Block> blocks_;
    Clock::time_point began_;
    std::uint64_t resumed_ = 0;
};

}  // namespace

std::uint64_t ClassGraph::rooted_count() const noexcept {
    const std::uint64_t roots =
        static_cast<std::uint64_t>(halfedge_count) * (rules.mirror == Mirror::identified ? 2 : 1);
    return std::accumulate(
        symmetries.begin(), symmetries.end(), std::uint64_t{0},
        [roots](std::uint64_t sum, std::uint32_t order) { return sum + roots / order; });
}

std::size_t ClassGraph::find(const Triangulation& surface) const {
    if (surface.vertex_count() != vertex_count || surface.halfedge_count() != halfedge_count) {
        return size();
    }
    std::vector<std::uint8_t> wanted(code_length());
    CanonicalSearch search;
    search(surface.table(), vertex_count, {Labels::ignored, rules.mirror},
           std::span<std::uint8_t>(wanted));
    std::size_t first = 0;
    for (std::size_t length = size(); length > 0;) {  // the first state whose code is not less
        const std::size_t half = length / 2;
        if (std::ranges::lexicographical_compare(code(first + half), wanted)) {
            first += half + 1;
            length -= half + 1;
        } else {
            length = half;
        }
    }
    return first < size() && std::ranges::equal(code(first), wanted) ? first : size();
}

Triangulation ClassGraph::surface(std::size_t state) const {
    std::vector<HalfedgeRecord> records;
    decode(code(state), records);
    return build(std::move(records), vertex_count).value();
}

std::uint64_t class_graph_bytes_per_state(Index halfedges, ClassRules rules) noexcept {
    const auto edges = static_cast<std::uint64_t>(halfedges) / 2;
    const std::uint64_t arc = sizeof(StateId) + (rules.keep_relabellings ? edges / 3 + 2 : 0);
    return 3 * (edges + 3 * sizeof(std::uint64_t) + edges * arc);
}

ClassGraph explore_classes(std::span<const Triangulation> starts, ClassRules rules,
                           const ExplorationLimits& limits) {
    if (starts.empty()) throw std::invalid_argument("an exploration needs a start");
    const Triangulation& first = starts.front();
    if (first.halfedge_count() > max_class_halfedges) {
        throw std::invalid_argument("classes are explored for at most " +
                                    std::to_string(max_class_halfedges / 2) + " edges; " +
                                    std::to_string(first.edge_count()) + " are too many");
    }
    ClassExplorer explorer(first.vertex_count(), first.halfedge_count(), rules, limits);
    explorer.resume();
    for (const Triangulation& start : starts) {
        if (start.vertex_count() != first.vertex_count() ||
            start.halfedge_count() != first.halfedge_count()) {
            throw std::invalid_argument("the starts differ in their numbers of vertices or edges");
        }
        if (rules.simple_only && audit(start).is_simple() != true) {
            throw std::invalid_argument("a start has parallel edges; simple graphs were asked for");
        }
        explorer.add_start(start);
    }
    explorer.run();
    return explorer.take();
}

}  // namespace tightflip::kernel
