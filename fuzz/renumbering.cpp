#include "renumbering.hpp"

#include <tightflip/kernel/build.hpp>

#include <numeric>
#include <vector>

namespace tightflip::fuzz {
namespace {

using kernel::Halfedge;
using kernel::HalfedgeRecord;
using kernel::Index;
using kernel::Triangulation;
using kernel::Vertex;

std::vector<Index> random_order(Index count, kernel::RandomStream& random) {
    std::vector<Index> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), Index{0});
    random.shuffle(std::span(order));
    return order;
}

}  // namespace

Triangulation with_other_halfedges(const Triangulation& surface, kernel::RandomStream& random) {
    std::vector<Halfedge> image;
    for (const Index edge : random_order(surface.edge_count(), random)) {
        const Halfedge first{2 * edge + static_cast<Index>(random.below(2))};
        image.push_back(first);
        image.push_back(twin(first));
    }
    std::vector<HalfedgeRecord> records(image.size());
    for (std::size_t h = 0; h < image.size(); ++h) {
        const HalfedgeRecord& old = surface.table()[h];
        at(kernel::MutableHalfedgeTable(records), image[h]) = {
            image[static_cast<std::size_t>(old.next.id)], old.origin};
    }
    return build(std::move(records), surface.vertex_count()).value();
}

Triangulation with_other_labels(const Triangulation& surface, kernel::RandomStream& random) {
    const std::vector<Index> label = random_order(surface.vertex_count(), random);
    std::vector<HalfedgeRecord> records(surface.table().begin(), surface.table().end());
    for (HalfedgeRecord& record : records)
        record.origin = Vertex{label[static_cast<std::size_t>(record.origin.id)]};
    return build(std::move(records), surface.vertex_count()).value();
}

Triangulation mirrored(const Triangulation& surface) {
    std::vector<HalfedgeRecord> records(surface.table().size());
    for (Halfedge h{0}; h.id < surface.halfedge_count(); ++h.id) {
        records[static_cast<std::size_t>(h.id)] = {surface.previous(h), surface.target(h)};
    }
    return build(std::move(records), surface.vertex_count()).value();
}

}  // namespace tightflip::fuzz
