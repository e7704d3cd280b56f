#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/canonical.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/rooted_decode.hpp>

#include <stdexcept>

namespace tightflip::kernel {
namespace {

constexpr auto accept_all = [](Index) { return true; };

/// The image of a halfedge as a directed edge, given the image of the side of a face that it is.
Halfedge directed(Halfedge side_image, Handedness handedness) noexcept {
    return handedness == Handedness::kept ? side_image : twin(side_image);
}

void require(bool holds, const char* reason) {
    if (!holds) throw std::invalid_argument(reason);
}

/// A labelled code taken apart: the code without labels, and the labels in the order in which the
/// code says them.
struct LabelledWord {
    std::vector<Index> gluing;
    std::vector<Index> labels;

    explicit LabelledWord(std::span<const Index> symbols) {
        require(symbols.size() > 3, "a code with labels begins with three of them");
        labels.assign(symbols.begin(), symbols.begin() + 3);
        for (std::size_t i = 3; i < symbols.size(); ++i) {
            gluing.push_back(symbols[i]);
            if (symbols[i] != 0) continue;
            require(++i < symbols.size(), "the code ends before the label of a new face");
            labels.push_back(symbols[i]);
        }
    }
};

/// Renames the vertices of a surface just decoded, which are numbered in the order of the walk.
void put_labels(std::vector<HalfedgeRecord>& records, Index vertex_count,
                std::span<const Index> labels) {
    RootedWalk walk;
    walk(records, {Halfedge{0}}, Labels::ignored, accept_all);
    std::vector<Index> label_of;
    std::size_t side = 0;
    for (const Index label : labels) {
        const Halfedge corner = walk.order()[side];
        const auto vertex = static_cast<std::size_t>(at(HalfedgeTable(records), corner).origin.id);
        require(label >= 0 && label < vertex_count, "a label is out of range");
        if (vertex == label_of.size()) label_of.push_back(label);
        require(label_of[vertex] == label, "a vertex has two labels");
        side += side < 2 ? 1 : 3;  // every later face says its third corner
    }
    for (HalfedgeRecord& record : records) {
        record.origin = {label_of[static_cast<std::size_t>(record.origin.id)]};
    }
}

}  // namespace

std::uint64_t digest(const CanonicalCode& code) noexcept {
    const auto [labels, mirror] = code.equality();
    std::uint64_t sum = 4 * static_cast<std::uint64_t>(code.vertex_count()) +
                        2 * static_cast<std::uint64_t>(labels) + static_cast<std::uint64_t>(mirror);
    for (const Index symbol : code.symbols())
        sum = mix(sum ^ static_cast<std::uint64_t>(symbol)) + 1;
    return mix(sum);
}

std::string to_string(const CanonicalCode& code) {
    std::string text;
    for (const Index symbol : code.symbols()) {
        if (!text.empty()) text += ' ';
        text += std::to_string(symbol);
    }
    return text;
}

CanonicalForm::CanonicalForm(const Triangulation& surface, Equality equality) {
    code.vertex_count_ = surface.vertex_count();
    code.equality_ = equality;
    code.symbols_.resize(code_length(surface.table().size(), equality.labels));
    CanonicalSearch search;
    search(surface.table(), surface.vertex_count(), equality, std::span(code.symbols_));
    roots.assign(search.best_roots().begin(), search.best_roots().end());
}

CanonicalCode canonical_code(const Triangulation& surface, Equality equality) {
    return CanonicalForm(surface, equality).code;
}

std::size_t automorphism_count(const Triangulation& surface, Equality equality) {
    return CanonicalForm(surface, equality).roots.size();
}

std::optional<Isomorphism> isomorphism(const Triangulation& a, const Triangulation& b,
                                       Equality equality) {
    if (a.vertex_count() != b.vertex_count() || a.halfedge_count() != b.halfedge_count()) {
        return std::nullopt;
    }
    const CanonicalForm form_a(a, equality);
    const CanonicalForm form_b(b, equality);
    if (form_a.code != form_b.code) return std::nullopt;

    // Walks that spell the same word meet images of the same sides.
    const Root root_a = form_a.roots.front();
    const Root root_b = form_b.roots.front();
    RootedWalk walk_a;
    RootedWalk walk_b;
    walk_a(a.table(), root_a, Labels::ignored, accept_all);
    walk_b(b.table(), root_b, Labels::ignored, accept_all);
    Isomorphism map;
    map.handedness =
        root_a.handedness == root_b.handedness ? Handedness::kept : Handedness::mirrored;
    map.halfedges.resize(a.table().size());
    map.vertices.resize(static_cast<std::size_t>(a.vertex_count()));
    for (std::size_t i = 0; i < a.table().size(); ++i) {
        const Halfedge h = walk_a.order()[i];
        const Halfedge image = directed(walk_b.order()[i], map.handedness);
        map.halfedges[static_cast<std::size_t>(h.id)] = image;
        map.vertices[static_cast<std::size_t>(a.origin(h).id)] = b.origin(image);
    }
    return map;
}

std::vector<Index> rooted_code(const Triangulation& surface, Root root, Labels labels) {
    static_cast<void>(surface.origin(root.halfedge));  // refuses one that does not exist
    std::vector<Index> symbols;
    symbols.reserve(code_length(surface.table().size(), labels));
    RootedWalk walk;
    walk(surface.table(), root, labels, [&](Index symbol) {
        symbols.push_back(symbol);
        return true;
    });
    return symbols;
}

Triangulation surface_of(std::span<const Index> symbols, Labels labels) {
    std::vector<HalfedgeRecord> records;
    Index vertex_count = 0;
    if (labels == Labels::ignored) {
        vertex_count = decode(symbols, records);
    } else {
        const LabelledWord word(symbols);
        vertex_count = decode(std::span(word.gluing), records);
        put_labels(records, vertex_count, word.labels);
    }
    return build(std::move(records), vertex_count).value();
}

Triangulation surface_of(const CanonicalCode& code) {
    return surface_of(code.symbols(), code.equality().labels);
}

}  // namespace tightflip::kernel
