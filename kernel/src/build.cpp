#include <tightflip/kernel/build.hpp>

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace tightflip::kernel {
namespace {

std::string first_reason(const AuditReport& report) {
    if (report.violations.empty()) return "no triangulation was built";
    const Violation& first = report.violations.front();
    return where(first) + ": " + message(first);
}

AuditReport refusal(std::vector<Violation> violations, Index vertex_count, std::size_t face_count) {
    AuditReport report;
    report.topology.vertices = vertex_count;
    report.topology.faces = static_cast<Index>(face_count);
    report.violation_count = static_cast<std::int64_t>(violations.size());
    const auto kept = std::min(report.violation_count, AuditOptions{}.max_per_code);
    violations.resize(static_cast<std::size_t>(kept));
    report.violations = std::move(violations);
    return report;
}

/// Which faces must be turned over to agree with face 0. Precondition: the gluing is valid.
std::vector<bool> turned_over(const Gluing& gluing) {
    std::vector<bool> reached(gluing.faces.size(), false);
    std::vector<bool> turned(gluing.faces.size(), false);
    std::vector<std::size_t> pending{0};
    reached[0] = true;
    while (!pending.empty()) {
        const std::size_t f = pending.back();
        pending.pop_back();
        const GluedFace& face = gluing.faces[f];
        for (std::size_t i = 0; i < 3; ++i) {
            const auto side = static_cast<std::size_t>(face.sides[i].side());
            const GluedFace& other = gluing.faces[side / 3];
            if (reached[side / 3]) continue;
            reached[side / 3] = true;
            const bool same_direction = face.corners[i] == other.corners[side % 3];
            turned[side / 3] = turned[f] != same_direction;
            pending.push_back(side / 3);
        }
    }
    return turned;
}

/// A side with the two vertices it joins, the smaller first.
struct JoiningSide {
    Index low;
    Index high;
    Index side;
};

std::vector<JoiningSide> sides_by_ends(std::span<const std::array<Index, 3>> faces) {
    std::vector<JoiningSide> sides;
    sides.reserve(3 * faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(faces[f][i], faces[f][(i + 1) % 3]);
            sides.push_back({low, high, side_of(static_cast<Index>(f), static_cast<int>(i))});
        }
    }
    std::ranges::sort(sides, [](const JoiningSide& a, const JoiningSide& b) {
        return std::tie(a.low, a.high, a.side) < std::tie(b.low, b.high, b.side);
    });
    return sides;
}

Index start_of(std::span<const std::array<Index, 3>> faces, Index side) {
    return faces[static_cast<std::size_t>(side / 3)][static_cast<std::size_t>(side % 3)];
}

Violation ambiguous(std::span<const JoiningSide> joining) {
    Violation violation{.code = ViolationCode::edge_in_more_than_two_faces,
                        .kind = PlaceKind::side,
                        .place = joining.front().side,
                        .found = static_cast<std::int64_t>(joining.size()),
                        .expected = 2};
    for (const JoiningSide& s : joining)
        violation.witness.push_back(face_of_side(s.side));
    return violation;
}

}  // namespace

const Triangulation& BuildResult::value() const& {
    if (!triangulation) throw std::invalid_argument(first_reason(report));
    return *triangulation;
}

Triangulation&& BuildResult::value() && {
    if (!triangulation) throw std::invalid_argument(first_reason(report));
    return *std::move(triangulation);
}

BuildResult build(std::vector<HalfedgeRecord> records, Index vertex_count) {
    BuildResult result{.triangulation = std::nullopt,
                       .report = audit(HalfedgeTable(records), vertex_count)};
    if (result.report.is_valid()) {
        result.triangulation = Triangulation(std::move(records), vertex_count);
    }
    return result;
}

BuildResult build(const Gluing& gluing) {
    BuildResult refused{.triangulation = std::nullopt, .report = audit(gluing)};
    if (!refused.report.is_valid()) return refused;

    const std::vector<bool> turned = turned_over(gluing);
    std::vector<Index> halfedge(3 * gluing.faces.size());  // of a side
    Index edges = 0;
    for (std::size_t s = 0; s < halfedge.size(); ++s) {
        const auto other = static_cast<std::size_t>(gluing.faces[s / 3].sides[s % 3].side());
        if (other < s) continue;
        halfedge[s] = 2 * edges;
        halfedge[other] = 2 * edges + 1;
        ++edges;
    }
    std::vector<HalfedgeRecord> records(halfedge.size());
    for (std::size_t s = 0; s < halfedge.size(); ++s) {
        const std::size_t f = s / 3;
        const std::size_t after = 3 * f + (s + 1) % 3;
        const std::size_t before = 3 * f + (s + 2) % 3;
        const std::size_t origin = turned[f] ? after : s;
        records[static_cast<std::size_t>(halfedge[s])] = {
            .next = {halfedge[turned[f] ? before : after]},
            .origin = {gluing.faces[f].corners[origin % 3]}};
    }
    return build(std::move(records), gluing.vertex_count);
}

FaceListReading glue_faces(std::span<const std::array<Index, 3>> faces, Index vertex_count) {
    FaceListReading reading;
    reading.gluing.vertex_count = vertex_count;
    reading.gluing.faces.resize(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
        reading.gluing.faces[f].corners = faces[f];
    const auto glue = [&](Index s, Index t) {
        const bool reversed = start_of(faces, s) == start_of(faces, t);
        reading.gluing.faces[static_cast<std::size_t>(s / 3)]
            .sides[static_cast<std::size_t>(s % 3)] =
            reversed ? SideGluing::reversed(t) : SideGluing::coherent(t);
    };
    const std::vector<JoiningSide> sides = sides_by_ends(faces);
    for (auto group = sides.begin(); group != sides.end();) {
        const auto end = std::find_if(group, sides.end(), [&](const JoiningSide& s) {
            return s.low != group->low || s.high != group->high;
        });
        const std::span<const JoiningSide> joining(group, end);
        if (joining.size() == 2) {
            glue(joining[0].side, joining[1].side);
            glue(joining[1].side, joining[0].side);
        } else if (joining.size() > 2) {
            reading.violations.push_back(ambiguous(joining));
        }
        group = end;
    }
    return reading;
}

BuildResult build(std::span<const std::array<Index, 3>> faces, Index vertex_count) {
    const FaceListReading reading = glue_faces(faces, vertex_count);
    if (!reading.violations.empty()) {
        return {.triangulation = std::nullopt,
                .report = refusal(reading.violations, vertex_count, faces.size())};
    }
    std::vector<Violation> repeats;
    for (std::size_t s = 0; s < 3 * faces.size(); ++s) {
        const SideGluing& gluing = reading.gluing.faces[s / 3].sides[s % 3];
        if (!gluing.is_glued() || !gluing.is_reversed() || gluing.side() < static_cast<Index>(s)) {
            continue;
        }
        repeats.push_back({.code = ViolationCode::directed_edge_repeats,
                           .kind = PlaceKind::side,
                           .place = static_cast<Index>(s),
                           .found = face_of_side(gluing.side()),
                           .witness = {faces[s / 3][s % 3], faces[s / 3][(s + 1) % 3]}});
    }
    if (!repeats.empty()) {
        return {.triangulation = std::nullopt,
                .report = refusal(std::move(repeats), vertex_count, faces.size())};
    }
    return build(reading.gluing);
}

}  // namespace tightflip::kernel
