/// \file
/// The surfaces and edge lists that every kernel is measured on. All are seeded, made once a
/// process and kept.
#pragma once

#include <tightflip/kernel/triangulation.hpp>

#include <array>
#include <vector>

namespace tightflip::kernel::bench {

using FaceList = std::vector<std::array<Index, 3>>;

/// The sizes measured, in vertices: one that fits a core's own cache and one that fits none.
inline constexpr std::array<Index, 2> sizes{10'000, 1'000'000};

/// Flips asked for in one run.
inline constexpr std::size_t run_length = 1'000'000;

/// A sphere after long random flips, with parallel edges.
const Triangulation& multigraph_sphere(Index vertices);
/// A sphere of about this size after long random flips that kept its graph simple: one that every
/// kernel can hold. It comes from a subdivided sphere, so that no vertex has a large degree, which
/// would slow those that walk about vertices.
const Triangulation& simple_sphere(Index vertices);

/// Edges drawn uniformly at random; some are refused at their turn.
const std::vector<Edge>& random_edges(const Triangulation& surface);
/// Random edges without those that the EDF refuses at their turn, when flipped from
/// `multigraph_sphere`: the list for kernels that check nothing.
const std::vector<Edge>& flippable_edges(Index vertices);

/// The faces of a surface as sorted corner triples, each from its smallest corner on.
FaceList sorted_faces(FaceList faces);

}  // namespace tightflip::kernel::bench
