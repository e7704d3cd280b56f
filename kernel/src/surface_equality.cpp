#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <vector>

namespace tightflip::kernel {
namespace {

/// What an isomorphism of labelled surfaces must keep of a halfedge: the labels of its ends and of
/// the corners on both sides, in one word.
std::uint64_t signature(HalfedgeTable table, Halfedge h) noexcept {
    const auto corner_opposite = [&](Halfedge x) {
        return at(table, at(table, at(table, x).next).next).origin;
    };
    std::uint64_t word = 0;
    for (const Vertex v : {at(table, h).origin, at(table, twin(h)).origin, corner_opposite(h),
                           corner_opposite(twin(h))}) {
        word = mix(word ^ (static_cast<std::uint64_t>(v.id) + 1));
    }
    return word;
}

std::vector<std::uint64_t> signatures(const Triangulation& surface) {
    std::vector<std::uint64_t> words(static_cast<std::size_t>(surface.halfedge_count()));
    for (std::size_t h = 0; h < words.size(); ++h) {
        words[h] = signature(surface.table(), {static_cast<Index>(h)});
    }
    return words;
}

/// A signature that as few halfedges as possible share.
std::uint64_t rarest(std::vector<std::uint64_t> words) {
    std::ranges::sort(words);
    std::uint64_t best = words.front();
    auto best_count = words.size() + 1;
    for (auto group = words.begin(); group != words.end();) {
        const auto end = std::upper_bound(group, words.end(), *group);
        const auto count = static_cast<std::size_t>(end - group);
        if (count < best_count) {
            best = *group;
            best_count = count;
        }
        group = end;
    }
    return best;
}

/// Whether sending `from` to `to` extends to an isomorphism. Surfaces are connected and of equal
/// size, so a map that respects next, twin and origin everywhere is one.
bool extends(HalfedgeTable a, HalfedgeTable b, Halfedge from, Halfedge to) {
    std::vector<Halfedge> image(a.size());
    std::vector<Halfedge> pending{from};
    image[static_cast<std::size_t>(from.id)] = to;
    const auto send = [&](Halfedge x, Halfedge y) {
        Halfedge& known = image[static_cast<std::size_t>(x.id)];
        if (known.is_valid()) return known == y;
        known = y;
        pending.push_back(x);
        return true;
    };
    while (!pending.empty()) {
        const Halfedge x = pending.back();
        pending.pop_back();
        const Halfedge y = image[static_cast<std::size_t>(x.id)];
        if (at(a, x).origin != at(b, y).origin) return false;
        if (!send(at(a, x).next, at(b, y).next) || !send(twin(x), twin(y))) return false;
    }
    return true;
}

}  // namespace

bool same_labelled_surface(const Triangulation& a, const Triangulation& b) {
    if (a.vertex_count() != b.vertex_count() || a.halfedge_count() != b.halfedge_count()) {
        return false;
    }
    const std::vector<std::uint64_t> words_a = signatures(a);
    const std::vector<std::uint64_t> words_b = signatures(b);
    const std::uint64_t word = rarest(words_a);
    if (std::ranges::count(words_a, word) != std::ranges::count(words_b, word)) return false;
    const Halfedge from{static_cast<Index>(std::ranges::find(words_a, word) - words_a.begin())};
    for (std::size_t h = 0; h < words_b.size(); ++h) {
        if (words_b[h] == word && extends(a.table(), b.table(), from, {static_cast<Index>(h)})) {
            return true;
        }
    }
    return false;
}

std::uint64_t surface_hash(const Triangulation& surface) noexcept {
    auto hash = static_cast<std::uint64_t>(surface.vertex_count());
    for (Index h = 0; h < surface.halfedge_count(); ++h)
        hash += signature(surface.table(), {h});
    return mix(hash);
}

}  // namespace tightflip::kernel
