/// \file
/// Kernels of which it is known what is wrong with them.
#pragma once

#include <tightflip/kernel/build.hpp>
#include <tightflip/properties/kernel_under_test.hpp>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace tightflip::properties {

enum class Fault {
    none,
    cannot_be_made,
    lists_no_sides,
    lists_sides_of_tetrahedra_only,
    start_misread,
    lists_more_sides,
    miscounts,
    miscounts_after_flips,
    changes_a_far_label,
    turns_a_far_face,
    turns_all_faces,
    tears_a_side,
    forgets_a_label,
    swaps_outer_sides,
    flips_once_only,
    second_flip_differs,
    exchanges_four_times,
    allows_all,
    refuses_all,
    validates_all,
    validates_nothing,
    overlooks_origins,
    overlooks_nexts,
    overlooks_neighbours,
    overlooks_forbidden_edges,
    throws,
    throws_no_exception,
    exits,
    crashes,
    cannot_be_read_when_damaged,
    validator_throws_on_damage,
    validator_hangs_on_damage,
};

/// What a kernel promises and lets be done to it.
struct Offers {
    bool keeps_sides = true;
    bool gluings = true;
    bool origins = true;
    bool nexts = true;
    bool neighbours = true;
};

inline void exchange(SideTables& tables, Index a, Index b) {  // two sides swap their numbers
    const auto renamed = [&](Index s) { return s == a ? b : s == b ? a : s; };
    SideTables now = tables;
    for (Index s = 0; s < tables.size(); ++s) {
        const auto from = static_cast<std::size_t>(s);
        const auto to = static_cast<std::size_t>(renamed(s));
        now.next[to] = renamed(tables.next[from]);
        now.across[to] = renamed(tables.across[from]);
        now.origin[to] = tables.origin[from];
    }
    tables = std::move(now);
}

/// A naive kernel with one fault.
template <Fault fault, KernelClass kernel_class = KernelClass::loopless, Offers offers = Offers{}>
struct Naive {
    static constexpr std::string_view name = "naive";
    static constexpr KernelClass allowed = kernel_class;
    static constexpr bool keeps_sides = offers.keeps_sides;
    using Side = Index;

    Naive(Index vertices, std::span<const std::array<Index, 3>> faces)
        : Naive(kernel::build(faces, vertices).value()) {}
    explicit Naive(const Gluing& gluing) requires(offers.gluings)
        : Naive(kernel::build(gluing).value()) {}
    explicit Naive(const Triangulation& surface) : tables(side_tables(surface)) {
        if (fault == Fault::cannot_be_made) throw std::runtime_error("not today");
        if (fault == Fault::start_misread) flip_by_definition(tables, 0);
    }

