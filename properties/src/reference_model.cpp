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

}  // namespace

ReferenceModel::ReferenceModel(const Triangulation& surface)
    : vertex_count_(surface.vertex_count()) {
    ends_.reserve(static_cast<std::size_t>(surface.edge_count()));
    faces_.reserve(static_cast<std::size_t>(surface.face_count()));
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
    const auto [first_face, second_face, first, second] = around(e);
    const auto& [plus, x, y] = first;
    const auto& [minus, p, q] = second;
    if (start(y) == start(q)) return false;
    nth(ends_, e.id) = {start(q), start(y)};
    nth(faces_, first_face) = {plus, y, p};
    nth(faces_, second_face) = {minus, q, x};
    return true;
}

bool ReferenceModel::unflip(Edge e) {
    const auto [first_face, second_face, first, second] = around(e);
    const auto& [plus, y, p] = first;
    const auto& [minus, q, x] = second;
    if (start(p) == start(x)) return false;
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
    if (surface.edge_count() != edge_count()) return Edge{0};
    // The table that this model would have. A side that is nowhere run through forwards, or twice,
    // leaves a record without a successor.
    std::vector<kernel::HalfedgeRecord> table(2 * ends_.size());
    for (std::size_t e = 0; e < ends_.size(); ++e) {
        table[2 * e].origin = {ends_[e].first};
        table[2 * e + 1].origin = {ends_[e].second};
    }
    const auto halfedge = [](SignedEdge s) {
        return kernel::Halfedge{s > 0 ? 2 * (s - 1) : 2 * (-s - 1) + 1};
    };
    for (const Word& word : faces_) {
        for (std::size_t i = 0; i < 3; ++i)
            nth(table, halfedge(word[i]).id).next = halfedge(word[(i + 1) % 3]);
    }
    const auto [mine, others] = std::ranges::mismatch(table, surface.table());
    if (mine == table.end()) return std::nullopt;
    return Edge{static_cast<Index>(mine - table.begin()) / 2};
}

}  // namespace tightflip::properties
