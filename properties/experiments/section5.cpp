// How often plain local search reaches the convex triangulation (Alboul et al., section 5): tables
// by family of data, size and kind of start, as Markdown.
//
//     section5            the tables of docs/theory.md, some minutes
//     section5 --short    small ones, seconds; for tests
//
// Exits with 1 where a run breaks what is claimed of all of them.

#include <tightflip/geometry/convex_data.hpp>
#include <tightflip/geometry/convex_hull.hpp>
#include <tightflip/geometry/convexify.hpp>
#include <tightflip/geometry/criterion.hpp>
#include <tightflip/geometry/data_sets.hpp>
#include <tightflip/geometry/optimise.hpp>
#include <tightflip/geometry/self_intersections.hpp>
#include <tightflip/geometry/star_shaped.hpp>
#include <tightflip/geometry/surface_measures.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/simple_flip.hpp>
#include <tightflip/kernel/surface_equality.hpp>
#include <tightflip/properties/embedded_triangulations.hpp>
#include <tightflip/properties/optimisation_claims.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace tightflip::properties {
namespace {

using geometry::AllowedFlips;
using geometry::CriterionKind;
using geometry::FlipOrder;
using geometry::Point;
using geometry::Surface;
using kernel::Edge;
using kernel::Index;
using kernel::RandomStream;
using kernel::Triangulation;

// ---- data ----

/// Points of the curve (t, t^2, t^3): those at its ends are neighbours of all others on the hull.
Surface on_a_curve(Index vertices, std::uint64_t seed) {
    RandomStream random(seed);
    std::vector<Point> points;
    while (points.size() < static_cast<std::size_t>(vertices)) {
        const double t = static_cast<double>(random.below(20'001)) / 10'000 - 1;
        const Point point(t, t * t, t * t * t);
        if (std::ranges::find(points, point) == points.end()) points.push_back(point);
    }
    return geometry::convex_surface(std::move(points)).value();
}

/// The points of the twisted double prism in random order; top and bottom are flat.
Surface prism(Index vertices, std::uint64_t seed) {
    const Surface twisted = geometry::data_sets::twisted_prism(vertices / 3);
    std::vector<Point> points(twisted.points().begin(), twisted.points().end());
    RandomStream(seed).shuffle(std::span(points));
    return geometry::convex_surface(std::move(points)).value();
}

struct Family {
    std::string_view name;
    Surface (*hull)(Index vertices, std::uint64_t seed);
    Index least_vertices = 4;
};

constexpr std::array<Family, 4> families{
    {{"sphere", geometry::data_sets::random_sphere},
     {"ellipsoid 3:2:1", geometry::data_sets::random_ellipsoid},
     {"twisted prism", prism, 9},
     {"curve (t, t², t³)", on_a_curve}}};

// ---- starts ----

/// So many attempts for each vertex to flip random edges, done where `allowed`.
template <class Allowed>
Triangulation after_random_flips(const Surface& hull, Index each, std::uint64_t seed,
                                 Allowed&& allowed) {
    Surface surface = hull;
    RandomStream random(seed);
    const auto edges = static_cast<std::uint32_t>(hull.triangulation().edge_count());
    Index left = each * hull.triangulation().vertex_count();
    for (int attempts = 0; left > 0 && attempts < 1'000'000; ++attempts) {
        const Edge e{static_cast<Index>(random.below(edges))};
        if (!allowed(surface, e)) continue;
        static_cast<void>(surface.triangulation().flip(e));
        --left;
    }
    return surface.triangulation();
}

bool keeps_simple(const Surface& surface, Edge e) {
    return can_flip_simply(surface.triangulation().table(), e);
}

bool keeps_embedded(const Surface& surface, Edge e) {
    return flip_keeps_embedded(surface.view(), e);
}

/// Star-shaped about the mean of four of the points, and so embedded.
Triangulation star_shaped(const Surface& hull, std::uint64_t seed) {
    RandomStream random(seed);
    const std::vector<Point> points(hull.points().begin(), hull.points().end());
    while (true) {
        Point centre(0, 0, 0);
        for (int i = 0; i < 4; ++i)
            centre += 0.25 * points[random.below(static_cast<std::uint32_t>(points.size()))];
        const auto surface = geometry::star_shaped_surface(points, centre);
        if (surface && surface.value().faces_turned_away == 0) {
            return surface.value().surface.triangulation();
        }
    }
}

struct StartKind {
    std::string_view name;
    std::function<Triangulation(const Surface& hull, std::uint64_t seed)> make;
    bool is_embedded = false;
    bool always_ends_convex = false;  ///< under every search, in all runs so far
};

std::vector<StartKind> start_kinds() {
    const auto flips = [](Index each, bool (*allowed)(const Surface&, Edge)) {
        return [each, allowed](const Surface& hull, std::uint64_t seed) {
            return after_random_flips(hull, each, seed, allowed);
        };
    };
    return {{"embedded: hull and V flips that keep it so", flips(1, keeps_embedded), true},
            {"embedded: hull and 10 V such flips", flips(10, keeps_embedded), true},
            {"star-shaped", star_shaped, true, true},
            {"hull and V simple flips", flips(1, keeps_simple)},
            {"hull and 10 V simple flips", flips(10, keeps_simple)},
            {"random triangulation",
             [](const Surface& hull, std::uint64_t seed) {
                 return kernel::families::random(hull.triangulation().vertex_count(), 0, seed);
             }},
            {"book", [](const Surface& hull, std::uint64_t /*seed*/) {
                 return kernel::families::book(hull.triangulation().vertex_count());
             }}};
}

// ---- searches ----

struct Search {
    std::string_view name;
    CriterionKind criterion;
    FlipOrder order = FlipOrder::first;
    AllowedFlips allowed = AllowedFlips::all;

    /// Flips that keep a surface embedded are for embedded starts.
    [[nodiscard]] bool is_for(const StartKind& kind) const {
        return kind.is_embedded || allowed != AllowedFlips::embedded;
    }
};

constexpr std::array<Search, 4> searches{
    {{"Tight, first", CriterionKind::tight},
     {"Tight, best", CriterionKind::tight, FlipOrder::best},
     {"Tight, first, embedded", CriterionKind::tight, FlipOrder::first, AllowedFlips::embedded},
     {"concave edges", CriterionKind::volume}}};

struct Tally {
    int convex = 0;
    int inside_out = 0;

    void count(Convexity convexity) {
        convex += convexity == Convexity::convex ? 1 : 0;
        inside_out += convexity == Convexity::inside_out ? 1 : 0;
    }
};

Convexity end_of(const Search& search, const Surface& start) {
    Triangulation surface = start.triangulation();
    const auto criterion = make_criterion(search.criterion, {surface.table(), start.points()});
    static_cast<void>(optimise(surface, start.points(), *criterion,
                               {.order = search.order, .allowed = search.allowed}));
    return convexity({surface.table(), start.points()});
}

/// Its volume is not negative: the concave-edge rule needs to know outside from inside.
Surface turned_outwards(const Surface& surface) {
    if (measure(surface.view()).volume >= 0) return surface;
    std::vector<Point> reflected;
    for (const Point& point : surface.points())
        reflected.emplace_back(-point);
    return {surface.triangulation(), std::move(reflected)};
}

std::string one_decimal(double x) {
    std::array<char, 32> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "%.1f", x));
    return text.data();
}

/// Percent of all runs, and after a plus those that end inside out.
std::string percent(const Tally& tally, int runs) {
    const auto share = [runs](int count) { return one_decimal(100.0 * count / runs); };
    return share(tally.convex) + (tally.inside_out > 0 ? " + " + share(tally.inside_out) : "");
}

struct Sizes {
    Index vertices;
    int runs;
};

class Tables {
public:
    /// One row for each family, size and kind of start.
    void successes(std::span<const Sizes> sizes) {
        std::printf("| data | V | start | runs |");
        for (const Search& search : searches)
            std::printf(" %s |", std::string(search.name).c_str());
        std::printf("\n|---|---:|---|---:|---:|---:|---:|---:|\n");
        for (const Family& family : families) {
            for (const Sizes& size : sizes) {
                for (const StartKind& kind : start_kinds())
                    row(family, size, kind);
            }
        }
    }

