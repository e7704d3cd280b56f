// The target flip_geometry for its two programs.

#include "flip_geometry.hpp"
#include "target.hpp"
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/properties/flip_case.hpp>

#include <ostream>

namespace tightflip::fuzz {

std::string objection(std::span<const std::uint8_t> data) {
    return geometry_objection(decode_geometry_case(data));
}

void show(std::ostream& out, std::span<const std::uint8_t> data) {
    const GeometryCase geometry_case = decode_geometry_case(data);
    const kernel::FlipLog log{geometry_case.start.triangulation(), geometry_case.script};
    write_text(out, log);
    for (const geometry::Point& point : geometry_case.start.points())
        out << "point " << point.x() << ' ' << point.y() << ' ' << point.z() << "\n";
    properties::write_in_words(out, log);
}

}  // namespace tightflip::fuzz
