/// \file
/// The makers of criteria by the way they are computed; each returns null for the others' kinds.
#pragma once

#include <tightflip/geometry/criterion.hpp>

namespace tightflip::geometry {

std::unique_ptr<Criterion> make_face_criterion(CriterionKind kind, const SurfaceView& surface,
                                               Vertex marked);
std::unique_ptr<Criterion> make_edge_criterion(CriterionKind kind, const SurfaceView& surface,
                                               Vertex marked);
std::unique_ptr<Criterion> make_volume_criterion(CriterionKind kind, const SurfaceView& surface,
                                                 Vertex marked);
std::unique_ptr<Criterion> make_tight_criterion(CriterionKind kind, const SurfaceView& surface,
                                                Vertex marked);

}  // namespace tightflip::geometry
