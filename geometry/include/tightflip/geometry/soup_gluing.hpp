/// \file
/// Which sides of a soup meet: as its file says, or else as the corner labels allow.
#pragma once

#include <tightflip/geometry/triangle_soup.hpp>
#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/build.hpp>

namespace tightflip::geometry {

/// The gluing that the soup gives, its sides coherent or reversed as their labels say; where it
/// gives none, `kernel::glue_faces`.
[[nodiscard]] kernel::FaceListReading glue(const TriangleSoup& soup);

/// The audit of what was read, together with what a face list leaves undetermined.
[[nodiscard]] kernel::AuditReport audit(const kernel::FaceListReading& reading);

}  // namespace tightflip::geometry