    [[nodiscard]] bool all_held() const noexcept { return all_held_; }

private:
    void row(const Family& family, const Sizes& size, const StartKind& kind) {
        std::array<Tally, searches.size()> tallies{};
        for (int run = 1; run <= size.runs; ++run) {
            const auto seed = static_cast<std::uint64_t>(run);
            const Surface hull = family.hull(size.vertices, seed);
            const Surface start = turned_outwards(
                Surface(kind.make(hull, seed), {hull.points().begin(), hull.points().end()}));
            check(start);
            for (std::size_t i = 0; i < searches.size(); ++i) {
                if (!searches.at(i).is_for(kind)) continue;
                tallies.at(i).count(end_of(searches.at(i), start));
            }
        }
        std::printf("| %s | %d | %s | %d |", std::string(family.name).c_str(), size.vertices,
                    std::string(kind.name).c_str(), size.runs);
        for (std::size_t i = 0; i < searches.size(); ++i) {
            const Tally& tally = tallies.at(i);
            const bool is_run = searches.at(i).is_for(kind);
            if (kind.always_ends_convex && tally.convex < size.runs) all_held_ = false;
            std::printf(" %s |", is_run ? percent(tally, size.runs).c_str() : "");
        }
        std::printf("\n");
        static_cast<void>(std::fflush(stdout));
    }

