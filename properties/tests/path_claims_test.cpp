#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/connect.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/surface_equality.hpp>
#include <tightflip/properties/path_claims.hpp>
#include <tightflip/properties/rapidcheck.hpp>

#include <array>
#include <numeric>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tightflip::properties {

namespace {

namespace families = kernel::families;

// ---- spheres by description ----

/// Shapes of any number of vertices from 4 up: multigraphs, simple graphs, and the extremes.
struct Shape {
    std::string_view name;
    Triangulation (*make)(Index vertices, std::uint64_t seed);
};
constexpr std::array shapes{
    Shape{"book", [](Index v, std::uint64_t) { return families::book(v); }},
    Shape{"double wheel",
          [](Index v, std::uint64_t) {
              return v == 4 ? families::tetrahedron() : families::double_wheel(v);
          }},
    Shape{"stacked", families::stacked},
    Shape{"random", [](Index v, std::uint64_t seed) { return families::random(v, 0, seed); }},
};

enum class Labels : std::uint8_t { kept, reversed, shuffled };

struct Recipe {
    std::size_t shape = 0;
    std::uint64_t seed = 0;
    Labels labels = Labels::kept;
    bool mirrored = false;
};

/// Two spheres of one size; `from` and `to` may well be the same but for labels and the mirror.
struct SpherePair {
    Index vertices = 4;
    Recipe from, to;
};

std::vector<Index> label_order(const Recipe& recipe, Index vertices) {
    std::vector<Index> labels(static_cast<std::size_t>(vertices));
    std::iota(labels.begin(), labels.end(), 0);
    if (recipe.labels == Labels::reversed) std::ranges::reverse(labels);
    if (recipe.labels == Labels::shuffled) {
        kernel::RandomStream(recipe.seed).shuffle(std::span(labels));
    }
    return labels;
}

Triangulation made(const Recipe& recipe, Index vertices) {
    const Triangulation surface = shapes.at(recipe.shape).make(vertices, recipe.seed);
    const std::vector<Index> labels = label_order(recipe, vertices);
    std::vector<kernel::HalfedgeRecord> records;
    for (Index h = 0; h < surface.halfedge_count(); ++h) {
        const kernel::Halfedge half{h};
        const kernel::Halfedge next = recipe.mirrored ? surface.previous(half) : surface.next(half);
        const kernel::Vertex origin = recipe.mirrored ? surface.target(half) : surface.origin(half);
        records.push_back({next, {labels[static_cast<std::size_t>(origin.id)]}});
    }
    return build(std::move(records), vertices).value();
}

void show(const Recipe& recipe, std::ostream& out) {
    constexpr std::array labels{"", ", labels reversed", ", labels shuffled"};
    out << shapes.at(recipe.shape).name << ", seed " << recipe.seed
        << labels.at(static_cast<std::size_t>(recipe.labels))
        << (recipe.mirrored ? ", mirrored" : "");
}

void showValue(const SpherePair& pair, std::ostream& out) {
    out << "V = " << pair.vertices << ": ";
    show(pair.from, out);
    out << " -> ";
    show(pair.to, out);
}

rc::Gen<Recipe> any_recipe() {
    const auto below = []<class T>(T bound) {  // whatever the size
        return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<T>(0, bound));
    };
    return rc::gen::build<Recipe>(
        rc::gen::set(&Recipe::shape, below(shapes.size())),
        rc::gen::set(&Recipe::seed, below(std::uint64_t{1} << 16)),
        rc::gen::set(&Recipe::labels,
                     rc::gen::element(Labels::kept, Labels::reversed, Labels::shuffled)),
        rc::gen::set(&Recipe::mirrored));
}

/// Shrinks towards four vertices, earlier shapes, seed 0 and kept labels.
rc::Gen<SpherePair> any_sphere_pair() {
    return rc::gen::build<SpherePair>(
        rc::gen::set(&SpherePair::vertices, rc::gen::scale(2.0, rc::gen::inRange<Index>(4, 201))),
        rc::gen::set(&SpherePair::from, any_recipe()), rc::gen::set(&SpherePair::to, any_recipe()));
}

// ---- the claims ----

/// What was found, in words; empty where the claim held.
std::string words(const std::optional<Finding>& finding) {
    return finding ? describe(*finding) : std::string{};
}

RC_GTEST_PROP(Theorem43Property, AnyTwoLabelledSpheresConnect, ()) {
    const SpherePair pair = *any_sphere_pair();
    const Triangulation from = made(pair.from, pair.vertices);
    const Triangulation to = made(pair.to, pair.vertices);
    RC_ASSERT(words(any_two_spheres_connect(from, to)) == "");
}

RC_GTEST_PROP(ShorteningProperty, KeepsTheEnds, (const FlipCase& flip_case)) {
    require_claim("shortening_keeps_the_ends", flip_case, shortening_keeps_the_ends);
}

