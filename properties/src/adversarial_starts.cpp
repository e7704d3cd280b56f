#include "adversarial_starts.hpp"

#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/gather.hpp>
#include <tightflip/kernel/random.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tightflip::properties::adversarial {
namespace {

using kernel::Edge;
using kernel::GluedFace;
using kernel::Halfedge;
using kernel::HalfedgeRecord;
using kernel::RandomStream;
using kernel::side_of;
using kernel::SideGluing;
using kernel::Vertex;

void require(bool holds, const char* kind, const std::string& range) {
    if (!holds) throw std::invalid_argument(std::string(kind) + " needs " + range);
}

/// A halfedge table that grows.
class OpenedEdges {
public:
    OpenedEdges(Index genus, Index vertices, std::uint64_t seed, const char* kind) {
        const std::int64_t faces = 2 * std::int64_t{vertices} + 4 * std::int64_t{genus} - 4;
        require(genus >= 0 && vertices >= 3 && faces <= kernel::max_faces, kind,
                "genus 0 or more, and 3 vertices or more within the tables");
        const Triangulation smallest = genus == 0
                                           ? kernel::families::book(3)
                                           : kernel::families::surface_of_genus(genus, 3, seed);
        records_.assign(smallest.table().begin(), smallest.table().end());
        records_.reserve(3 * static_cast<std::size_t>(faces));
        count_ = smallest.vertex_count();
    }

    [[nodiscard]] Index vertex_count() const { return count_; }
    [[nodiscard]] Index halfedge_count() const { return static_cast<Index>(records_.size()); }

    /// Opens the edge of `side` into a digon and puts a vertex into it. Returns the halfedge from
    /// the new vertex to the end of `side`.
    Halfedge open(Halfedge side) {
        const Halfedge inner = kernel::twin(side);
        const Vertex start = record(side).origin;
        const Vertex end = record(inner).origin;
        const Vertex middle{count_++};
        const Halfedge parallel{halfedge_count()};
        const Halfedge outer{parallel.id + 1};  // takes the place of `inner` in its face
        const Halfedge start_to_middle{parallel.id + 2};
        const Halfedge middle_to_start{parallel.id + 3};
        const Halfedge middle_to_end{parallel.id + 4};
        const Halfedge end_to_middle{parallel.id + 5};
        const Halfedge after = record(inner).next;
        const Halfedge before = record(after).next;
        records_.resize(records_.size() + 6);
        record(before).next = outer;
        record(outer) = {after, end};
        record(inner).next = start_to_middle;
        record(start_to_middle) = {middle_to_end, start};
        record(middle_to_end) = {inner, middle};
        record(parallel) = {end_to_middle, start};
        record(end_to_middle) = {middle_to_start, end};
        record(middle_to_start) = {parallel, middle};
        return middle_to_end;
    }

    [[nodiscard]] Triangulation build() && {
        return kernel::build(std::move(records_), count_).value();
    }

private:
    [[nodiscard]] HalfedgeRecord& record(Halfedge h) {
        return records_[static_cast<std::size_t>(h.id)];
    }

    std::vector<HalfedgeRecord> records_;
    Index count_ = 0;
};

}  // namespace

Triangulation fan(Index vertices) {
    require(vertices >= 3 && vertices <= kernel::max_faces / 2, "a fan",
            "at least 3 vertices (and not beyond the tables)");
    const Index blades = vertices - 2;
    kernel::Gluing gluing{.vertex_count = vertices,
                          .faces = std::vector<GluedFace>(2 * static_cast<std::size_t>(blades))};
    const auto glue = [&](Index s, Index t) {
        for (const auto& [from, to] : {std::pair{s, t}, std::pair{t, s}}) {
            gluing.faces[static_cast<std::size_t>(from / 3)]
                .sides[static_cast<std::size_t>(from % 3)] = SideGluing::coherent(to);
        }
    };
    const auto front = [](Index blade) { return 2 * blade; };
    const auto back = [](Index blade) { return 2 * blade + 1; };
    for (Index blade = 0; blade < blades; ++blade) {
        const Index i = blade + 1;
        gluing.faces[static_cast<std::size_t>(front(blade))].corners = {0, i, i + 1};
        gluing.faces[static_cast<std::size_t>(back(blade))].corners = {0, i + 1, i};
        glue(side_of(front(blade), 1), side_of(back(blade), 1));
        if (blade == 0) continue;
        glue(side_of(front(blade), 0), side_of(front(blade - 1), 2));
        glue(side_of(back(blade), 2), side_of(back(blade - 1), 0));
    }
    glue(side_of(front(0), 0), side_of(back(0), 2));
    glue(side_of(front(blades - 1), 2), side_of(back(blades - 1), 0));
    return kernel::build(gluing).value();
}

Triangulation degree_two_chain(Index genus, Index vertices, std::uint64_t seed) {
    OpenedEdges surface(genus, vertices, seed, "a chain of degree 2");
    for (Halfedge side{0}; surface.vertex_count() < vertices;)
        side = kernel::twin(surface.open(side));  // towards the newest vertex, from the one before
    return std::move(surface).build();
}

Triangulation digons(Index genus, Index vertices, std::uint64_t seed) {
    OpenedEdges surface(genus, vertices, seed, "a surface of digons");
    RandomStream random(seed);
    while (surface.vertex_count() < vertices) {
        const auto sides = static_cast<std::uint32_t>(surface.halfedge_count());
        surface.open({static_cast<Index>(random.below(sides))});
    }
    return std::move(surface).build();
}

Triangulation hub(Index genus, Index vertices, std::uint64_t seed) {
    const auto log =
        gather_at(kernel::families::surface_of_genus(genus, vertices, seed), Vertex{0});
    return replay(log).surface;
}

Triangulation simple(Index genus, Index vertices, std::uint64_t seed) {
    require(genus <= 0 || vertices >= 6 * std::int64_t{genus} + 3, "a simple surface of this genus",
            "at least 6 g + 3 vertices");
    Triangulation surface = kernel::families::surface_of_genus(genus, vertices, seed);
    RandomStream random(kernel::mix(seed));
    const auto edges = static_cast<std::uint32_t>(surface.edge_count());
    for (std::int64_t k = 0; k < 20 * std::int64_t{edges}; ++k) {
        const Edge e{static_cast<Index>(random.below(edges))};
        const Halfedge h = halfedge_of(e);
        const Vertex new_end = surface.opposite(kernel::twin(h));
        const auto neighbours = surface.neighbours(surface.previous(h));
        if (std::ranges::find(neighbours, new_end) == neighbours.end()) {
            static_cast<void>(surface.flip(e));
        }
    }
    return surface;
}

}  // namespace tightflip::properties::adversarial
