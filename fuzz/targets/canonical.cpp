#include "canonical.hpp"

#include "renumbering.hpp"
#include "script_input.hpp"
#include "small_classes.hpp"
#include "targets.hpp"
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <array>
#include <ostream>
#include <stdexcept>

namespace tightflip::fuzz {
namespace {

using kernel::Equality;
using kernel::Halfedge;
using kernel::Handedness;
using kernel::Index;
using kernel::Labels;
using kernel::Mirror;
using kernel::Triangulation;

constexpr Layout layout{.head = 6, .record = 2, .most_records = most_canonical_flips};

constexpr std::array equalities{
    Equality{Labels::ignored, Mirror::distinct}, Equality{Labels::ignored, Mirror::identified},
    Equality{Labels::kept, Mirror::distinct}, Equality{Labels::kept, Mirror::identified}};

std::string in_words(Equality equality) {
    return std::string(equality.labels == Labels::kept ? "labels kept" : "labels ignored") +
           (equality.mirror == Mirror::identified ? ", mirror images identified"
                                                  : ", mirror images distinct");
}

/// Everything that `equality` calls the same as the surface, one way each.
std::vector<Triangulation> same_surfaces(const CanonicalCase& surfaces, Equality equality) {
    kernel::RandomStream random(surfaces.seed);
    std::vector<Triangulation> same{with_other_halfedges(surfaces.surface, random)};
    if (equality.labels == Labels::ignored) {
        same.push_back(with_other_labels(same.back(), random));
    }
    if (equality.mirror == Mirror::identified) {
        same.push_back(with_other_halfedges(mirrored(same.back()), random));
    }
    return same;
}

std::string objection_to_isomorphism(const Triangulation& a, const Triangulation& b,
                                     const kernel::Isomorphism& map, Equality equality) {
    const bool turned = map.handedness == Handedness::mirrored;
    if (turned && equality.mirror == Mirror::distinct) return "isomorphisms_keep_orientation: no";
    std::vector<bool> met(map.halfedges.size(), false);
    for (Halfedge h{0}; h.id < a.halfedge_count(); ++h.id) {
        const auto image = [&](Halfedge x) {
            return map.halfedges.at(static_cast<std::size_t>(x.id));
        };
        const Halfedge there = image(h);
        if (met.at(static_cast<std::size_t>(there.id))) return "isomorphisms_are_bijections: no";
        met[static_cast<std::size_t>(there.id)] = true;
        const kernel::Vertex v = map.vertices.at(static_cast<std::size_t>(a.origin(h).id));
        const bool keeps = image(twin(h)) == twin(there) && b.origin(there) == v &&
                           (turned ? b.next(twin(image(a.next(h)))) == twin(there)
                                   : b.next(there) == image(a.next(h))) &&
                           (equality.labels == Labels::ignored || v == a.origin(h));
        if (!keeps) return "isomorphisms_keep_the_surface: not at halfedge " + std::to_string(h.id);
    }
    return {};
}

/// Of two surfaces of one size: codes, isomorphisms and walks agree on whether they are the same.
std::string comparison_is_right(const Triangulation& a, const Triangulation& b, Equality equality) {
    const std::size_t expected = isomorphisms_by_walks(a, b, equality);
    const kernel::CanonicalCode code = canonical_code(a, equality);
    const kernel::CanonicalCode other = canonical_code(b, equality);
    const bool equal = code == other;
    if (equal != (expected > 0)) {
        return "codes_are_equal_exactly_for_isomorphic_surfaces: " + in_words(equality);
    }
    if ((digest(code) == digest(other)) != equal ||
        (to_string(code) == to_string(other)) != equal) {
        return "digests_and_words_stand_for_codes: " + in_words(equality);
    }
    const auto map = isomorphism(a, b, equality);
    if (map.has_value() != equal) return "isomorphisms_are_found: " + in_words(equality);
    if (map) {
        if (auto wrong = objection_to_isomorphism(a, b, *map, equality); !wrong.empty()) {
            return wrong + "; " + in_words(equality);
        }
    }
    if (equality == Equality{Labels::kept, Mirror::distinct}) {
        if (same_labelled_surface(a, b) != equal) return "labelled_comparison_agrees: no";
        if (equal && surface_hash(a) != surface_hash(b)) return "equal_surfaces_hash_alike: no";
    }
    return {};
}

std::string form_is_right(const Triangulation& surface, Equality equality) {
    const kernel::CanonicalForm form(surface, equality);
    if (form.code.vertex_count() != surface.vertex_count() || form.code.equality() != equality) {
        return "codes_know_what_they_are_of: " + in_words(equality);
    }
    const std::size_t symmetries = isomorphisms_by_walks(surface, surface, equality);
    if (form.roots.size() != symmetries || automorphism_count(surface, equality) != symmetries) {
        return "automorphisms_are_counted: " + std::to_string(form.roots.size()) + " for " +
               std::to_string(symmetries) + "; " + in_words(equality);
    }
    for (const kernel::Root root : form.roots) {
        if (!std::ranges::equal(rooted_code(surface, root, equality.labels), form.code.symbols())) {
            return "roots_spell_the_code: " + in_words(equality);
        }
    }
    const Triangulation decoded = surface_of(form.code);
    if (canonical_code(decoded, equality) != form.code) {
        return "codes_are_read_back: " + in_words(equality);
    }
    return {};
}

/// A word that is changed in one place is another surface's, or no word.
std::string changed_words_are_understood(const Triangulation& surface, std::uint64_t seed) {
    kernel::RandomStream random(seed);
    for (const Labels labels : {Labels::ignored, Labels::kept}) {
        std::vector<Index> word = rooted_code(surface, {Halfedge{0}, Handedness::kept}, labels);
        word[random.below(static_cast<std::uint32_t>(word.size()))] =
            static_cast<Index>(random.below(static_cast<std::uint32_t>(word.size()) + 2)) - 1;
        try {
            const Triangulation decoded = kernel::surface_of(word, labels);
            if (rooted_code(decoded, {Halfedge{0}, Handedness::kept}, labels) != word) {
                return "words_are_read_back: a changed one is not";
            }
        } catch (const std::invalid_argument&) {  // no walk spells it
        }
    }
    return {};
}

// ---- seeds ----

InputBytes canonical_input(const StartBytes& start, std::uint8_t seed,
                           std::span<const std::uint32_t> picks = {}) {
    InputBytes bytes = script_input(start, picks);
    bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(script_layout.head), seed);
    return bytes;
}

std::vector<Seed> seeds() {
    constexpr std::array<std::uint32_t, 3> flips{0, 5, 11};
    std::vector<Seed> seeds;
    for (const properties::StartKind& kind : properties::start_kinds()) {
        for (Index genus = 0; genus <= (kind.any_genus ? most_genus : 0); ++genus) {
            const auto genus_byte = static_cast<std::uint8_t>(genus);
            const std::string name = std::string(kind.name) + "_genus_" + std::to_string(genus);
            seeds.push_back({name, canonical_input({kind.name, 3, genus_byte, 1}, 2)});
            seeds.push_back(
                {name + "_flipped", canonical_input({kind.name, 8, genus_byte, 4}, 3, flips)});
        }
    }
    for (const SmallClass& one : small_classes())
        seeds.push_back({one.name, canonical_input(one.start, 1, one.flips)});
    return seeds;
}

}  // namespace

