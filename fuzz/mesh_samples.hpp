/// \file
/// Mesh files to begin with: well-formed ones of every format, and each kind of damage.
#pragma once

#include <string>
#include <vector>

namespace tightflip::fuzz {

struct MeshSample {
    std::string name;    ///< begins with the format's name
    std::string format;  ///< "obj", "off", "ply" or "stl"
    std::string bytes;
};

[[nodiscard]] std::vector<MeshSample> mesh_samples();

}  // namespace tightflip::fuzz
