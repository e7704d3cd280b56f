/// \file
/// Named families of surfaces, as starts for tests, campaigns and experiments.
///
/// Vertex labels are 0 .. V - 1. Seeded families are the same on every machine and compiler.
/// A size outside a family's range throws std::invalid_argument, which names the range.
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <cstdint>

namespace tightflip::kernel::families {

/// V = 4, genus 0, simple.
[[nodiscard]] Triangulation tetrahedron();

/// Two poles 0 and 1 joined by V - 2 parallel edges, and in each digon between them one vertex of
/// degree 2. V >= 3; book(3) is the sphere of two faces, on which no flip is defined. Genus 0.
[[nodiscard]] Triangulation book(Index vertices);

/// Two poles over a rim of V - 2 vertices (a bipyramid). V >= 5, genus 0, simple.
[[nodiscard]] Triangulation double_wheel(Index vertices);

/// A tetrahedron into whose faces, each chosen at random, V - 4 vertices are put one by one; labels
/// in random order. V >= 4, genus 0, simple.
[[nodiscard]] Triangulation stacked(Index vertices, std::uint64_t seed);

/// Two k-gons, each cut into triangles from one corner, joined by a band of 2k triangles: a
/// zig-zag for the antiprism, quadrilaterals whose diagonals rise and fall in turn for the prism.
/// V = 2k, k >= 3, genus 0, simple.
[[nodiscard]] Triangulation prism(Index k);
[[nodiscard]] Triangulation antiprism(Index k);

/// The octahedron or icosahedron with each face cut into four, `level` times. V = 4 * 4^level + 2
/// and 10 * 4^level + 2, genus 0, simple.
[[nodiscard]] Triangulation octasphere(int level);
[[nodiscard]] Triangulation icosphere(int level);

/// An m by n grid of squares with one diagonal each, closed in both directions. V = m n,
/// m, n >= 3, genus 1, simple.
[[nodiscard]] Triangulation torus_grid(Index m, Index n);

/// A surface of given genus: a connected sum of tori with vertices put into random faces, labels in
/// random order. For V >= 6 g + 3 it is simple; down to V = 3 it is made from tori of three
/// vertices, with parallel edges. V >= 3 (V >= 4 for genus 0).
[[nodiscard]] Triangulation surface_of_genus(Index genus, Index vertices, std::uint64_t seed);

/// `surface_of_genus` after 20 flips an edge at random: a multigraph far from its start. (How close
/// to uniform this is, is not known.)
[[nodiscard]] Triangulation random(Index vertices, Index genus, std::uint64_t seed);

}  // namespace tightflip::kernel::families
