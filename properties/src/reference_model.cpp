#include <tightflip/properties/reference_model.hpp>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace tightflip::properties {
namespace {

using Word = std::array<Index, 3>;

Word begun_with(Word word, Index s) {
    std::rotate(word.begin(), std::ranges::find(word, s), word.end());
    return word;
}

Word inverse(const Word& word) {
    return {-word[2], -word[1], -word[0]};
}

bool contains(const Word& word, Index s) {
    return std::ranges::find(word, s) != word.end();
}

template <class Items>
auto& nth(Items& items, Index i) {
    return items[static_cast<std::size_t>(i)];
}

/// One name for the three rotations of a word.
Word least_rotation(const Word& word) {
    return begun_with(word, *std::ranges::min_element(word));
}

}  // namespace

ReferenceModel::ReferenceModel(const Triangulation& surface)
    : vertex_count_(surface.vertex_count()) {
    for (Index e = 0; e < surface.edge_count(); ++e) {
        const kernel::Halfedge h = halfedge_of(Edge{e});
        ends_.emplace_back(surface.origin(h).id, surface.target(h).id);
    }
    for (const kernel::Halfedge side : surface.faces()) {
        Word word{};
        kernel::Halfedge h = side;
        for (SignedEdge& s : word) {
            s = h.id % 2 == 0 ? h.id / 2 + 1 : -(h.id / 2 + 1);
            h = surface.next(h);
        }
        faces_.push_back(word);
    }
}

ReferenceModel::ReferenceModel(const Gluing& gluing)
    : faces_(gluing.faces.size()), vertex_count_(gluing.vertex_count) {
    if (!kernel::audit(gluing).is_closed_surface()) {
        throw std::invalid_argument("a reference model needs a closed connected surface");
    }
    std::vector<SignedEdge> edge_of_side(3 * gluing.faces.size());  // 0: not yet known
    for (Index side = 0; side < static_cast<Index>(edge_of_side.size()); ++side) {
        if (nth(edge_of_side, side) == 0) {
            const auto start_of = [&](Index s) {
                return nth(nth(gluing.faces, s / 3).corners, s % 3);
            };
            const Index other = nth(nth(gluing.faces, side / 3).sides, side % 3).side();
            const Index from = start_of(side);
            ends_.emplace_back(from, start_of(side - side % 3 + (side + 1) % 3));
            const auto forwards = static_cast<SignedEdge>(ends_.size());
            nth(edge_of_side, side) = forwards;
            nth(edge_of_side, other) = start_of(other) == from ? forwards : -forwards;
        }
        nth(nth(faces_, side / 3), side % 3) = nth(edge_of_side, side);
    }
}

Index ReferenceModel::start(SignedEdge s) const {
    return s > 0 ? nth(ends_, s - 1).first : nth(ends_, -s - 1).second;
}

ReferenceModel::Pair ReferenceModel::around(Edge e) const {
    const SignedEdge s = e.id + 1;
    Pair pair{-1, -1, {}, {}};
    for (Index face = 0; face < static_cast<Index>(faces_.size()); ++face) {
        const Word& word = nth(faces_, face);
        if (!contains(word, s) && !contains(word, -s)) continue;
        // With both signs about, the first is the face that has +e; with one sign twice, either.
        if (pair.first_face < 0) {
            pair = {face, -1, word, {}};
        } else {
            pair.second_face = face;
            pair.second = word;
        }
    }
    if (pair.second_face < 0) throw std::invalid_argument("no two faces share this edge");
    if (!contains(pair.first, s) && contains(pair.second, s)) {
        std::swap(pair.first_face, pair.second_face);
        std::swap(pair.first, pair.second);
    }
    if (!contains(pair.first, s)) pair.first = inverse(pair.first);
    if (!contains(pair.second, -s)) pair.second = inverse(pair.second);
    pair.first = begun_with(pair.first, s);
    pair.second = begun_with(pair.second, -s);
    return pair;
}

bool ReferenceModel::can_flip(Edge e) const {
    const Pair pair = around(e);
    return start(pair.first[2]) != start(pair.second[2]);
}

bool ReferenceModel::flip(Edge e) {
    if (!can_flip(e)) return false;
    const auto [first_face, second_face, first, second] = around(e);
    const auto& [plus, x, y] = first;
    const auto& [minus, p, q] = second;
    nth(ends_, e.id) = {start(q), start(y)};
    nth(faces_, first_face) = {plus, y, p};
    nth(faces_, second_face) = {minus, q, x};
    return true;
}

bool ReferenceModel::unflip(Edge e) {
    if (!can_flip(e)) return false;
    const auto [first_face, second_face, first, second] = around(e);
    const auto& [plus, y, p] = first;
    const auto& [minus, q, x] = second;
    nth(ends_, e.id) = {start(p), start(x)};
    nth(faces_, first_face) = {plus, x, y};
    nth(faces_, second_face) = {minus, p, q};
    return true;
}

Gluing ReferenceModel::gluing() const {
    Gluing gluing{.vertex_count = vertex_count_, .faces = {}};
    std::vector<Index> first_side(ends_.size(), -1);  // where an edge was met first
    for (const Word& word : faces_) {
        kernel::GluedFace& glued = gluing.faces.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            glued.corners[i] = start(word[i]);
            const auto side = static_cast<Index>(3 * (gluing.faces.size() - 1) + i);
            Index& first = nth(first_side, std::abs(word[i]) - 1);
            if (first < 0) {
                first = side;
                continue;
            }
            const bool same_sign = nth(nth(faces_, first / 3), first % 3) == word[i];
            const auto glue = [&](Index s, Index t) {
                nth(nth(gluing.faces, s / 3).sides, s % 3) =
                    same_sign ? kernel::SideGluing::reversed(t) : kernel::SideGluing::coherent(t);
            };
            glue(first, side);
            glue(side, first);
        }
    }
    return gluing;
}

std::optional<Edge> ReferenceModel::difference(const Triangulation& surface) const {
    const ReferenceModel other(surface);
    const auto [mine, others] = std::ranges::mismatch(ends_, other.ends_);
    if (mine != ends_.end()) return Edge{static_cast<Index>(mine - ends_.begin())};
    if (others != other.ends_.end() || other.faces_.size() != faces_.size()) return Edge{0};
    std::vector<Word> words;
    for (const Word& word : other.faces_)
        words.push_back(least_rotation(word));
    std::ranges::sort(words);
    for (const Word& word : faces_) {
        if (!std::ranges::binary_search(words, least_rotation(word))) {
            return Edge{std::abs(word[0]) - 1};
        }
    }
    return std::nullopt;
}

}  // namespace tightflip::properties
