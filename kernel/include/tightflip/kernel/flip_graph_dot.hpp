/// \file
/// A picture of a small flip graph: Graphviz DOT.
#pragma once

#include <tightflip/kernel/class_graph.hpp>
#include <tightflip/kernel/flip_graph_distances.hpp>

#include <iosfwd>

namespace tightflip::kernel {

/// Writes classes as nodes, labelled with their number and the degrees of their vertices, and flips
/// as edges, with the number of arcs from either end where one of them is more than one.
/// Peripheral classes are filled where eccentricities are given.
void write_dot(std::ostream& out, const ClassGraph& classes,
               const Eccentricities* eccentricities = nullptr);

}  // namespace tightflip::kernel
