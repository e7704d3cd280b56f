/// \file
/// Copies of a surface under other numbers, other labels, or in a mirror.
#pragma once

#include "surfaces.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/random.hpp>

#include <numeric>
#include <span>
#include <vector>

namespace tightflip::kernel::testing {

[[nodiscard]] inline std::vector<HalfedgeRecord> records_of(const Triangulation& surface) {
    const auto table = surface.table();
    return {table.begin(), table.end()};
}

/// The same surface under other numbers: edges in another order, halves exchanged at random.
[[nodiscard]] inline Triangulation renumbered(const Triangulation& surface, RandomStream& random) {
    std::vector<Index> place(static_cast<std::size_t>(surface.edge_count()));
    std::iota(place.begin(), place.end(), 0);
    random.shuffle(std::span(place));
    std::vector<Index> image;
    for (const Index e : place) {
        const auto half = static_cast<Index>(random.below(2));
        image.push_back(2 * e + half);
        image.push_back(2 * e + 1 - half);
    }
    const auto records = records_of(surface);
    std::vector<HalfedgeRecord> moved(records.size());
    for (std::size_t h = 0; h < records.size(); ++h) {
        nth(moved, image[h]) = {{nth(image, records[h].next.id)}, records[h].origin};
    }
    return build(std::move(moved), surface.vertex_count()).value();
}

/// The same edges and labels with every face turned over.
[[nodiscard]] inline Triangulation mirrored(const Triangulation& surface) {
    const auto records = records_of(surface);
    std::vector<HalfedgeRecord> turned(records.size());
    for (Index h = 0; h < surface.halfedge_count(); ++h) {
        const Index n = nth(records, h).next.id;
        // h now runs from its old end to its old origin, and its old predecessor follows it.
        nth(turned, n).next = {h};
        nth(turned, h).origin = nth(records, n).origin;
    }
    return build(std::move(turned), surface.vertex_count()).value();
}

[[nodiscard]] inline Triangulation with_labels(const Triangulation& surface,
                                               const std::vector<Index>& label) {
    auto records = records_of(surface);
    for (HalfedgeRecord& r : records)
        r.origin = {nth(label, r.origin.id)};
    return build(std::move(records), surface.vertex_count()).value();
}

/// The same surface with its labels exchanged at random.
[[nodiscard]] inline Triangulation relabelled(const Triangulation& surface, RandomStream& random) {
    std::vector<Index> label(static_cast<std::size_t>(surface.vertex_count()));
    std::iota(label.begin(), label.end(), 0);
    random.shuffle(std::span(label));
    return with_labels(surface, label);
}

}  // namespace tightflip::kernel::testing
