#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/geometry_claims.hpp>
#include <tightflip/properties/rapidcheck.hpp>
#include <tightflip/properties/surface_case.hpp>

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tightflip::properties {

static void showValue(const SurfaceCase& surface_case, std::ostream& out) {
    out << describe(surface_case);
}

namespace {

/// Shrinks towards short scripts on small starts, and to points in general position last.
rc::Gen<SurfaceCase> any_surface_case(std::uint32_t most_grid) {
    const FlipCaseLimits small{.genus = 2, .spare_vertices = 12, .flips = 16};
    return rc::gen::map(
        rc::gen::tuple(any_flip_case(small), rc::gen::inRange<std::uint32_t>(0, most_grid + 1),
                       rc::gen::inRange<std::uint64_t>(0, 1 << 16)),
        [](auto drawn) {
            auto& [flips, grid, seed] = drawn;
            return SurfaceCase{std::move(flips), grid, seed};
        });
}

void require_claims(const SurfaceCase& surface_case) {
    const auto finding = geometry_claims_hold(surface_case.start(), surface_case.script());
    if (finding) RC_FAIL(describe(*finding));
}

RC_GTEST_PROP(GeometryClaims, HoldInGeneralPosition, ()) {
    require_claims(*any_surface_case(0));
}

RC_GTEST_PROP(GeometryClaims, HoldOnDegenerateData, ()) {
    require_claims(*any_surface_case(3));
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
                const auto finding = geometry_claims_hold({start, points}, script);
                EXPECT_FALSE(finding) << describe(*finding);
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