RC_GTEST_PROP(ShorteningProperty, KeepsTheEndsOfConstructedPaths, ()) {
    const SpherePair pair = *any_sphere_pair();
    const kernel::FlipLog path =
        connect(made(pair.from, pair.vertices), made(pair.to, pair.vertices)).value();
    RC_ASSERT(words(shortening_keeps_the_ends(path.start, path.flips)) == "");
}

TEST(Theorem43, HoldsOfLargePairs) {
    const Triangulation random = families::random(20'000, 0, 1);
    EXPECT_EQ(words(any_two_spheres_connect(random, families::book(20'000))), "");
    EXPECT_EQ(words(any_two_spheres_connect(families::double_wheel(20'000), random)), "");
}

TEST(Theorem43, HoldsOfTheSmallestSpheres) {
    EXPECT_EQ(words(any_two_spheres_connect(families::book(3), families::book(3))), "");
    EXPECT_EQ(words(any_two_spheres_connect(families::book(4), families::tetrahedron())), "");
}

TEST(Theorem43, IsFoundToFailWhereThereIsNoPath) {
    const auto finding = any_two_spheres_connect(families::book(6), families::book(7));
    ASSERT_TRUE(finding.has_value());
    EXPECT_EQ(finding->violation.code, ViolationCode::path_does_not_connect);
    EXPECT_TRUE(any_two_spheres_connect(families::torus_grid(3, 3), families::torus_grid(3, 3)));
}

TEST(PathLeadsTo, AsksForTheStartTheEndTheLengthAndEveryFlip) {
    const Triangulation from = families::book(6);
    const Triangulation to = families::stacked(6, 1);
    const kernel::FlipLog path = connect(from, to).value();
    const auto length = static_cast<std::int64_t>(path.flips.size());
    ASSERT_GT(length, 1);
    EXPECT_EQ(words(path_leads_to(path, from, to, length)), "");

    const auto too_long = path_leads_to(path, from, to, length - 1);
    ASSERT_TRUE(too_long.has_value());
    EXPECT_EQ(too_long->violation.code, ViolationCode::path_does_not_connect);
    EXPECT_EQ(too_long->violation.found, length);
    EXPECT_EQ(too_long->violation.expected, length - 1);
    EXPECT_TRUE(path_leads_to(path, to, to, length)) << "it starts elsewhere";
    EXPECT_TRUE(path_leads_to(path, from, families::stacked(6, 2), length)) << "it ends elsewhere";

    kernel::FlipLog cut = path;
    cut.flips.pop_back();
    const auto stops_before = path_leads_to(cut, from, to, length);
    ASSERT_TRUE(stops_before.has_value());
    EXPECT_EQ(stops_before->step, cut.flips.size());

    // The sphere of two faces refuses every flip, and ends where it should all the same.
    const kernel::FlipLog refused{families::book(3), {Edge{0}}};
    const auto not_done = path_leads_to(refused, refused.start, refused.start, 1);
    ASSERT_TRUE(not_done.has_value());
    EXPECT_EQ(not_done->step, 0U);
}

// ---- the generator ----

TEST(AnySpherePair, CoversShapesLabelsMirrorsAndSizes) {
    std::set<std::size_t> seen_shapes;
    std::set<Labels> labels;
    std::set<bool> mirrors;
    std::set<Index> sizes;
    bool some_equal_shape = false;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const SpherePair pair = any_sphere_pair()(rc::Random(seed), rc::kNominalSize).value();
        seen_shapes.insert(pair.from.shape);
        labels.insert(pair.to.labels);
        mirrors.insert(pair.to.mirrored);
        sizes.insert(pair.vertices);
        some_equal_shape = some_equal_shape || pair.from.shape == pair.to.shape;
        EXPECT_EQ(made(pair.from, pair.vertices).vertex_count(), pair.vertices);
        EXPECT_EQ(made(pair.to, pair.vertices).genus(), 0);
    }
    EXPECT_EQ(seen_shapes.size(), shapes.size());
    EXPECT_EQ(labels.size(), 3U);
    EXPECT_EQ(mirrors.size(), 2U);
    EXPECT_EQ(*sizes.begin(), 4);
    EXPECT_GT(*sizes.rbegin(), 180);
    EXPECT_TRUE(some_equal_shape);
}

TEST(AnySpherePair, MirrorsAndRelabelsForReal) {
    const Index vertices = 12;
    const Recipe plain{.shape = 2, .seed = 5};
    Recipe mirrored = plain;
    mirrored.mirrored = true;
    Recipe reversed = plain;
    reversed.labels = Labels::reversed;
    const Triangulation surface = made(plain, vertices);
    EXPECT_FALSE(same_labelled_surface(surface, made(mirrored, vertices)));
    EXPECT_FALSE(same_labelled_surface(surface, made(reversed, vertices)));
    EXPECT_EQ(surface, families::stacked(vertices, 5));
}

}  // namespace
}  // namespace tightflip::properties
