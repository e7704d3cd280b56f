#include "flip_geometry.hpp"

#include "decode.hpp"
#include <tightflip/properties/geometry_claims.hpp>

#include <vector>

namespace tightflip::fuzz {

GeometryCase decode_geometry_case(std::span<const std::uint8_t> data) {
    Bytes bytes(data);
    kernel::Triangulation start = decode_start(bytes).start();
    const std::uint32_t largest = 1 + bytes.byte() % most_coordinate;
    const std::size_t flips = bytes.byte() % (most_geometry_flips + 1);
    properties::FlipScript script;
    for (std::size_t k = 0; k < flips; ++k)
        script.push_back({static_cast<kernel::Index>(bytes.pair()) % start.edge_count()});
    std::vector<geometry::Point> points(static_cast<std::size_t>(start.vertex_count()));
    for (geometry::Point& point : points) {
        for (double& coordinate : point)
            coordinate = static_cast<double>(bytes.byte() % (2 * largest + 1)) - largest;
    }
    return {{std::move(start), std::move(points)}, std::move(script)};
}

std::string geometry_objection(const GeometryCase& geometry_case) {
    const auto finding =
        properties::geometry_claims_hold(geometry_case.start, geometry_case.script);
    return finding ? describe(*finding) : std::string();
}

}  // namespace tightflip::fuzz
