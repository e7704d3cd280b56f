#include <tightflip/kernel/certificate.hpp>
#include <tightflip/kernel/halfedge_audit.hpp>
#include <tightflip/kernel/quick_audit.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace tightflip::kernel {
namespace {

constexpr std::size_t at(Index i) noexcept {
    return static_cast<std::size_t>(i);
}

/// Slot i of face f.
constexpr Index place_of(Index face, std::size_t slot) noexcept {
    return 4 * face + static_cast<Index>(slot);
}
constexpr Index face_of(Index place) noexcept {
    return place >> 2;
}
constexpr std::size_t slot_of(Index place) noexcept {
    return at(place & 3);
}
constexpr std::array<std::size_t, 3> after{1, 2, 0};

/// A surface as faces with three slots, in which darts lie: the two darts of edge e are 2e and
/// 2e + 1, and a slot is glued to wherever the other dart of its edge lies. Here a flip turns two
/// corners and moves four darts, where the kernel's flip leaves the darts and rewires `next`: the
/// two ways have no step in common.
class FaceSlots {
public:
    /// The faces of a table; empty where they are no triangles or name what does not exist.
    static std::optional<FaceSlots> read(const TableView& table);

    [[nodiscard]] Index vertex_count() const noexcept { return vertex_count_; }
    [[nodiscard]] Index face_count() const noexcept { return static_cast<Index>(faces_.size()); }
    [[nodiscard]] Index edge_count() const noexcept {
        return static_cast<Index>(place_.size() / 2);
    }
    /// Slot i of a face runs from its corner i to its corner i + 1.
    [[nodiscard]] const std::array<Index, 3>& corners(Index face) const noexcept {
        return faces_[at(face)].corners;
    }
    /// The place that a slot is glued to.
    [[nodiscard]] Index across(Index face, std::size_t slot) const noexcept {
        return place_[at(faces_[at(face)].darts[slot] ^ 1)];
    }

    /// Follows flips up to one whose edge would become a loop; returns how many were done.
    std::size_t follow(std::span<const Edge> flips);
    /// The surface as a table, for the judge.
    [[nodiscard]] RawTable table() const;

private:
    /// 32 bytes, so that a face lies in one line of the cache.
    struct alignas(32) Face {
        std::array<Index, 3> corners{};
        std::array<Index, 3> darts{-1, -1, -1};
    };

    FaceSlots(Index vertex_count, std::size_t darts)
        : vertex_count_(vertex_count), faces_(darts / 3), place_(darts, -1) {}

    [[nodiscard]] Face& face_at(Index place) noexcept { return faces_[at(face_of(place))]; }
    void put(Index dart, Index place) noexcept {
        face_at(place).darts[slot_of(place)] = dart;
        place_[at(dart)] = place;
    }
    [[nodiscard]] bool flip(Edge e) noexcept;

