#include "targets.hpp"

#include <array>

namespace tightflip::fuzz {

std::span<const Target> targets() {
    static const std::array table {
        canonical_target, certificate_target, checkpoint_target,
#if TIGHTFLIP_OTHER_KERNELS
            conformance_target,
#endif
            criterion_text_target, flip_geometry_target, flip_graph_target, flip_log_target,
            flip_path_target, flip_script_target, gluing_target, halfedge_table_target,
            mesh_file_target, optimise_target, plantri_target, point_file_target, script_log_target,
            surface_text_target,
    };
    return table;
}

}  // namespace tightflip::fuzz
