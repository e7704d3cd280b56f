#include "refusals.hpp"
#include "surfaces.hpp"
#include <tightflip/kernel/build.hpp>
#include <tightflip/kernel/certificate.hpp>
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/random.hpp>
#include <tightflip/kernel/surface_equality.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {

static void PrintTo(CertificateFault fault, std::ostream* out) {
    *out << name(fault);
}

namespace {

using ::testing::HasSubstr;
using testing::refusal_of;

// ---- what the tests verify ----

Edge random_edge(const Triangulation& surface, RandomStream& random) {
    return {static_cast<Index>(random.below(static_cast<std::uint32_t>(surface.edge_count())))};
}

/// A log of flips that are all defined, at most `attempts`.
FlipLog random_log(const Triangulation& start, std::size_t attempts, RandomStream& random) {
    RecordedSurface surface(start);
    for (std::size_t k = 0; k < attempts; ++k)
        surface.flip(random_edge(start, random));
    return surface.log();
}

/// The same labelled surface with its edges and their halves numbered otherwise.
Triangulation renumbered(const Triangulation& surface, RandomStream& random) {
    std::vector<Index> edges(static_cast<std::size_t>(surface.edge_count()));
    std::iota(edges.begin(), edges.end(), Index{0});
    random.shuffle(std::span(edges));
    std::vector<Halfedge> names;
    for (const Index e : edges) {
        const auto half = static_cast<Index>(random.below(2));
        names.push_back({2 * e + half});
        names.push_back({2 * e + 1 - half});
    }
    std::vector<HalfedgeRecord> records(names.size());
    for (std::size_t h = 0; h < names.size(); ++h) {
        const auto& [next, origin] = surface.table()[h];
        records[static_cast<std::size_t>(names[h].id)] = {names[static_cast<std::size_t>(next.id)],
                                                          origin};
    }
    return build(std::move(records), surface.vertex_count()).value();
}

/// The surface with the vertices `a` and `b` exchanged.
Triangulation with_labels_exchanged(const Triangulation& surface, Index a, Index b) {
    std::vector<HalfedgeRecord> records(surface.table().begin(), surface.table().end());
    for (auto& [next, origin] : records) {
        origin.id = origin.id == a ? b : origin.id == b ? a : origin.id;
    }
    return build(std::move(records), surface.vertex_count()).value();
}

std::vector<Triangulation> starts() {
    return {
        families::tetrahedron(),    families::book(3),         families::book(7),
        families::torus_grid(3, 3), families::random(9, 0, 1), families::random(60, 0, 2),
        families::random(5, 1, 3),  families::random(6, 2, 4), families::surface_of_genus(2, 3, 5)};
}

void expect_fault(const CertificateVerdict& verdict, CertificateFault fault, std::size_t done,
                  const std::string& words) {
    EXPECT_EQ(verdict.fault, fault) << verdict.reason;
    EXPECT_FALSE(verdict);
    EXPECT_EQ(verdict.flips_done, done);
    EXPECT_THAT(verdict.reason, HasSubstr(words));
}

// ---- what holds ----

TEST(Certificate, HoldsForLegalFlipsWhateverTheNumbersOfHalfedges) {
    RandomStream random(1);
    for (const Triangulation& start : starts()) {
        for (int run = 0; run < 10; ++run) {
            const FlipLog log = random_log(start, 100, random);
            const Triangulation end = replay(log).surface;
            const CertificateVerdict verdict =
                verify(renumbered(start, random), renumbered(end, random), log);
            EXPECT_TRUE(verdict) << verdict.reason;
            EXPECT_EQ(verdict.fault, CertificateFault::none);
            EXPECT_EQ(verdict.flips_done, log.flips.size());
            EXPECT_EQ(verdict.reason, "");
            FlipLog back{end, {log.flips.rbegin(), log.flips.rend()}};
            EXPECT_TRUE(verify(end, start, back)) << "flips of the same edges lead back";
        }
    }
}

TEST(Certificate, AgreesWithReplayAndEqualityOnAnyScript) {
    RandomStream random(2);
    std::map<CertificateFault, int> seen;
    for (std::uint64_t run = 0; run < 6000; ++run) {
        const auto vertices = static_cast<Index>(4 + random.below(3));
        const Triangulation a = families::random(vertices, random.below(3) == 0 ? 1 : 0, run % 5);
        FlipLog log{a, {}};
        for (std::uint32_t k = random.below(7); k > 0; --k)
            log.flips.push_back(random_edge(a, random));
        // Ends nearby, so that many scripts do lead there.
        const Triangulation b =
            replay(random_log(replay(log).surface, random.below(3), random)).surface;
        const Replay replayed = replay(log);
        const CertificateVerdict verdict = verify(a, renumbered(b, random), log);
        ++seen[verdict.fault];
        ASSERT_EQ(static_cast<bool>(verdict),
                  replayed.is_complete() && same_labelled_surface(replayed.surface, b))
            << verdict.reason;
        ASSERT_EQ(verdict.flips_done, replayed.done);
        ASSERT_EQ(verdict.fault == CertificateFault::flip_not_defined, !replayed.is_complete());
    }
    for (const auto fault : {CertificateFault::none, CertificateFault::flip_not_defined,
                             CertificateFault::log_ends_elsewhere}) {
        EXPECT_GT(seen[fault], 300) << name(fault);
    }
}

TEST(Certificate, LongLogsAreFollowedToTheEnd) {
    RandomStream random(3);
    const Triangulation start = families::random(2000, 0, 1);
    FlipLog log = random_log(start, 200'000, random);
    const Triangulation end = replay(log).surface;
    EXPECT_TRUE(verify(start, end, log));
    log.flips.pop_back();
    expect_fault(verify(start, end, log), CertificateFault::log_ends_elsewhere, log.flips.size(),
                 "degree");
}

// ---- what does not ----

TEST(Certificate, NamesTheFirstFlipThatIsNotDefined) {
    const Triangulation start = families::tetrahedron();
    // Flipping edge 0 makes its ends vertices of degree 2, whose edges cannot be flipped.
    const Triangulation flipped = replay({start, {{0}}}).surface;
    Index refused = 0;
    while (flipped.can_flip({refused}))
        ++refused;
    const FlipLog log{start, {{0}, {refused}, {0}}};
    const auto verdict = verify(start, start, log);
    expect_fault(verdict, CertificateFault::flip_not_defined, 1,
                 "flip 2 of 3, edge " + std::to_string(refused) + ":");
    EXPECT_THAT(verdict.reason, HasSubstr("loop"));
}

TEST(Certificate, NamesTheFirstFlipOfAnEdgeThatDoesNotExist) {
    const Triangulation start = families::tetrahedron();
    for (const Index edge : {6, -1, 1 << 30, std::numeric_limits<Index>::min()}) {
        const FlipLog log{start, {{0}, {edge}, {99}}};
        expect_fault(verify(start, start, log), CertificateFault::no_such_edge, 1,
                     "flip 2 of 3, edge " + std::to_string(edge) + ": there is no such edge");
    }
}

TEST(Certificate, TellsASurfaceFromItsMirrorImage) {
    const Triangulation tetrahedron = families::tetrahedron();
    const Triangulation mirrored = with_labels_exchanged(tetrahedron, 2, 3);
    expect_fault(verify(tetrahedron, mirrored, FlipLog{tetrahedron, {}}),
                 CertificateFault::log_ends_elsewhere, 0, "degrees agree");
    expect_fault(verify(mirrored, tetrahedron, FlipLog{tetrahedron, {}}),
                 CertificateFault::log_starts_elsewhere, 0, "degrees agree");
    // An edge and the one opposite it, at either end of which the same four corners meet.
    const auto across = [&](Edge e) {
        const Halfedge h = halfedge_of(e);
        for (Index other = 0;; ++other) {
            const Halfedge x = halfedge_of(Edge{other});
            const std::set<Vertex> corners{tetrahedron.origin(h), tetrahedron.target(h),
                                           tetrahedron.origin(x), tetrahedron.target(x)};
            if (corners.size() == 4) return Edge{other};
        }
    };
    EXPECT_TRUE(verify(tetrahedron, mirrored, FlipLog{tetrahedron, {{0}, across({0})}}))
        << "the tetrahedron can be turned inside out by two flips";
}

/// The faces as sorted triples, each from its smallest corner on.
std::vector<std::array<Index, 3>> face_list(const Triangulation& surface) {
    std::vector<std::array<Index, 3>> faces;
    for (const Halfedge h : surface.faces()) {
        std::array<Index, 3> face{surface.origin(h).id, surface.target(h).id,
                                  surface.opposite(h).id};
        std::rotate(face.begin(), std::ranges::min_element(face), face.end());
        faces.push_back(face);
    }
    std::ranges::sort(faces);
    return faces;
}

TEST(Certificate, TellsGluingsOfOneFaceListApart) {
    RandomStream random(4);
    constexpr int enough = 200;
    for (const Index genus : {0, 1, 2}) {
        std::map<std::vector<std::array<Index, 3>>, Triangulation> known;
        int pairs = 0;
        Triangulation surface = families::random(5, genus, 1);
        for (int k = 0; k < 200'000 && pairs < enough; ++k) {
            surface.flip(random_edge(surface, random));
            const Triangulation& other =
                known.try_emplace(face_list(surface), surface).first->second;
            if (same_labelled_surface(surface, other)) continue;
            ++pairs;
            expect_fault(verify(surface, other, FlipLog{surface, {}}),
                         CertificateFault::log_ends_elsewhere, 0, "faces or their gluing");
        }
        EXPECT_EQ(pairs, enough) << "genus " << genus;
    }
}

/// With three vertices all faces have the same corners: only the gluing tells surfaces apart.
TEST(Certificate, TellsGluingsOfThreeVerticesApart) {
    int different = 0;
    for (std::uint64_t a = 0; a < 12; ++a) {
        for (std::uint64_t b = 0; b < 12; ++b) {
            const Triangulation one = families::surface_of_genus(4, 3, a);
            const Triangulation other = families::surface_of_genus(4, 3, b);
            const bool same = same_labelled_surface(one, other);
            different += same ? 0 : 1;
            EXPECT_EQ(static_cast<bool>(verify(one, other, FlipLog{one, {}})), same);
        }
    }
    EXPECT_GT(different, 20);
}

/// The faces of a surface, two or three of them glued to one another's neighbours along parallel
/// edges; empty where that is no surface, or there are no such edges.
std::optional<Triangulation> reglued(const Triangulation& surface, RandomStream& random) {
    const Halfedge first = halfedge_of(random_edge(surface, random));
    std::vector<Index> parallel;
    for (Index h = 0; h < surface.halfedge_count(); ++h) {
        if (surface.origin({h}) == surface.origin(first) &&
            surface.target({h}) == surface.target(first)) {
            parallel.push_back(h);
        }
    }
    random.shuffle(std::span(parallel));
    const std::size_t count = 2 + random.below(2);
    if (parallel.size() < count) return std::nullopt;
    const auto moved = [&](Halfedge h) {
        for (std::size_t k = 0; k < count; ++k) {
            if (h.id == parallel[k]) return Halfedge{parallel[(k + 1) % count]};
        }
        return h;
    };
    std::vector<HalfedgeRecord> records(surface.table().size());
    for (Index h = 0; h < surface.halfedge_count(); ++h) {
        testing::nth(records, moved({h}).id) = {moved(surface.next({h})), surface.origin({h})};
    }
    return build(std::move(records), surface.vertex_count()).triangulation;
}

TEST(Certificate, TellsRegluedSurfacesApart) {
    RandomStream random(7);
    for (const Index genus : {0, 1, 2, 3}) {
        int different = 0;
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            const Triangulation surface = families::random(genus < 2 ? 8 : 4, genus, seed % 100);
            const auto other = reglued(surface, random);
            if (!other || other->genus() != genus) continue;
            const bool same = same_labelled_surface(surface, *other);
            different += same ? 0 : 1;
            ASSERT_EQ(static_cast<bool>(verify(surface, *other, FlipLog{surface, {}})), same);
        }
        EXPECT_GT(different, 20) << "genus " << genus;
    }
}

/// The torus of 2 x 2 squares with a diagonal each. Turning it by half a turn about any vertex
/// keeps all labels: it is the tetrahedron, covered twice and branched at the four vertices.
Triangulation torus_of_four_squares() {
    Gluing gluing{.vertex_count = 4, .faces = std::vector<GluedFace>(8)};
    const auto vertex = [](Index x, Index y) { return x % 2 + 2 * (y % 2); };
    const auto low = [&](Index x, Index y) { return 2 * vertex(x, y); };
    const auto high = [&](Index x, Index y) { return 2 * vertex(x, y) + 1; };
    for (Index x = 0; x < 2; ++x) {
        for (Index y = 0; y < 2; ++y) {
            testing::nth(gluing.faces, low(x, y)).corners = {vertex(x, y), vertex(x + 1, y),
                                                             vertex(x + 1, y + 1)};
            testing::nth(gluing.faces, high(x, y)).corners = {vertex(x, y), vertex(x + 1, y + 1),
                                                              vertex(x, y + 1)};
        }
    }
    for (Index x = 0; x < 2; ++x) {
        for (Index y = 0; y < 2; ++y) {
            testing::join(gluing, 3 * low(x, y), 3 * high(x, y + 1) + 1);
            testing::join(gluing, 3 * low(x, y) + 1, 3 * high(x + 1, y) + 2);
            testing::join(gluing, 3 * low(x, y) + 2, 3 * high(x, y));
        }
    }
    return build(gluing).value();
}

TEST(Certificate, ACoverIsNotASurface) {
    const Triangulation torus = torus_of_four_squares();
    auto faces = face_list(torus);
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    ASSERT_EQ(faces.size(), 4U);
    const Triangulation tetrahedron = build(faces, 4).value();
    RawFlipLog log;
    log.start.vertex_count = 4;
    for (const Index offset : {0, 12}) {
        for (const auto& [next, origin] : tetrahedron.table())
            log.start.records.push_back({{next.id + offset}, origin});
    }
    expect_fault(verify(torus, torus, log), CertificateFault::log_starts_elsewhere, 0,
                 "faces or their gluing");
    EXPECT_TRUE(verify(torus, torus, FlipLog{torus, {}}));
}

TEST(Certificate, EndsMustBeSurfacesOfOneKind) {
    const Triangulation good = families::book(5);
    const FlipLog log{good, {}};
    RawTable bad{.vertex_count = 5, .records = {good.table().begin(), good.table().end()}};
    std::swap(bad.records[0].next, bad.records[1].next);
    expect_fault(verify(bad, good, log), CertificateFault::from_is_no_surface, 0, "first surface");
    expect_fault(verify(good, bad, log), CertificateFault::to_is_no_surface, 0, "second surface");
    expect_fault(verify(RawTable{}, good, log), CertificateFault::from_is_no_surface, 0, "no face");
    expect_fault(verify(good, families::book(6), log), CertificateFault::ends_differ, 0,
                 "5 vertices and genus 0, the second 6 vertices and genus 0");
    expect_fault(verify(good, families::random(5, 1, 1), log), CertificateFault::ends_differ, 0,
                 "the second 5 vertices and genus 1");
    expect_fault(verify(families::book(6), families::book(6), log),
                 CertificateFault::log_starts_elsewhere, 0, "5 vertices and genus 0, the first");
    expect_fault(verify(families::double_wheel(5), good, log),
                 CertificateFault::log_starts_elsewhere, 0, "vertex 0 has degree 3");
    expect_fault(verify(good, families::double_wheel(5), log), CertificateFault::log_ends_elsewhere,
                 0, "vertex 0 has degree 6");
}

TEST(Certificate, BelievesNoTable) {
    RandomStream random(5);
    const Triangulation good = families::random(6, 0, 1);
    const RawTable table{.vertex_count = 6, .records = {good.table().begin(), good.table().end()}};
    for (int run = 0; run < 20'000; ++run) {
        RawTable damaged = table;
        const auto any = [&] {  // mostly in range
            const std::uint32_t choice = random.below(20);
            return choice == 0   ? std::numeric_limits<Index>::max()
                   : choice == 1 ? Index{-1}
                                 : static_cast<Index>(random.below(choice == 2 ? 50 : 24));
        };
        for (std::uint32_t k = 1 + random.below(4); k > 0; --k) {
            auto& [next, origin] = damaged.records[random.below(24)];
            if (random.below(2) == 0) {
                next.id = any();
            } else {
                origin.id = any() / 4;
            }
        }
        if (random.below(10) == 0) damaged.records.resize(random.below(30));
        const RawFlipLog log{damaged, {{1}, {3}, {5}}};
        if (damaged == table) continue;
        ASSERT_EQ(verify(good, good, log).fault, CertificateFault::log_starts_elsewhere);
        ASSERT_EQ(verify(damaged, good, log).fault, CertificateFault::from_is_no_surface);
        ASSERT_EQ(verify(good, damaged, log).fault, CertificateFault::to_is_no_surface);
    }
}

TEST(Certificate, FaultsHaveNames) {
    std::set<std::string_view> names;
    for (int code = 0; code <= 8; ++code)
        names.insert(name(static_cast<CertificateFault>(code)));
    EXPECT_EQ(names.size(), 9U);
    EXPECT_EQ(name(CertificateFault::none), "none");
    EXPECT_EQ(name(CertificateFault::ends_differ), "ends_differ");
    EXPECT_EQ(name(CertificateFault::log_ends_elsewhere), "log_ends_elsewhere");
}

// ---- tampering ----

TEST(CertificateTampering, EveryChangedByteOfEitherFormIsDetected) {
    RandomStream random(6);
    for (const Triangulation& from : {families::tetrahedron(), families::random(30, 0, 3)}) {
        const FlipLog log = random_log(from, 60, random);
        const Triangulation to = replay(log).surface;
        const auto holds = [&](const std::string& bytes) {
            try {
                return static_cast<bool>(
                    verify(from, to, parse_flip_log_as_written(bytes, "certificate")));
            } catch (const FileError&) {
                return false;
            }
        };
        for (const auto write : {write_text, write_binary}) {
            std::ostringstream out;
            write(out, log);
            const std::string bytes = out.str();
            ASSERT_TRUE(holds(bytes));
            for (std::size_t i = 0; i < bytes.size(); ++i) {
                std::set<char> values{' ', '#', '\n', '\r', '\t', '0', '9', '-', '+', '\0'};
                for (int bit = 0; bit < 8; ++bit)
                    values.insert(static_cast<char>(bytes[i] ^ (1 << bit)));
                values.insert(
                    static_cast<char>(std::toupper(static_cast<unsigned char>(bytes[i]))));
                values.erase(bytes[i]);
                std::string changed = bytes;
                for (const char value : values) {
                    changed[i] = value;
                    ASSERT_FALSE(holds(changed)) << "byte " << i << " made " << int{value};
                }
                changed.erase(i, 1);
                ASSERT_FALSE(holds(changed)) << "byte " << i << " left out";
                for (const char more : {' ', '\r', '0', '\n'}) {
                    changed = bytes;
                    changed.insert(i, 1, more);
                    ASSERT_FALSE(holds(changed)) << int{more} << " put before byte " << i;
                }
            }
            ASSERT_FALSE(holds(bytes + "\n"));
            ASSERT_FALSE(holds(bytes + "# a remark"));
        }
    }
}

}  // namespace
}  // namespace tightflip::kernel