    /// What is claimed of every embedded start.
    void check(const Surface& start) {
        for (const auto& finding :
             {tight_is_global(start), concave_flips_do_not_raise_tight(start)}) {
            if (!finding) continue;
            std::printf("\n%s\n", describe(*finding).c_str());
            all_held_ = false;
        }
    }

    bool all_held_ = true;
};

// ---- convexify ----

/// What `convexify` made of all starts of some sizes.
class ConvexifyTable {
public:
    static void head() {
        std::printf(
            "| V | starts | convex | flips a vertex | at most | of concave edges | at most |\n"
            "|---|---:|---:|---:|---:|---:|---:|\n");
    }

    void run(const Triangulation& start, const Surface& hull) {
        ++starts_;
        Triangulation surface = start;
        const geometry::ConvexifyResult result =
            geometry::convexify(surface, hull.points(), {.concave_edges_first = starts_ % 2 == 0});
        const kernel::Replay replayed = kernel::replay({start, result.flips});
        if (!result || !replayed.is_complete() || replayed.surface != surface ||
            convexity({surface.table(), hull.points()}) != Convexity::convex) {
            return;
        }
        ++convex_;
        const auto each = static_cast<double>(start.vertex_count());
        flips_.add(static_cast<double>(result.flips.size()) / each);
        concave_.add(static_cast<double>(result.concave_flips) / each);
    }
    /// Prints the row; whether all ended convex.
    [[nodiscard]] bool row(std::string_view sizes) const {
        std::printf("| %s | %d | %d | %s | %s | %s | %s |\n", std::string(sizes).c_str(), starts_,
                    convex_, one_decimal(flips_.sum / starts_).c_str(),
                    one_decimal(flips_.most).c_str(), one_decimal(concave_.sum / starts_).c_str(),
                    one_decimal(concave_.most).c_str());
        static_cast<void>(std::fflush(stdout));
        return convex_ == starts_;
    }

private:
    struct Figure {
        double sum = 0;
        double most = 0;

        void add(double x) {
            sum += x;
            most = std::max(most, x);
        }
    };

