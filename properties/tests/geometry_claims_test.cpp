#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/geometry_claims.hpp>
#include <tightflip/properties/googletest.hpp>
#include <tightflip/properties/rapidcheck.hpp>

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tightflip::properties {
namespace {

RC_GTEST_PROP(GeometryClaims, HoldInGeneralPosition, ()) {
    require_claim("geometry_claims_general",
                  *any_surface_case({.only_points = find_point_kind("general")}),
                  geometry_claims_hold);
}

RC_GTEST_PROP(GeometryClaims, HoldOnPointsOfEveryKind, (const SurfaceCase& surface_case)) {
    require_claim("geometry_claims", surface_case, geometry_claims_hold);
}

RC_GTEST_PROP(GeometryClaims, HoldAtTheEndsOnPointsOfEveryKind, (const SurfaceCase& surface_case)) {
    require_claim("geometry_claims_at_ends", surface_case, geometry_claims_hold_at_ends);
}

TEST(GeometryClaims, HoldOnEveryFlipOfSmallSurfaces) {
    // Everything coplanar, collinear, or at one point too.
    for (const Triangulation& start :
         {kernel::families::tetrahedron(), kernel::families::book(5),
          kernel::families::double_wheel(6), kernel::families::surface_of_genus(1, 4, 1)}) {
        for (int flatness = 0; flatness <= 3; ++flatness) {
            kernel::RandomStream random(9);
            std::vector<geometry::Point> points(static_cast<std::size_t>(start.vertex_count()));
            for (geometry::Point& point : points) {
                for (int axis = 0; axis < 3; ++axis)
                    point[axis] = axis < flatness ? random.below(4) : 1;
            }
            for (Index e = 0; e < start.edge_count(); ++e) {
                const std::vector<Edge> script(4, Edge{e});
                EXPECT_HOLDS(geometry_claims_hold, geometry::Surface(start, points), script);
                EXPECT_HOLDS(geometry_claims_hold_at_ends, geometry::Surface(start, points),
                             script);
            }
        }
    }
}

TEST(GeometryClaims, HaveNamesAndCodes) {
    std::set<std::string_view> names;
    for (int code = 1001; code <= 1011; ++code)
        names.insert(name(static_cast<GeometryClaim>(code)));
    EXPECT_EQ(names.size(), 11U);
    EXPECT_EQ(describe({GeometryClaim::local_change, 3, "tight, edge 5"}),
              "after 3 flips: 1007 local_change: tight, edge 5");
}

}  // namespace
}  // namespace tightflip::properties
