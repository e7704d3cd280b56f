#include <tightflip/geometry/soup_gluing.hpp>

#include <algorithm>

namespace tightflip::geometry {
namespace {

/// Two sides that start at one vertex run in the same direction.
kernel::SideGluing gluing_of(const TriangleSoup& soup, std::size_t side, Index other) {
    if (other < 0) return {};
    const auto start = [&](std::size_t s) { return soup.triangles[s / 3][s % 3]; };
    const auto end = [&](std::size_t s) { return soup.triangles[s / 3][(s + 1) % 3]; };
    const auto t = static_cast<std::size_t>(other);
    const bool is_reversed = start(side) == start(t) && end(side) == end(t);
    return is_reversed ? kernel::SideGluing::reversed(other) : kernel::SideGluing::coherent(other);
}

}  // namespace

kernel::FaceListReading glue(const TriangleSoup& soup) {
    if (soup.glued_sides.empty()) return kernel::glue_faces(soup.triangles, soup.vertex_count());
    kernel::FaceListReading reading;
    reading.gluing.vertex_count = soup.vertex_count();
    reading.gluing.faces.resize(soup.triangles.size());
    for (std::size_t s = 0; s < 3 * soup.triangles.size(); ++s) {
        kernel::GluedFace& face = reading.gluing.faces[s / 3];
        face.corners[s % 3] = soup.triangles[s / 3][s % 3];
        face.sides[s % 3] = gluing_of(soup, s, soup.glued_sides[s / 3][s % 3]);
    }
    return reading;
}

kernel::AuditReport audit(const kernel::FaceListReading& reading) {
    kernel::AuditReport report = kernel::audit(reading.gluing);
    const std::vector<kernel::Violation>& undetermined = reading.violations;
    const auto count = static_cast<std::int64_t>(undetermined.size());
    report.violation_count += count;
    report.violations.insert(
        report.violations.begin(), undetermined.begin(),
        undetermined.begin() + std::min(count, kernel::AuditOptions{}.max_per_code));
    std::ranges::stable_sort(report.violations, kernel::precedes);
    return report;
}

}  // namespace tightflip::geometry
