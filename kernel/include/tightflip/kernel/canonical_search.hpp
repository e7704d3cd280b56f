/// \file
/// The canonical code among those of all roots of a surface, and the roots that give it.
#pragma once

#include <tightflip/kernel/root_orbits.hpp>
#include <tightflip/kernel/rooted_code.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace tightflip::kernel {

/// Whether a surface and its mirror image are two things or one.
enum class Mirror : std::uint8_t { distinct, identified };

/// What two surfaces must share to be called equal.
struct Equality {
    Labels labels = Labels::ignored;
    Mirror mirror = Mirror::distinct;

    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the ordering's 0 for a pointer
    friend constexpr auto operator<=>(Equality, Equality) noexcept = default;
};

/// The roots from which a surface's code is canonical. They are one orbit of its automorphisms
/// (among which the reversals count where mirror images are identified), so their number is the
/// order of the group.
class CanonicalSearch {
public:
    /// Writes the canonical code to `code`, which has room for `code_length` symbols, and keeps the
    /// roots that give it. Preconditions: the table is a valid connected surface whose origins lie
    /// below `vertex_count`; every symbol fits a Symbol.
    ///
    /// It is the least code among those of the candidates: roots that leave a vertex of the rarest
    /// kind and there have the least invariant. A candidate is given up at the first symbol that is
    /// too great, and one that an automorphism found earlier sends to another candidate is not
    /// tried. Linear time where candidates that are not alike soon differ, as on nearly all
    /// surfaces; O(n log n) where all are alike; at worst quadratic.
    template <class Symbol>
    void operator()(HalfedgeTable table, Index vertex_count, Equality equality,
                    std::span<Symbol> code) {
        collect_candidates(table, vertex_count, equality);
        best_.clear();
        orbits_known_ = false;
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            if (orbits_known_ && orbits_.first_of_orbit(i) < i) continue;
            try_candidate(table, i, equality.labels, code);
        }
        if (orbits_known_) collect_orbit_of_best();
    }

    [[nodiscard]] std::span<const Root> best_roots() const noexcept { return best_; }

private:
    enum class Comparison : std::uint8_t { less, equal, greater };

    /// Below so many untried candidates, trying them costs less than knowing their orbits.
    static constexpr std::size_t fewest_worth_pruning = 32;

    template <class Symbol>
    void try_candidate(HalfedgeTable table, std::size_t i, Labels labels, std::span<Symbol> code) {
        const Root root = candidates_[i];
        const Comparison comparison = compare(table, root, labels, code);
        if (comparison == Comparison::greater) return;
        if (comparison == Comparison::less) {
            best_.clear();
            best_index_ = i;
        } else if (orbits_known_ || candidates_.size() - i > fewest_worth_pruning) {
            learn_automorphism(table, root);
        }
        best_.push_back(root);
    }

    /// Compares the code from `root` with the one that stands in `code`, which becomes the lesser.
    template <class Symbol>
    Comparison compare(HalfedgeTable table, Root root, Labels labels, std::span<Symbol> code) {
        std::size_t place = 0;
        bool is_less = best_.empty();
        const bool is_complete = walk_(table, root, labels, [&](Index word) {
            const auto symbol = static_cast<Symbol>(word);
            Symbol& least = code[place++];
            if (is_less) {
                least = symbol;
                return true;
            }
            if (symbol > least) return false;
            is_less = symbol < least;
            least = symbol;
            return true;
        });
        if (!is_complete) return Comparison::greater;
        return is_less ? Comparison::less : Comparison::equal;
    }

    /// Walks that spell the same word meet images of the same halfedges.
    void learn_automorphism(HalfedgeTable table, Root image_of_best) {
        if (!orbits_known_) orbits_.reset(candidates_, table.size());
        orbits_known_ = true;
        const Root best = candidates_[best_index_];
        walk_of_best_(table, best, Labels::ignored, [](Index) { return true; });
        orbits_.add_generator(walk_of_best_.order(), walk_.order(),
                              best.handedness != image_of_best.handedness);
    }

    void collect_orbit_of_best() {
        best_.clear();
        const std::size_t orbit = orbits_.first_of_orbit(best_index_);
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            if (orbits_.first_of_orbit(i) == orbit) best_.push_back(candidates_[i]);
        }
    }

    void collect_candidates(HalfedgeTable table, Index vertex_count, Equality equality) {
        find_kinds(table, vertex_count, equality.labels);
        const std::uint32_t rarest = rarest_kind();
        candidates_.clear();
        Invariant least{~std::uint64_t{0}, ~std::uint64_t{0}};
        const auto offer = [&](Root root, const Invariant& invariant) {
            if (invariant > least) return;
            if (invariant < least) candidates_.clear();
            least = invariant;
            candidates_.push_back(root);
        };
        for (std::size_t i = 0; i < table.size(); ++i) {
            const Halfedge h{static_cast<Index>(i)};
            if (kind(at(table, h).origin) != rarest) continue;
            const Halfedge t = twin(h);
            const std::uint64_t to = kind(at(table, t).origin);
            const std::uint64_t left = kind(corner_opposite(table, h));
            const std::uint64_t right = kind(corner_opposite(table, t));
            offer({h, Handedness::kept}, {to, left << 32 | right});
            if (equality.mirror == Mirror::identified) {
                offer({t, Handedness::mirrored}, {to, right << 32 | left});
            }
        }
    }

    /// What an isomorphism keeps of a vertex: with labels its label, else its degree.
    void find_kinds(HalfedgeTable table, Index vertex_count, Labels labels) {
        degree_.assign(static_cast<std::size_t>(vertex_count), 0);
        for (const HalfedgeRecord& record : table)
            ++degree_[static_cast<std::size_t>(record.origin.id)];
        kind_ = degree_;
        if (labels == Labels::kept) std::iota(kind_.begin(), kind_.end(), std::uint32_t{0});
    }

    /// The kind of vertices that the fewest halfedges leave, of several the least.
    [[nodiscard]] std::uint32_t rarest_kind() {
        leaving_.assign(*std::max_element(kind_.begin(), kind_.end()) + std::size_t{1}, 0);
        for (std::size_t v = 0; v < kind_.size(); ++v)
            leaving_[kind_[v]] += degree_[v];
        std::uint32_t rarest = 0;
        for (std::uint32_t kind = 0; kind < leaving_.size(); ++kind) {
            // A kind that no vertex has counts as the largest of all.
            if (leaving_[kind] - 1 < leaving_[rarest] - 1) rarest = kind;
        }
        return rarest;
    }

    [[nodiscard]] std::uint32_t kind(Vertex v) const noexcept {
        return kind_[static_cast<std::size_t>(v.id)];
    }
    [[nodiscard]] static Vertex corner_opposite(HalfedgeTable table, Halfedge h) noexcept {
        return at(table, at(table, at(table, h).next).next).origin;
    }

    using Invariant = std::array<std::uint64_t, 2>;

    RootedWalk walk_;
    std::vector<std::uint32_t> degree_;
    std::vector<std::uint32_t> kind_;
    std::vector<std::uint32_t> leaving_;  // halfedges that leave vertices of a kind
    std::vector<Root> candidates_;
    std::vector<Root> best_;
    std::size_t best_index_ = 0;  // of a best root among the candidates
    RootOrbits orbits_;
    RootedWalk walk_of_best_;
    bool orbits_known_ = false;
};

}  // namespace tightflip::kernel