    Index vertex_count_;
    std::vector<Face> faces_;
    std::vector<Index> place_;  // of a dart
};

std::optional<FaceSlots> FaceSlots::read(const TableView& table) {
    const HalfedgeTable records = table.records;
    const Index vertex_count = table.vertex_count;
    const auto count = static_cast<Index>(records.size());
    const bool all_exist = std::ranges::all_of(records, [&](const HalfedgeRecord& record) {
        const auto& [next, origin] = record;
        return next.id >= 0 && next.id < count && origin.id >= 0 && origin.id < vertex_count;
    });
    if (count == 0 || count % 6 != 0 || !all_exist) return std::nullopt;
    FaceSlots slots(vertex_count, records.size());
    Index face = 0;
    for (Index first = 0; first < count; ++first) {
        if (slots.place_[at(first)] >= 0) continue;
        Index dart = first;
        for (std::size_t i = 0; i < 3; ++i) {
            if (slots.place_[at(dart)] >= 0) return std::nullopt;
            slots.put(dart, place_of(face, i));
            slots.faces_[at(face)].corners[i] = records[at(dart)].origin.id;
            dart = records[at(dart)].next.id;
        }
        if (dart != first) return std::nullopt;
        ++face;
    }
    return slots;
}

// Let ab lie in the face (a, b, c) and ba in (b, a, d). The faces become (a, d, c) and (b, c, d):
// corner b of the one turns into d, and corner a of the other into c. Dart ad moves over to where
// ab lay, bc to where ba lay, and the edge itself moves on by one slot, as dc and cd. The darts ca
// and db stay.
bool FaceSlots::flip(Edge e) noexcept {
    const Index dart = 2 * e.id;
    const Index ab = place_[at(dart)];
    const Index ba = place_[at(dart + 1)];
    Face& left = face_at(ab);
    Face& right = face_at(ba);
    const std::size_t b = after[slot_of(ab)];
    const std::size_t a = after[slot_of(ba)];
    const Index c = left.corners[after[b]];
    const Index d = right.corners[after[a]];
    if (c == d) return false;
    left.corners[b] = d;
    right.corners[a] = c;
    const Index bc = left.darts[b];
    put(right.darts[a], ab);
    put(bc, ba);
    put(dart, place_of(face_of(ab), b));
    put(dart + 1, place_of(face_of(ba), a));
    return true;
}

// A flip reads where its darts lie, then the two faces there, then writes where two more darts of
// these faces lie. Each is asked for some flips ahead; where flips in between move things, only the
// asking was in vain.
std::size_t FaceSlots::follow(std::span<const Edge> flips) {
    constexpr std::size_t stage = 8;
    for (std::size_t k = 0; k < flips.size(); ++k) {
        if (k + 3 * stage < flips.size()) {
            const Index near = 2 * flips[k + stage].id;
            const Index far = 2 * flips[k + 2 * stage].id;
            for (const Index dart : {near, near + 1}) {
                const Index place = place_[at(dart)];
                const Index moving = face_at(place).darts[after[slot_of(place)]];
                __builtin_prefetch(&place_[at(moving)], 1);
            }
            __builtin_prefetch(&face_at(place_[at(far)]), 1);
            __builtin_prefetch(&face_at(place_[at(far + 1)]), 1);
            __builtin_prefetch(&place_[at(2 * flips[k + 3 * stage].id)], 1);
        }
        if (!flip(flips[k])) return k;
    }
    return flips.size();
}

RawTable FaceSlots::table() const {
    RawTable table{.vertex_count = vertex_count_, .records = {}};
    table.records.resize(place_.size());
    for (const Face& face : faces_) {
        for (std::size_t i = 0; i < 3; ++i) {
            table.records[at(face.darts[i])] = {{face.darts[after[i]]}, {face.corners[i]}};
        }
    }
    return table;
}

// ---- comparing labelled surfaces ----

/// How many corners each vertex has: its degree.
std::vector<Index> degrees(const FaceSlots& surface) {
    std::vector<Index> count(at(surface.vertex_count()), 0);
    for (Index f = 0; f < surface.face_count(); ++f) {
        for (const Index v : surface.corners(f))
            ++count[at(v)];
    }
    return count;
}

/// The places whose slots begin at a vertex.
std::vector<Index> places_at(const FaceSlots& surface, Index vertex) {
    std::vector<Index> places;
    for (Index f = 0; f < surface.face_count(); ++f) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (surface.corners(f)[i] == vertex) places.push_back(place_of(f, i));
        }
    }
    return places;
}

/// A map from the faces of one surface onto those of another that keeps labels, orientation and
/// gluing. Preconditions: they are of equal size, and the first is connected.
class FaceMap {
public:
    FaceMap(const FaceSlots& from, const FaceSlots& to)
        : from_(from),
          to_(to),
          image_(at(from.face_count()), -1),
          is_taken_(at(to.face_count()), false) {}

    /// Whether sending one slot to another extends to all faces.
    bool extends(Index x, Index y) {
        for (const Index f : sent_) {
            is_taken_[at(face_of(image_[at(f)]))] = false;
            image_[at(f)] = -1;
        }
        sent_.clear();
        if (!send(x, y)) return false;
        for (std::size_t next = 0; next < sent_.size();) {
            const Index f = sent_[next++];  // sending its neighbours makes the list grow
            const Index image = image_[at(f)];
            std::size_t j = slot_of(image);
            for (std::size_t i = 0; i < 3; ++i, j = after[j]) {
                if (!send(from_.across(f, i), to_.across(face_of(image), j))) return false;
            }
        }
        return true;
    }

private:
    /// Whether a slot can go to another: as its face does already, or where nothing speaks against.
    bool send(Index x, Index y) {
        const Index f = face_of(x);
        const Index g = face_of(y);
        const std::size_t turn = (slot_of(y) + 3 - slot_of(x)) % 3;
        const Index image = place_of(g, turn);
        if (image_[at(f)] >= 0) return image_[at(f)] == image;
        if (is_taken_[at(g)]) return false;
        const auto& corners = from_.corners(f);
        const auto& others = to_.corners(g);
        for (std::size_t i = 0, j = turn; i < 3; ++i, j = after[j]) {
            if (corners[i] != others[j]) return false;
        }
        image_[at(f)] = image;
        is_taken_[at(g)] = true;
        sent_.push_back(f);
        return true;
    }

    const FaceSlots& from_;
    const FaceSlots& to_;
    std::vector<Index> image_;  // of a face: the place that its slot 0 goes to
    std::vector<bool> is_taken_;
    std::vector<Index> sent_;  // the faces that have an image
};

/// How two surfaces differ; empty where they do not. A face at a vertex can only go to a face at
/// that vertex, and all others follow: so it is tried with a vertex that has few. Preconditions:
/// the two are of equal size, and the first is connected.
std::string difference(const FaceSlots& a, const FaceSlots& b) {
    const std::vector<Index> degree = degrees(a);
    const std::vector<Index> other = degrees(b);
    if (const auto [x, y] = std::ranges::mismatch(degree, other); x != degree.end()) {
        return "vertex " + std::to_string(x - degree.begin()) + " has degree " +
               std::to_string(*x) + " in the one and " + std::to_string(*y) + " in the other";
    }
    const auto vertex = static_cast<Index>(std::ranges::min_element(degree) - degree.begin());
    FaceMap map(a, b);
    const Index from = places_at(a, vertex).front();
    const bool is_same =
        std::ranges::any_of(places_at(b, vertex), [&](Index to) { return map.extends(from, to); });
    return is_same ? "" : "the degrees agree, but not the faces or their gluing";
}

