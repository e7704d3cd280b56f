#include "hub_form.hpp"
#include "page_sort.hpp"
#include <tightflip/kernel/doubled_fan.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace tightflip::kernel {
namespace {

/// The place of each vertex in the order; the hub has none.
hub_form::Ranks ranks_of(const Triangulation& sphere, Vertex hub, std::span<const Vertex> order) {
    if (sphere.genus() != 0) throw std::invalid_argument("a doubled fan is a sphere");
    hub_form::Ranks ranks(static_cast<std::size_t>(sphere.vertex_count()), -1);
    const auto vertices = static_cast<std::size_t>(sphere.vertex_count());
    Index rank = 0;
    const auto takes_a_rank = [&](Vertex v) {
        return static_cast<std::size_t>(v.id) < vertices && v != hub &&
               std::exchange(ranks[static_cast<std::size_t>(v.id)], rank++) < 0;
    };
    if (static_cast<std::size_t>(hub.id) >= vertices || order.size() != vertices - 1 ||
        !std::ranges::all_of(order, takes_a_rank)) {
        throw std::invalid_argument(
            "the order of a doubled fan holds every vertex but the hub, and each once");
    }
    return ranks;
}

}  // namespace

DoubledFan doubled_fan(const Triangulation& sphere, Vertex hub, std::span<const Vertex> order) {
    const hub_form::Ranks ranks = ranks_of(sphere, hub, order);
    FlipTrail trail(sphere);
    hub_form::gather(trail, hub_form::leaving(trail.table(), hub));
    Halfedge step = hub_form::tree_edge_from(trail.table(), order.front(), hub);
    hub_form::spread(trail, step);
    step = hub_form::sort_pages(trail, ranks, step);

    std::vector<Halfedge> path;
    path.reserve(order.size() - 1);
    while (path.size() < order.size() - 1) {
        path.push_back(step);
        step = hub_form::counter_clockwise(trail.table(), twin(step));
    }
    Triangulation surface = trail.surface();
    return {std::move(surface), std::move(trail).take_flips(), std::move(path)};
}

}  // namespace tightflip::kernel
