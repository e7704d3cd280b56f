// Links the kernel alone: flips an edge of a tetrahedron twice and meets a vertex of degree 2.
#include <tightflip/kernel/families.hpp>

#include <iostream>

using namespace tightflip::kernel;

int main() {
    Triangulation surface = families::tetrahedron();
    const Edge e{0};
    surface.flip(e);

    const AuditReport report = audit(surface);
    std::cout << "valid " << report.is_valid() << ", genus " << surface.genus() << ", least degree "
              << report.degrees->min << ", parallel pairs " << report.parallels->pairs_joined_twice
              << '\n';

    surface.unflip(e);
    return surface == families::tetrahedron() ? 0 : 1;
}