// ---- the verdict ----

/// What the audit has against a table, where it does not pass by the quick judge's word; else
/// empty.
std::string objection(const TableView& table) {
    if (passes_audit(table.records, table.vertex_count)) return {};
    const AuditReport report = audit(table.records, table.vertex_count);
    if (report.is_valid()) return {};
    const Violation& first = report.violations.front();
    return "no valid surface: " + where(first) + ": " + message(first);
}

std::string size_in_words(const FaceSlots& surface) {
    const Index euler_characteristic =
        surface.vertex_count() - surface.edge_count() + surface.face_count();
    return std::to_string(surface.vertex_count()) + " vertices and genus " +
           std::to_string((2 - euler_characteristic) / 2);
}

CertificateVerdict refusal(CertificateFault fault, std::string reason, std::size_t flips_done = 0) {
    return {.fault = fault, .flips_done = flips_done, .reason = std::move(reason)};
}

CertificateVerdict starts_elsewhere(const std::string& differs) {
    return refusal(CertificateFault::log_starts_elsewhere,
                   "the log does not start at the first surface: " + differs);
}

/// Follows the flips to the end, or to the first that is none.
CertificateVerdict follow(FaceSlots& surface, std::span<const Edge> flips) {
    const Index edges = surface.edge_count();
    const auto foreign =
        std::ranges::find_if(flips, [&](Edge e) { return e.id < 0 || e.id >= edges; });
    const auto known = static_cast<std::size_t>(foreign - flips.begin());
    const std::size_t done = surface.follow(flips.first(known));
    if (done == flips.size()) return {.fault = {}, .flips_done = done, .reason = {}};
    const std::string flip = "flip " + std::to_string(done + 1) + " of " +
                             std::to_string(flips.size()) + ", edge " +
                             std::to_string(flips[done].id) + ": ";
    if (done < known) {
        return refusal(CertificateFault::flip_not_defined,
                       flip +
                           "the two corners opposite it are the same vertex, so that it would "
                           "become a loop",
                       done);
    }
    return refusal(CertificateFault::no_such_edge,
                   flip + "there is no such edge; the surface has " + std::to_string(edges) +
                       ", numbered from 0",
                   done);
}

}  // namespace

std::string_view name(CertificateFault fault) noexcept {
    constexpr std::array<std::string_view, 9> names{"none",
                                                    "from_is_no_surface",
                                                    "to_is_no_surface",
                                                    "ends_differ",
                                                    "log_starts_elsewhere",
                                                    "no_such_edge",
                                                    "flip_not_defined",
                                                    "end_is_no_surface",
                                                    "log_ends_elsewhere"};
    return names[static_cast<std::size_t>(fault)];
}

CertificateVerdict verify(const TableView& from, const TableView& to, const FlipLogView& log) {
    using enum CertificateFault;
    if (const std::string wrong = objection(from); !wrong.empty()) {
        return refusal(from_is_no_surface, "the first surface is " + wrong);
    }
    if (const std::string wrong = objection(to); !wrong.empty()) {
        return refusal(to_is_no_surface, "the second surface is " + wrong);
    }
    const auto first = FaceSlots::read(from);
    const auto second = FaceSlots::read(to);
    auto surface = FaceSlots::read(log.start);
    if (from.vertex_count != to.vertex_count || from.records.size() != to.records.size()) {
        return refusal(ends_differ, "no flips join the two: the first has " +
                                        size_in_words(*first) + ", the second " +
                                        size_in_words(*second));
    }
    if (!surface) return starts_elsewhere("its table is that of no surface");
    if (log.start.vertex_count != from.vertex_count ||
        log.start.records.size() != from.records.size()) {
        return starts_elsewhere("it has " + size_in_words(*surface) + ", the first surface " +
                                size_in_words(*first));
    }
    if (const std::string differs = difference(*first, *surface); !differs.empty()) {
        return starts_elsewhere(differs);
    }
    CertificateVerdict verdict = follow(*surface, log.flips);
    if (!verdict) return verdict;
    if (const std::string wrong = objection(surface->table()); !wrong.empty()) {
        return refusal(end_is_no_surface, "what the flips lead to is " + wrong, verdict.flips_done);
    }
    if (const std::string differs = difference(*surface, *second); !differs.empty()) {
        return refusal(log_ends_elsewhere,
                       "after all " + std::to_string(verdict.flips_done) +
                           " flips it is not the second surface: " + differs,
                       verdict.flips_done);
    }
    return verdict;
}

}  // namespace tightflip::kernel