    int starts_ = 0;
    int convex_ = 0;
    Figure flips_;
    Figure concave_;
};

struct Range {
    std::string_view name;
    Index first;
    Index last;
    int seeds;
};

/// Every size of a range, every family and kind of start.
bool from_every_kind(const Range& range) {
    ConvexifyTable table;
    for (Index vertices = range.first; vertices <= range.last; ++vertices) {
        for (const Family& family : families) {
            if (vertices < family.least_vertices) continue;
            for (int run = 1; run <= range.seeds; ++run) {
                const auto seed = static_cast<std::uint64_t>(run);
                const Surface hull = family.hull(vertices, seed);
                for (const StartKind& kind : start_kinds())
                    table.run(kind.make(hull, seed), hull);
            }
        }
    }
    return table.row(range.name);
}

/// Large ones: random points of a sphere, starts that meet themselves everywhere.
bool from_wild_starts(std::string_view name, Index vertices, int seeds) {
    ConvexifyTable table;
    for (int run = 1; run <= seeds; ++run) {
        const auto seed = static_cast<std::uint64_t>(run);
        const Surface hull = geometry::data_sets::random_sphere(vertices, seed);
        for (const StartKind& kind : start_kinds()) {
            if (!kind.is_embedded) table.run(kind.make(hull, seed), hull);
        }
    }
    return table.row(name);
}

// ---- all triangulations of few points ----

struct SurfaceHash {
    std::size_t operator()(const Triangulation& s) const { return surface_hash(s); }
};
struct SameSurface {
    bool operator()(const Triangulation& a, const Triangulation& b) const {
        return same_labelled_surface(a, b);
    }
};

std::vector<Triangulation> all_spheres(Index vertices) {
    std::vector<Triangulation> all{kernel::families::double_wheel(vertices)};
    std::unordered_set<Triangulation, SurfaceHash, SameSurface> seen{all.front()};
    for (std::size_t next = 0; next < all.size(); ++next) {
        for (Index e = 0; e < all.front().edge_count(); ++e) {
            Triangulation flipped = all[next];
            if (flipped.flip({e}) && seen.insert(flipped).second) all.push_back(flipped);
        }
    }
    return all;
}

/// From every labelled triangulation of random points on a sphere, by what it is.
void every_start(Index vertices, int point_sets) {
    struct Kind {
        std::string_view name;
        int starts = 0;
        std::array<Tally, 2> tallies{};
    };
    std::array<Kind, 3> kinds{{{"embedded"}, {"local self-intersections only"}, {"global ones"}}};
    const std::vector<Triangulation> spheres = all_spheres(vertices);
    for (int set = 1; set <= point_sets; ++set) {
        const Surface hull =
            geometry::data_sets::random_sphere(vertices, static_cast<std::uint64_t>(set));
        for (const Triangulation& sphere : spheres) {
            const Surface start(sphere, {hull.points().begin(), hull.points().end()});
            const auto meets = find_self_intersections(start.view(), 0);
            Kind& kind = kinds.at(meets.global_count > 0 ? 2 : meets.is_embedded() ? 0 : 1);
            ++kind.starts;
            for (std::size_t i = 0; i < kind.tallies.size(); ++i) {
                const Convexity end = end_of(searches.at(i), start);
                kind.tallies.at(i).convex += end == Convexity::none ? 0 : 1;
            }
        }
    }
    for (const Kind& kind : kinds) {
        if (kind.starts == 0) continue;
        std::printf("| %d | %s | %d | %.2f | %.2f |\n", vertices, std::string(kind.name).c_str(),
                    kind.starts, 100.0 * kind.tallies[0].convex / kind.starts,
                    100.0 * kind.tallies[1].convex / kind.starts);
    }
}

/// Of all embedded triangulations of random points on a sphere, those from which no flip lowers
/// Tight; true where there are none.
bool every_embedded(Index vertices, int point_sets) {
    const std::vector<FaceSet> spheres = simple_spheres(vertices);
    int not_convex = 0;
    int stuck = 0;
    int stuck_while_embedded = 0;
    for (int set = 1; set <= point_sets; ++set) {
        const Surface hull =
            geometry::data_sets::random_sphere(vertices, static_cast<std::uint64_t>(set));
        const EmbeddedTriangulations embedded({hull.points().begin(), hull.points().end()},
                                              spheres);
        for (const FaceSet sphere : embedded.all()) {
            const Surface surface = embedded.surface(sphere);
            not_convex += convexity(surface.view()) == Convexity::none ? 1 : 0;
            stuck += tight_is_global(surface) ? 1 : 0;
            stuck_while_embedded += tight_is_global_while_embedded(surface) ? 1 : 0;
        }
    }
    std::printf("| %d | %d | %d | %d | %d |\n", vertices, point_sets, not_convex, stuck,
                stuck_while_embedded);
    return stuck == 0;
}

constexpr const char* introduction =
    R"(# How often plain local search reaches the convex triangulation

The tables behind the section on optimisation of [theory.md](theory.md), as `scripts/experiments`
prints them, some minutes on one core; every run has a seed, 1 to the number of runs, and the
numbers are the same each time.

Percent of runs that end in a surface whose exact certificate says that it is convex up to flat
edges; after a plus, those that end in it inside out. Plain local search by EDFs: on Tight, with the
flip that has waited longest or the best one, with all flips or, from embedded starts, those that
keep the surface embedded; and of concave edges, which only looks at signs. Starts whose volume is
negative are turned over first. The twisted prism's data are not in general position.

)";

