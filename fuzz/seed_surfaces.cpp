#include "seed_surfaces.hpp"

#include "small_classes.hpp"
#include <tightflip/kernel/families.hpp>
#include <tightflip/kernel/flip_log.hpp>

namespace tightflip::fuzz {

std::vector<SeedSurface> seed_surfaces() {
    namespace families = kernel::families;
    std::vector<SeedSurface> surfaces{
        {"tetrahedron", families::tetrahedron()},
        {"book", families::book(7)},
        {"double_wheel", families::double_wheel(8)},
        {"stacked", families::stacked(9, 2)},
        {"prism", families::prism(4)},
        {"antiprism", families::antiprism(4)},
        {"octahedron", families::octasphere(0)},
        {"icosahedron", families::icosphere(0)},
        {"torus_grid", families::torus_grid(3, 4)},
        {"torus_three_vertices", families::surface_of_genus(1, 3, 0)},
        {"genus_two", families::surface_of_genus(2, 6, 1)},
        {"genus_three", families::surface_of_genus(3, 4, 1)},
        {"random_sphere", families::random(10, 0, 3)},
        {"random_torus", families::random(7, 1, 4)},
    };
    for (const SmallClass& one : small_classes()) {
        surfaces.push_back(
            {one.name, replay(decode_script(script_input(one.start, one.flips)).log()).surface});
    }
    return surfaces;
}

}  // namespace tightflip::fuzz
