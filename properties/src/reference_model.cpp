#include <tightflip/properties/reference_model.hpp>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace tightflip::properties {
namespace {

using Word = std::array<Index, 3>;

Word begun_with(Word word, Index s) {
    std::ranges::rotate(word, std::ranges::find(word, s));
    return word;
}

Word inverse(const Word& word) {
    return {-word[2], -word[1], -word[0]};
}

bool contains(const Word& word, Index s) {
    return std::ranges::find(word, s) != word.end();
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
        ends_[e] = {surface.origin(h).id, surface.target(h).id};
    }
    for (const kernel::Halfedge side : surface.faces()) {
        Word word{};
        kernel::Halfedge h = side;
        for (SignedEdge& s : word) {
            s = h.id % 2 == 0 ? h.id / 2 + 1 : -(h.id / 2 + 1);
            h = surface.next(h);
        }
        faces_[static_cast<Index>(faces_.size())] = word;
    }
}

ReferenceModel::ReferenceModel(const Gluing& gluing) : vertex_count_(gluing.vertex_count) {
    if (!kernel::audit(gluing).is_closed_surface()) {
        throw std::invalid_argument("a reference model needs a closed connected surface");
    }
    std::map<Index, SignedEdge> edge_of_side;
    for (Index f = 0; f < static_cast<Index>(gluing.faces.size()); ++f) {
        const auto& [corners, sides] = gluing.faces[static_cast<std::size_t>(f)];
        for (std::size_t i = 0; i < 3; ++i) {
            const Index side = 3 * f + static_cast<Index>(i);
            if (!edge_of_side.contains(side)) {
                const auto e = static_cast<Index>(ends_.size());
                ends_[e] = {corners[i], corners[(i + 1) % 3]};
                edge_of_side[side] = e + 1;
                edge_of_side[sides[i].side()] =
                    gluing.faces[static_cast<std::size_t>(sides[i].side() / 3)]
                                .corners[static_cast<std::size_t>(sides[i].side() % 3)] ==
                            corners[i]
                        ? e + 1
                        : -(e + 1);
            }
            faces_[f][i] = edge_of_side[side];
        }
    }
}

Index ReferenceModel::start(SignedEdge s) const {
    return s > 0 ? ends_.at(s - 1).first : ends_.at(-s - 1).second;
}

ReferenceModel::Pair ReferenceModel::around(Edge e) const {
    const SignedEdge s = e.id + 1;
    Pair pair{-1, -1, {}, {}};
    for (const auto& [face, word] : faces_) {
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
    ends_[e.id] = {start(q), start(y)};
    faces_[first_face] = {plus, y, p};
    faces_[second_face] = {minus, q, x};
    return true;
}

bool ReferenceModel::unflip(Edge e) {
    if (!can_flip(e)) return false;
    const auto [first_face, second_face, first, second] = around(e);
    const auto& [plus, y, p] = first;
    const auto& [minus, q, x] = second;
    ends_[e.id] = {start(p), start(x)};
    faces_[first_face] = {plus, x, y};
    faces_[second_face] = {minus, p, q};
    return true;
}

Gluing ReferenceModel::gluing() const {
    Gluing gluing{.vertex_count = vertex_count_, .faces = {}};
    std::map<Index, std::vector<std::pair<Index, bool>>> places;  // edge -> side, forwards
    for (const auto& [face, word] : faces_) {
        kernel::GluedFace& glued = gluing.faces.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            glued.corners[i] = start(word[i]);
            const auto side = static_cast<Index>(3 * (gluing.faces.size() - 1) + i);
            places[std::abs(word[i]) - 1].emplace_back(side, word[i] > 0);
        }
    }
    for (const auto& [edge, sides] : places) {
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const auto& [side, forwards] = sides[k];
            const auto& [other, other_forwards] = sides[sides.size() - 1 - k];
            gluing.faces[static_cast<std::size_t>(side / 3)]
                .sides[static_cast<std::size_t>(side % 3)] =
                forwards == other_forwards ? kernel::SideGluing::reversed(other)
                                           : kernel::SideGluing::coherent(other);
        }
    }
    return gluing;
}

std::optional<Edge> ReferenceModel::difference(const Triangulation& surface) const {
    const ReferenceModel other(surface);
    for (const auto& [edge, ends] : ends_) {
        const auto found = other.ends_.find(edge);
        if (found == other.ends_.end() || found->second != ends) return Edge{edge};
    }
    std::set<Word> words;
    for (const auto& [face, word] : other.faces_)
        words.insert(least_rotation(word));
    for (const auto& [face, word] : faces_) {
        if (!words.contains(least_rotation(word))) return Edge{std::abs(word[0]) - 1};
    }
    if (other.faces_.size() != faces_.size()) return Edge{0};
    return std::nullopt;
}

}  // namespace tightflip::properties
