/// \file
/// How test output shows the kernel's values.
#pragma once

#include <tightflip/kernel/gluing.hpp>
#include <tightflip/kernel/violation.hpp>

#include <ostream>

namespace tightflip::kernel {

inline void PrintTo(ViolationCode code, std::ostream* out) {
    *out << name(code);
}

/// Each corner with what its side is glued to: enough to write the gluing down again.
inline void PrintTo(const Gluing& gluing, std::ostream* out) {
    *out << gluing.vertex_count << " vertices";
    for (const GluedFace& face : gluing.faces) {
        *out << " [";
        for (std::size_t i = 0; i < 3; ++i) {
            *out << ' ' << face.corners[i] << ':';
            if (!face.sides[i].is_glued()) {
                *out << '-';
            } else {
                *out << face.sides[i].side() << (face.sides[i].is_reversed() ? "r" : "");
            }
        }
        *out << " ]";
    }
}

}  // namespace tightflip::kernel
