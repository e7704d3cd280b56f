/// \file
/// All fuzz targets.
#pragma once

#include "target.hpp"

namespace tightflip::fuzz {

extern const Target canonical_target;
extern const Target certificate_target;
extern const Target checkpoint_target;
extern const Target conformance_target;
extern const Target criterion_text_target;
extern const Target flip_geometry_target;
extern const Target flip_graph_target;
extern const Target flip_log_target;
extern const Target flip_path_target;
extern const Target flip_script_target;
extern const Target gluing_target;
extern const Target halfedge_table_target;
extern const Target mesh_file_target;
extern const Target optimise_target;
extern const Target plantri_target;
extern const Target point_file_target;
extern const Target script_log_target;
extern const Target surface_text_target;

/// The table, in the order of names.
[[nodiscard]] std::span<const Target> targets();

}  // namespace tightflip::fuzz
