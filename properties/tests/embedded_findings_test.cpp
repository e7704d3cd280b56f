// The bundled instances of the paper's remark on embedded triangulations: docs/findings/embedded-*.

#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/geometry/surface_file.hpp>
#include <tightflip/kernel/certificate.hpp>
#include <tightflip/kernel/file_io.hpp>
#include <tightflip/kernel/surface_equality.hpp>
#include <tightflip/properties/embedded_triangulations.hpp>

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

using geometry::Surface;

struct Instance {
    std::string isolated;  ///< from which no conventional flip leads away
    std::string other;     ///< in the large component, on the same points
    std::string path;      ///< by EDFs from the one to the other
    std::vector<std::size_t> component_sizes;
    bool convex = false;
    std::ptrdiff_t self_intersecting = 0;  ///< surfaces on the path
};

std::ostream& operator<<(std::ostream& out, const Instance& instance) {
    return out << instance.isolated;
}

std::filesystem::path finding(const std::string& name) {
    return std::filesystem::path(TIGHTFLIP_FINDINGS) / name;
}

Surface surface_in(const std::string& name) {
    return geometry::read_surface_file(finding(name));
}

/// The place of a surface's component in the list; their number where it is in none.
std::size_t component_of(const Surface& surface, const EmbeddedTriangulations& embedded) {
    const auto has = [&](const std::vector<FaceSet>& component) {
        return std::ranges::any_of(component, [&](FaceSet sphere) {
            return same_labelled_surface(embedded.surface(sphere).triangulation(),
                                         surface.triangulation());
        });
    };
    return static_cast<std::size_t>(std::ranges::find_if(embedded.components(), has) -
                                    embedded.components().begin());
}

class EmbeddedFinding : public testing::TestWithParam<Instance> {
protected:
    Surface isolated_ = surface_in(GetParam().isolated);
    Surface other_ = surface_in(GetParam().other);
    kernel::FlipLog path_ =
        kernel::parse_flip_log(kernel::read_file(finding(GetParam().path)), GetParam().path);
};

TEST_P(EmbeddedFinding, EndsAreEmbeddedOnTheSamePoints) {
    EXPECT_TRUE(std::ranges::equal(isolated_.points(), other_.points()));
    for (const Surface* surface : {&isolated_, &other_}) {
        EXPECT_TRUE(geometry::is_embedded(surface->view()));
        EXPECT_TRUE(audit(surface->triangulation()).is_simple().value());
    }
    EXPECT_EQ(bool(geometry::is_convex_data(isolated_.points())), GetParam().convex);
    EXPECT_EQ(bool(geometry::is_convex_surface(other_.view())), GetParam().convex);
}

TEST_P(EmbeddedFinding, EndsLieInDifferentComponents) {
    const EmbeddedTriangulations embedded({isolated_.points().begin(), isolated_.points().end()});
    std::vector<std::size_t> sizes;
    for (const auto& component : embedded.components())
        sizes.push_back(component.size());
    EXPECT_EQ(sizes, GetParam().component_sizes);
    EXPECT_EQ(sizes.at(component_of(isolated_, embedded)), 1U);
    EXPECT_EQ(component_of(other_, embedded), sizes.size() - 1);
}

// Told without the list of all triangulations: by the EDF and the judges of surfaces.
TEST_P(EmbeddedFinding, NoFlipLeadsFromTheIsolatedOneToAnEmbeddedOne) {
    int parallel = 0;
    int self_intersecting = 0;
    for (kernel::Index e = 0; e < isolated_.triangulation().edge_count(); ++e) {
        EXPECT_FALSE(geometry::flip_keeps_embedded(isolated_.view(), {e}));
        kernel::Triangulation flipped = isolated_.triangulation();
        ASSERT_TRUE(flipped.flip({e}));
        if (!audit(flipped).is_simple().value()) {
            ++parallel;
        } else if (!geometry::is_embedded({flipped.table(), isolated_.points()})) {
            ++self_intersecting;
        }
    }
    EXPECT_EQ(parallel, 9);
    EXPECT_EQ(self_intersecting, 9);
}

TEST_P(EmbeddedFinding, ExtendedFlipsJoinThemThroughSelfIntersectingOnes) {
    EXPECT_TRUE(verify(isolated_.triangulation(), other_.triangulation(), path_));
    kernel::Triangulation surface = path_.start;
    std::vector<bool> embedded;
    for (const kernel::Edge e : path_.flips) {
        ASSERT_TRUE(surface.flip(e));
        embedded.push_back(geometry::is_embedded({surface.table(), isolated_.points()}));
    }
    // Once embedded, it stays so.
    EXPECT_TRUE(std::ranges::is_sorted(embedded));
    EXPECT_EQ(std::ranges::count(embedded, false), GetParam().self_intersecting);
}

INSTANTIATE_TEST_SUITE_P(, EmbeddedFinding,
                         testing::Values(Instance{.isolated = "embedded-convex-isolated.txt",
                                                  .other = "embedded-convex-hull.txt",
                                                  .path = "embedded-convex-path.log",
                                                  .component_sizes = {1, 1, 1, 2114},
                                                  .convex = true,
                                                  .self_intersecting = 3},
                                         Instance{.isolated = "embedded-inner-isolated.txt",
                                                  .other = "embedded-inner-joined.txt",
                                                  .path = "embedded-inner-path.log",
                                                  .component_sizes = {1, 4041},
                                                  .convex = false,
                                                  .self_intersecting = 2}));

}  // namespace
}  // namespace tightflip::properties
