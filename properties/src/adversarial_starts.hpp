/// \file
/// Starts that are hard on flips and their tables: many parallel edges, vertices of degree 2, hubs.
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <cstdint>

namespace tightflip::properties::adversarial {

using kernel::Index;
using kernel::Triangulation;

/// Two fans of V - 2 triangles about vertex 0, glued along the V-gon: every face contains vertex 0,
/// V - 3 pairs of parallel edges end there, and vertices 1 and V - 1 have degree 2. V >= 3, genus
/// 0.
[[nodiscard]] Triangulation fan(Index vertices);

/// Digons in digons: an edge is opened into a digon with a vertex of degree 2 in it, an edge of
/// that vertex likewise, and so on. The last vertex has degree 2; without it the one before has,
/// and so on down the chain. No degree in it exceeds 6. V >= 3, any genus; seeds make a difference
/// to genus 1 and more.
[[nodiscard]] Triangulation degree_two_chain(Index genus, Index vertices, std::uint64_t seed);

/// Edges chosen at random are opened into digons with a vertex of degree 2 in each. V >= 3, any
/// genus; a multigraph.
[[nodiscard]] Triangulation digons(Index genus, Index vertices, std::uint64_t seed);

/// Every face contains vertex 0, whose degree is the number of faces: the most there can be.
/// V >= 3 (4 on the sphere), any genus.
[[nodiscard]] Triangulation hub(Index genus, Index vertices, std::uint64_t seed);

/// A simple surface of the genus after 20 attempts an edge to flip a random edge, done where no
/// edge becomes parallel to another. V >= 6 g + 3 (4 on the sphere).
[[nodiscard]] Triangulation simple(Index genus, Index vertices, std::uint64_t seed);

}  // namespace tightflip::properties::adversarial