constexpr const char* all_triangulations = R"(
The same for all labelled triangulations, parallel edges included, of random points of the sphere,
by how the start meets itself; either way round counts as convex.

| V | start | starts | Tight, first | Tight, best |
|---:|---|---:|---:|---:|
)";

constexpr const char* embedded_triangulations = R"(
All embedded triangulations of random points of the sphere that are not convex: how many no flip
lowers Tight of, and how many no flip to an embedded one.

| V | point sets | not convex | no flip | no flip to an embedded one |
|---:|---:|---:|---:|---:|
)";

constexpr const char* by_construction = R"(
What `convexify` (geometry/convexify.hpp) makes of such starts, every other time without the try of
concave edges alone: how many end convex, certified and with a log that leads there, and in how many
flips. To V = 100 all data and starts above; beyond, random points of the sphere and the starts that
are not embedded.

)";

bool print_tables(bool is_short) {
    Tables tables;
    const std::vector<Sizes> sizes =
        is_short ? std::vector<Sizes>{{9, 4}} : std::vector<Sizes>{{9, 1000}, {21, 300}, {99, 100}};
    std::printf("%s", introduction);
    tables.successes(sizes);
    std::printf("%s", all_triangulations);
    every_start(5, is_short ? 5 : 500);
    every_start(6, is_short ? 1 : 100);
    std::printf("%s", embedded_triangulations);
    bool held = tables.all_held();
    for (const Sizes& size : is_short ? std::vector<Sizes>{{5, 5}, {6, 5}, {7, 1}}
                                      : std::vector<Sizes>{{5, 500}, {6, 500}, {7, 300}, {8, 100}})
        held = every_embedded(size.vertices, size.runs) && held;
    std::printf("%s", by_construction);
    ConvexifyTable::head();
    for (const Range& range :
         is_short ? std::vector<Range>{{"4 to 10", 4, 10, 1}}
                  : std::vector<Range>{
                        {"4 to 10", 4, 10, 10}, {"11 to 30", 11, 30, 5}, {"31 to 100", 31, 100, 4}})
        held = from_every_kind(range) && held;
    held = from_wild_starts("1000", 1000, is_short ? 1 : 15) && held;
    if (!is_short) held = from_wild_starts("10,000", 10'000, 15) && held;
    return held;
}

}  // namespace
}  // namespace tightflip::properties

int main(int argc, char** argv) {
    const bool is_short = argc == 2 && std::string_view(argv[1]) == "--short";
    if (argc > 1 && !is_short) {
        static_cast<void>(std::fputs("usage: section5 [--short]\n", stderr));
        return 2;
    }
    return tightflip::properties::print_tables(is_short) ? 0 : 1;
}
