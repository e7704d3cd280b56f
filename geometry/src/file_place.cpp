#include <tightflip/geometry/file_place.hpp>
#include <tightflip/kernel/gluing.hpp>

namespace tightflip::geometry {
namespace {

std::optional<std::uint64_t> at(const std::vector<std::uint64_t>& positions, Index index) {
    const auto i = static_cast<std::size_t>(index);
    if (index < 0 || i >= positions.size()) return std::nullopt;
    return positions[i];
}

}  // namespace

std::optional<std::uint64_t> file_position(const TriangleSoup& soup,
                                           const kernel::Violation& violation) {
    switch (violation.kind) {
        case kernel::PlaceKind::face:
            return at(soup.triangle_positions, violation.place);
        case kernel::PlaceKind::side:
            return at(soup.triangle_positions, kernel::face_of_side(violation.place));
        case kernel::PlaceKind::vertex:
            return at(soup.point_positions, violation.place);
        case kernel::PlaceKind::surface:
        case kernel::PlaceKind::halfedge:
        case kernel::PlaceKind::edge:
            break;
    }
    return std::nullopt;
}

std::string where(const TriangleSoup& soup, const kernel::Violation& violation) {
    // The one spelling of "file:line: text" is FileError's.
    const auto position = file_position(soup, violation);
    const auto unit = position ? soup.unit : FileError::Unit::none;
    return FileError(soup.source, unit, position.value_or(0), kernel::where(violation)).what();
}

}  // namespace tightflip::geometry
