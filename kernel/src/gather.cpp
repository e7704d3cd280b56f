#include "hub_form.hpp"
#include <tightflip/kernel/gather.hpp>

#include <string>

namespace tightflip::kernel {

FlipLog gather_at(const Triangulation& surface, Vertex hub) {
    if (hub.id < 0 || hub.id >= surface.vertex_count()) {
        throw std::out_of_range(
            "vertex " + std::to_string(hub.id) + " does not exist: the surface has " +
            std::to_string(surface.vertex_count()) + " of them, numbered from 0");
    }
    FlipTrail trail(surface);
    hub_form::gather(trail, hub_form::leaving(surface.table(), hub));
    return {surface, std::move(trail).take_flips()};
}

}  // namespace tightflip::kernel
