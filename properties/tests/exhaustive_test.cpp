// Every triangulation with few vertices, every flip of each.

#include "labelled_surfaces.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/properties/invariants.hpp>
#include <tightflip/properties/reference_model.hpp>

#include <algorithm>
#include <ostream>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

namespace families = kernel::families;
using kernel::Halfedge;

/// The surface as seen from one halfedge: halfedges are numbered as a breadth-first walk over next
/// and twin meets them. Two rooted surfaces are the same, labels ignored, iff these are.
struct RootedCode {
    std::vector<Index> neighbours;  ///< next and twin of each halfedge in the order of the walk
    std::vector<Index> labels;      ///< its origin

    friend auto operator<=>(const RootedCode&, const RootedCode&) = default;
};

RootedCode rooted_code(const Triangulation& surface, Halfedge root) {
    std::vector<Index> number(static_cast<std::size_t>(surface.halfedge_count()), -1);
    std::vector<Halfedge> order;
    const auto meet = [&](Halfedge h) {
        Index& n = number[static_cast<std::size_t>(h.id)];
        if (n < 0) {
            n = static_cast<Index>(order.size());
            order.push_back(h);
        }
        return n;
    };
    RootedCode code;
    meet(root);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const Halfedge h = order[k];
        code.neighbours.push_back(meet(surface.next(h)));
        code.neighbours.push_back(meet(twin(h)));
        code.labels.push_back(surface.origin(h).id);
    }
    return code;
}

struct Census {
    std::size_t labelled = 0;
    std::size_t rooted = 0;           ///< labels ignored
    std::size_t labelled_rooted = 0;  ///< over all labelled surfaces, roots told apart by labels
    std::size_t refused = 0;
    Index fewest_flippable = 0;
    Index most_flippable = 0;
};

/// Everything that flips reach from `start`; each flip of each surface is audited and compared with
/// the reference model.
Census explore(const Triangulation& start) {
    const Topology topology = audit(start).topology;
    LabelledSurfaces reached{start};
    std::vector<Triangulation> open{start};
    std::set<std::vector<Index>> rooted;
    Census census{.fewest_flippable = start.edge_count()};
    while (!open.empty()) {
        const Triangulation surface = std::move(open.back());
        open.pop_back();
        std::set<RootedCode> roots;
        for (Index h = 0; h < surface.halfedge_count(); ++h) {
            RootedCode code = rooted_code(surface, {h});
            rooted.insert(code.neighbours);
            roots.insert(std::move(code));
        }
        census.labelled_rooted += roots.size();
        const ReferenceModel model(surface);
        Index flippable = 0;
        for (Index e = 0; e < surface.edge_count(); ++e) {
            Triangulation flipped = surface;
            ReferenceModel flipped_model = model;
            const CheckedFlip step = checked_flip(flipped, {e});
            EXPECT_EQ(step.code, std::nullopt);
            EXPECT_EQ(first_violation(flipped, topology), std::nullopt);
            EXPECT_EQ(flipped_model.flip({e}), step.done);
            EXPECT_EQ(flipped_model.difference(flipped), std::nullopt);
            if (::testing::Test::HasFailure()) return census;
            census.refused += step.done ? 0 : 1;
            flippable += step.done ? 1 : 0;
            if (step.done && reached.insert(flipped).second) open.push_back(std::move(flipped));
        }
        census.fewest_flippable = std::min(census.fewest_flippable, flippable);
        census.most_flippable = std::max(census.most_flippable, flippable);
    }
    census.labelled = reached.size();
    census.rooted = rooted.size();
    return census;
}

std::uint64_t factorial(std::uint64_t n) {
    return n == 0 ? 1 : n * factorial(n - 1);
}

/// Rooted loopless triangulations of the sphere with k + 2 vertices (OEIS A000309).
std::uint64_t rooted_spheres(std::uint64_t k) {
    return (1U << k) * factorial(3 * k) / (factorial(k + 1) * factorial(2 * k + 1));
}

class ExhaustiveSphere : public ::testing::TestWithParam<Index> {};

TEST_P(ExhaustiveSphere, FlipsReachAllLabelledTriangulationsAndEachFlipIsSound) {
    const auto vertices = static_cast<std::uint64_t>(GetParam());
    const Census census = explore(families::stacked(GetParam(), 0));
    EXPECT_EQ(census.rooted, rooted_spheres(vertices - 2));
    // Labels leave a sphere no automorphism, so each labelling has one root in 6 (V - 2).
    EXPECT_EQ(census.labelled,
              rooted_spheres(vertices - 2) * factorial(vertices) / (6 * (vertices - 2)));
    EXPECT_GT(census.refused, 0U);
    // Observed for V up to 8, not proved.
    EXPECT_EQ(census.fewest_flippable, GetParam() - 2);
    EXPECT_EQ(census.most_flippable, 3 * (GetParam() - 2));
}

INSTANTIATE_TEST_SUITE_P(Vertices, ExhaustiveSphere, ::testing::Values(4, 5, 6),
                         ::testing::PrintToStringParamName());

struct TorusCount {
    Index vertices;
    std::size_t rooted;
};
void PrintTo(const TorusCount& count, std::ostream* out) {
    *out << count.vertices << " vertices";
}
class ExhaustiveTorus : public ::testing::TestWithParam<TorusCount> {};

// The rooted counts come from gluing 2 V triangles in every way. Labels do not kill every
// automorphism of a torus (a half turn fixes every vertex of the one in which each two of 4
// vertices are joined twice), so the labelled ones have no such formula as on the sphere; but a
// root kills all, so each rooted surface has V! labellings.
TEST_P(ExhaustiveTorus, FlipsReachEveryRootedTriangulationAndEachFlipIsSound) {
    const auto& [vertices, rooted] = GetParam();
    const Census census = explore(families::surface_of_genus(1, vertices, 0));
    EXPECT_EQ(census.rooted, rooted);
    EXPECT_EQ(census.labelled_rooted, rooted * factorial(static_cast<std::uint64_t>(vertices)));
}

INSTANTIATE_TEST_SUITE_P(Vertices, ExhaustiveTorus,
                         ::testing::Values(TorusCount{4, 51}, TorusCount{5, 1413}),
                         [](const auto& row) { return std::to_string(row.param.vertices); });

TEST(ExhaustiveThreeVertices, NoFlipIsDefinedOnAnyGenus) {
    for (Index genus = 0; genus <= 3; ++genus) {
        const Census census =
            explore(genus == 0 ? families::book(3) : families::surface_of_genus(genus, 3, 0));
        EXPECT_EQ(census.labelled, 1U) << "genus " << genus;
        EXPECT_EQ(census.most_flippable, 0) << "genus " << genus;
    }
}

}  // namespace
}  // namespace tightflip::properties