CanonicalCase decode_canonical(Input input) {
    Bytes bytes = Bytes::after_version(input.first(std::min(input.size(), layout.most_bytes())));
    Triangulation surface = decode_start(bytes).start();
    const std::uint64_t seed = bytes.byte();
    Triangulation other = surface;
    while (!bytes.empty()) {
        static_cast<void>(other.flip({static_cast<Index>(bytes.pair()) % other.edge_count()}));
    }
    return {std::move(surface), std::move(other), seed};
}

std::size_t isomorphisms_by_walks(const Triangulation& a, const Triangulation& b,
                                  Equality equality) {
    if (a.halfedge_count() != b.halfedge_count()) return 0;
    const auto word = rooted_code(a, {Halfedge{0}, Handedness::kept}, equality.labels);
    kernel::RootedWalk walk;
    std::size_t count = 0;
    for (Halfedge h{0}; h.id < b.halfedge_count(); ++h.id) {
        for (const Handedness handedness : {Handedness::kept, Handedness::mirrored}) {
            if (handedness == Handedness::mirrored && equality.mirror == Mirror::distinct) continue;
            std::size_t place = 0;
            count += walk(b.table(), {h, handedness}, equality.labels,
                          [&](Index symbol) { return symbol == word.at(place++); })
                         ? 1
                         : 0;
        }
    }
    return count;
}

std::string canonical_objection(const CanonicalCase& surfaces) {
    for (const Equality equality : equalities) {
        if (auto wrong = form_is_right(surfaces.surface, equality); !wrong.empty()) return wrong;
        for (const Triangulation& same : same_surfaces(surfaces, equality)) {
            if (canonical_code(same, equality) != canonical_code(surfaces.surface, equality)) {
                return "codes_do_not_depend_on_numbers: " + in_words(equality);
            }
            if (auto wrong = comparison_is_right(surfaces.surface, same, equality);
                !wrong.empty()) {
                return wrong;
            }
        }
        if (auto wrong = comparison_is_right(surfaces.surface, surfaces.other, equality);
            !wrong.empty()) {
            return wrong;
        }
    }
    return changed_words_are_understood(surfaces.surface, surfaces.seed);
}

const Target canonical_target{
    .name = "canonical",
    .description =
        "two surfaces some flips apart: canonical codes, isomorphisms and automorphisms "
        "beside the comparison of all walks",
    .layout = layout,
    .objection = [](Input input) { return canonical_objection(decode_canonical(input)); },
    .show =
        [](std::ostream& out, Input input) {
            Bytes bytes = Bytes::after_version(input);
            properties::FlipCase flip_case = decode_start(bytes);
            const std::uint32_t seed = bytes.byte();
            while (!bytes.empty() && flip_case.picks.size() < most_canonical_flips)
                flip_case.picks.push_back(bytes.pair());
            out << describe(flip_case) << "; renumbered by seed " << seed << '\n';
            properties::write_in_words(out, flip_case.log());
        },
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
