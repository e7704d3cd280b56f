// Tests of a mesh of one's own with the generators, claims and shrinking of tightflip::properties.
#include "my_mesh.hpp"

#include <tightflip/properties/geometry_claims.hpp>
#include <tightflip/properties/googletest.hpp>
#include <tightflip/properties/rapidcheck.hpp>

#include <algorithm>
#include <optional>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

using namespace tightflip::properties;
using tightflip::kernel::Halfedge;
using tightflip::kernel::halfedge_of;

/// A start as MyMesh, and its half-edge at each edge of the start.
struct Twins {
    MyMesh mesh;
    std::vector<int> side;

    explicit Twins(const Triangulation& start) : mesh(triangles(start)) {
        side.resize(static_cast<std::size_t>(start.edge_count()));
        int number = 0;
        for (const Halfedge face : start.faces()) {
            for (const Halfedge h : start.face_sides(face))
                side[static_cast<std::size_t>(edge_of(h).id)] = number++;
        }
    }
    static std::vector<std::array<int, 3>> triangles(const Triangulation& start) {
        std::vector<std::array<int, 3>> corners;
        for (const Halfedge face : start.faces()) {
            corners.push_back(
                {start.origin(face).id, start.target(face).id, start.opposite(face).id});
        }
        return corners;
    }
    int at(Edge e) const { return side[static_cast<std::size_t>(e.id)]; }
    /// The ends of an edge, the smaller first.
    std::pair<int, int> ends(Edge e) const {
        const MyMesh::HalfEdge& h = mesh.at(at(e));
        return std::minmax({h.origin, mesh.at(h.twin).origin});
    }
};

/// What a claim of one's own may return: anything that `describe` can say.
struct Difference {
    std::string words;
};
std::string describe(const Difference& difference) {
    return difference.words;
}

/// A claim: flipped alike, where MyMesh allows the flip, both have the same edges.
std::optional<Difference> my_mesh_agrees(const Triangulation& start, std::span<const Edge> script) {
    Triangulation surface = start;
    Twins twins(start);
    for (const Edge flipped : script) {
        if (!twins.mesh.can_flip(twins.at(flipped))) continue;
        twins.mesh.flip(twins.at(flipped));
        if (!surface.flip(flipped)) {
            return Difference{"edge " + std::to_string(flipped.id) + " should not be flipped"};
        }
        for (Edge e{0}; e.id < surface.edge_count(); ++e.id) {
            const Halfedge h = halfedge_of(e);
            if (twins.ends(e) != std::minmax({surface.origin(h).id, surface.target(h).id})) {
                return Difference{"edge " + std::to_string(e.id) + " has other ends"};
            }
        }
    }
    return std::nullopt;
}

// GoogleTest: a failure prints its shortest script in words and leaves a log.
TEST(MyMesh, AgreesOnAScript) {
    const Triangulation start =
        make_nearest(*find_start_kind("simple"), {.vertices = 30, .genus = 1, .seed = 1});
    tightflip::kernel::RandomStream random(1);
    EXPECT_HOLDS(my_mesh_agrees, start, random_script(start, 300, random)) << "on a torus";
}

// RapidCheck: a failure shrinks its start too.
RC_GTEST_PROP(MyMesh, AgreesOnSimpleSurfaces, ()) {
    require_claim("my_mesh", *any_flip_case({.graph = GraphKind::simple}), my_mesh_agrees);
}

// Or in your own words, from a surface of the size you want.
RC_GTEST_PROP(MyMesh, StaysValid, ()) {
    const Triangulation start =
        *any_surface({.graph = GraphKind::simple, .exact_genus = 2, .exact_vertices = 20});
    Twins twins(start);
    for (const Edge e : *any_script(start, 50)) {
        if (twins.mesh.can_flip(twins.at(e))) twins.mesh.flip(twins.at(e));
    }
    RC_ASSERT(twins.mesh.is_valid());
}

// Points of every kind, degenerate ones among them.
RC_GTEST_PROP(Geometry, ClaimsHold, (const SurfaceCase& surface_case)) {
    require_claim("geometry", surface_case, geometry_claims_hold);
}