    [[nodiscard]] std::array<Index, 3> counts() const {
        Index edges = tables.size() / 2;
        if (fault == Fault::miscounts) ++edges;
        if (fault == Fault::miscounts_after_flips) edges += flips;
        return {tables.vertex_count, edges, tables.size() / 3};
    }
    [[nodiscard]] std::vector<Side> sides() const {
        std::vector<Side> all;
        if (fault == Fault::lists_no_sides) return all;
        if (fault == Fault::lists_sides_of_tetrahedra_only && tables.size() != 12) return all;
        for (Index s = 0; s < tables.size(); ++s)
            all.push_back(s);
        if (fault == Fault::lists_more_sides && flips > 1) all.push_back(tables.size());
        return all;
    }
    [[nodiscard]] Side next(Side s) const { return tables.next[index(s)]; }
    [[nodiscard]] Side across(Side s) const {
        if (fault == Fault::cannot_be_read_when_damaged && damaged) {
            throw std::runtime_error("no such side");
        }
        return tables.across[index(s)];
    }
    [[nodiscard]] Index origin(Side s) const { return tables.origin[index(s)]; }
    [[nodiscard]] bool can_flip(Side s) const {
        if (fault == Fault::allows_all) return true;
        if (fault == Fault::refuses_all) return false;
        if (fault == Fault::flips_once_only && s == last) return false;
        SideTables after = tables;
        return flip_by_definition(after, s) && judge(after, allowed).is_valid();
    }
    void flip(Side s) {
        const auto around = sides_around(tables, s);
        if (!around) return;
        const auto [h, h1, h2, t, t1, t2] = *around;
        if (!flip_by_definition(tables, s)) return;
        ++flips;
        if (fault == Fault::second_flip_differs && s == last) flip_by_definition(tables, h1);
        last = s;
        switch (fault) {
            case Fault::changes_a_far_label:
                spoil_far_label(*around);
                break;
            case Fault::turns_a_far_face:
                turn_far_face(*around);
                break;
            case Fault::turns_all_faces:
                turn_all_faces();
                break;
            case Fault::tears_a_side:
                tables.across[index(h2)] = h2;
                break;
            case Fault::forgets_a_label:
                tables.origin[index(h)] = tables.origin[index(h1)];
                break;
            case Fault::swaps_outer_sides:
                exchange(tables, h1, t1);
                break;
            case Fault::exchanges_four_times:
                if (flips % 4 == 0) exchange(tables, h, t);
                break;
            case Fault::throws:
                if (flips == 3) throw std::runtime_error("out of sorts");
                break;
            case Fault::throws_no_exception:
                throw 7;
            case Fault::exits:
                if (flips == 3) std::exit(0);
                break;
            case Fault::crashes:
                if (flips == 3) std::raise(SIGSEGV);
                break;
            default:
                break;
        }
    }
    [[nodiscard]] bool is_valid() const {
        while (fault == Fault::validator_hangs_on_damage && damaged) {
            volatile int forever = 0;
            static_cast<void>(forever);
        }
        if (fault == Fault::validator_throws_on_damage && damaged) throw 7;
        if (fault == Fault::validates_all || overlooked) return true;
        if (fault == Fault::overlooks_forbidden_edges) {
            return judge(tables, KernelClass::delta_complex).is_valid();
        }
        return fault != Fault::validates_nothing && judge(tables, allowed).is_valid();
    }

    void set_origin(Side s, Index v) requires(offers.origins) {
        damaged = true;
        overlooked = fault == Fault::overlooks_origins;
        tables.origin[index(s)] = v;
    }
    void set_next(Side s, Side wrong) requires(offers.nexts) {
        damaged = true;
        overlooked = fault == Fault::overlooks_nexts;
        tables.next[index(s)] = wrong;
    }
    void set_across(Side s, Side wrong) requires(offers.neighbours) {
        damaged = true;
        overlooked = fault == Fault::overlooks_neighbours;
        tables.across[index(s)] = wrong;
    }

    static std::size_t index(Side s) { return static_cast<std::size_t>(s); }
    /// Every side gets the number of the next.
    void turn_all_faces() {
        SideTables turned = tables;
        for (Index s = 0; s < tables.size(); ++s) {
            const Index place = next(s);
            turned.next[index(place)] = next(place);
            turned.across[index(place)] = next(tables.across[index(s)]);
            turned.origin[index(place)] = origin(s);
        }
        tables = std::move(turned);
    }
    /// A side of neither face at the edge; there is one wherever there are three faces.
    [[nodiscard]] Side far_side(const std::array<Index, 6>& around) const {
        Side s = 0;
        while (std::ranges::find(around, s) != around.end())
            ++s;
        return s;
    }
    void spoil_far_label(const std::array<Index, 6>& around) {
        const Side s = far_side(around);
        tables.origin[index(s)] = (tables.origin[index(s)] + 1) % tables.vertex_count;
    }
    /// Its sides become each other; the surface stays as it is.
    void turn_far_face(const std::array<Index, 6>& around) {
        const Side s = far_side(around);
        const Side second = next(s);
        const Side third = next(second);
        exchange(tables, s, second);
        exchange(tables, second, third);
    }

    SideTables tables;
    Index flips = 0;
    Side last = -1;
    bool damaged = false;
    bool overlooked = false;
};

}  // namespace tightflip::properties
