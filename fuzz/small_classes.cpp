#include "small_classes.hpp"

#include <tightflip/kernel/canonical.hpp>

#include <array>
#include <set>

namespace tightflip::fuzz {
namespace {

using kernel::Edge;
using kernel::Index;
using kernel::Triangulation;

constexpr std::array starts{
    StartBytes{"book", 0}, StartBytes{"book", 1},     StartBytes{"book", 2},
    StartBytes{"book", 3}, StartBytes{"genus", 0, 1}, StartBytes{"genus", 1, 1},
};

/// A surface that flips lead to.
struct Reached {
    Triangulation surface;
    std::vector<std::uint32_t> flips;
};

/// Breadth-first over the classes that flips lead to: of these sizes, all there are.
void append_classes(const StartBytes& start, std::vector<SmallClass>& classes) {
    const InputBytes input = script_input(start);
    std::vector<Reached> reached{{decode_script(input).start(), {}}};
    std::set<kernel::CanonicalCode> seen{canonical_code(reached.front().surface, {})};
    const std::string name = "class_genus_" + std::to_string(reached.front().surface.genus()) +
                             "_vertices_" + std::to_string(reached.front().surface.vertex_count()) +
                             "_number_";
    for (std::size_t k = 0; k < reached.size(); ++k) {
        const Reached here = reached[k];
        classes.push_back({name + std::to_string(k), start, here.flips});
        for (Index e = 0; e < here.surface.edge_count(); ++e) {
            Reached there = here;
            if (!there.surface.flip(Edge{e})) continue;
            if (!seen.insert(canonical_code(there.surface, {})).second) continue;
            there.flips.push_back(static_cast<std::uint32_t>(e));
            reached.push_back(std::move(there));
        }
    }
}

}  // namespace

std::vector<SmallClass> small_classes() {
    std::vector<SmallClass> classes;
    for (const StartBytes& start : starts)
        append_classes(start, classes);
    return classes;
}

}  // namespace tightflip::fuzz
