#include "hub_form.hpp"
#include "page_sort.hpp"
#include <tightflip/kernel/connect.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <bit>
#include <string>

namespace tightflip::kernel {
namespace {

ConnectRefusal objection(const Triangulation& from, const Triangulation& to) noexcept {
    if (from.vertex_count() != to.vertex_count()) return ConnectRefusal::different_vertex_counts;
    if (from.genus() != to.genus()) return ConnectRefusal::different_genus;
    return from.genus() != 0 ? ConnectRefusal::not_a_sphere : ConnectRefusal::none;
}

/// The degree of each vertex, indexed by vertex.
std::vector<Index> degrees(const Triangulation& surface) {
    std::vector<Index> degrees(static_cast<std::size_t>(surface.vertex_count()));
    for (const HalfedgeRecord& record : surface.table())
        ++degrees[static_cast<std::size_t>(record.origin.id)];
    return degrees;
}

Vertex highest(const std::vector<Index>& degrees) {
    return {static_cast<Index>(std::ranges::max_element(degrees) - degrees.begin())};
}

/// The two ends' common hub. The gathering makes F minus its degree flips on either side.
Vertex choose_hub(std::vector<Index> degrees_from, const std::vector<Index>& degrees_to) {
    for (std::size_t v = 0; v < degrees_to.size(); ++v)
        degrees_from[v] += degrees_to[v];
    return highest(degrees_from);
}

/// The root of both trees: the vertex with most edges of the tree of `gathered`, each of which is a
/// slide less to the book.
Vertex choose_root(const Triangulation& gathered, Vertex hub) {
    std::vector<Index> found = degrees(gathered);
    found[static_cast<std::size_t>(hub.id)] = 0;
    return highest(found);
}

/// Which edge of `a` each edge of `b` is, where both are hub forms of one labelled surface and the
/// tree halfedges `in_a` and `in_b` correspond: one walk round both trees, face by face.
std::vector<Edge> edges_in(HalfedgeTable a, Halfedge in_a, HalfedgeTable b, Halfedge in_b) {
    std::vector<Edge> image(b.size() / 2);
    for (std::size_t face = 0; face < b.size() / 3; ++face) {
        for (int side = 0; side < 3; ++side) {
            if (at(a, in_a).origin != at(b, in_b).origin) {
                throw std::logic_error("two hub forms differ that theory says are one surface");
            }
            image[static_cast<std::size_t>(edge_of(in_b).id)] = edge_of(in_a);
            in_a = at(a, in_a).next;
            in_b = at(b, in_b).next;
        }
        in_a = at(a, twin(at(a, in_a).next)).next;
        in_b = at(b, twin(at(b, in_b).next)).next;
    }
    return image;
}

}  // namespace

std::string_view describe(ConnectRefusal refusal) noexcept {
    switch (refusal) {
        case ConnectRefusal::none:
            return {};
        case ConnectRefusal::different_vertex_counts:
            return "the two surfaces have different numbers of vertices, which flips keep";
        case ConnectRefusal::different_genus:
            return "the two surfaces differ in genus, which flips keep";
        case ConnectRefusal::not_a_sphere:
            return "the two surfaces are no spheres; a path is constructed for genus 0 only";
    }
    return {};
}

const FlipLog& ConnectResult::value() const& {
    if (!path) throw std::invalid_argument(std::string(describe(refusal)));
    return *path;
}

FlipLog&& ConnectResult::value() && {
    static_cast<void>(std::as_const(*this).value());
    return *std::move(path);
}

// With n = V - 2 edges of the tree: gathering takes at most F - 2 = 2 V - 6 flips on either side,
// since a vertex has degree 2 or more; the book at most n - 1 slides, since the root has an edge;
// the sorting at most n ceil(log2 n) slides (page_sort.hpp); drawing out at most n - 1. A slide is
// two flips. Together 4 V - 12 + 4 (n - 1) + 2 n ceil(log2 n).
std::int64_t connect_bound(Index vertices) noexcept {
    if (vertices < 4) return 0;  // there is one labelled sphere
    const auto pages = static_cast<std::uint64_t>(vertices) - 2;
    const auto halvings = static_cast<std::int64_t>(std::bit_width(pages - 1));
    return 2 * static_cast<std::int64_t>(pages) * halvings + 8 * std::int64_t{vertices} - 24;
}

ConnectResult connect(const Triangulation& from, const Triangulation& to) {
    if (const ConnectRefusal refusal = objection(from, to); refusal != ConnectRefusal::none) {
        return {std::nullopt, refusal};
    }
    std::vector<Index> degrees_from = degrees(from);
    const std::vector<Index> degrees_to = degrees(to);
    if (degrees_from == degrees_to && same_labelled_surface(from, to)) return {FlipLog{from, {}}};
    const Vertex hub = choose_hub(std::move(degrees_from), degrees_to);

    FlipTrail ahead(from);
    ahead.reserve(static_cast<std::size_t>(connect_bound(from.vertex_count())));
    hub_form::gather(ahead, hub_form::leaving(ahead.table(), hub));
    const Vertex root = choose_root(ahead.surface(), hub);

    FlipTrail back(to);
    hub_form::gather(back, hub_form::leaving(back.table(), hub));
    const Halfedge first = hub_form::tree_edge_from(back.table(), root, hub);
    const hub_form::Walk walk = hub_form::depth_first(back.table(), to.vertex_count(), first);
    hub_form::draw_out(back, walk);

    Halfedge page = hub_form::tree_edge_from(ahead.table(), root, hub);
    hub_form::spread(ahead, page);
    page = hub_form::sort_pages(ahead, walk.ranks, page);

    const std::vector<Edge> image = edges_in(ahead.table(), page, back.table(), first);
    std::vector<Edge> flips = std::move(ahead).take_flips();
    for (std::size_t k = back.flips().size(); k-- > 0;)
        flips.push_back(image[static_cast<std::size_t>(back.flips()[k].id)]);
    return {FlipLog{from, std::move(flips)}};
}

}  // namespace tightflip::kernel
