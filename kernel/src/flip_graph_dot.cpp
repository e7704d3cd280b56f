#include <tightflip/kernel/flip_graph_dot.hpp>
#include <tightflip/kernel/plain_writer.hpp>

#include <algorithm>
#include <map>

namespace tightflip::kernel {
namespace {

/// The degrees of a surface's vertices in ascending order, as "2 2 4 4".
std::string degrees_in_words(const Triangulation& surface) {
    std::vector<Index> degrees(static_cast<std::size_t>(surface.vertex_count()));
    for (const HalfedgeRecord& record : surface.table()) {
        ++degrees[static_cast<std::size_t>(record.origin.id)];
    }
    std::ranges::sort(degrees);
    std::string words;
    for (const Index degree : degrees) {
        if (!words.empty()) words += ' ';
        words += std::to_string(degree);
    }
    return words;
}

}  // namespace

void write_dot(std::ostream& out, const ClassGraph& classes, const Eccentricities* eccentricities) {
    PlainWriter writer(out);
    writer << "graph flips {\n    node [shape=box];\n";
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const bool is_peripheral =
            eccentricities != nullptr && eccentricities->lower[i] == eccentricities->diameter;
        writer << "    " << i << " [label=\"" << i << "\\n"
               << degrees_in_words(classes.surface(i)) << "\""
               << (is_peripheral ? ", style=filled" : "") << "];\n";
    }
    for (std::size_t i = 0; i < classes.size(); ++i) {
        std::map<std::uint32_t, std::size_t> arcs;
        for (const std::uint32_t target : classes.arcs.row(i))
            ++arcs[target];
        for (const auto& [target, count] : arcs) {
            if (target < i) continue;  // written from the other end
            writer << "    " << i << " -- " << target;
            // Symmetries make the numbers differ: many flips of one class, few of the other.
            const auto back = static_cast<std::size_t>(
                std::ranges::count(classes.arcs.row(target), static_cast<std::uint32_t>(i)));
            if (count > 1 || back > 1) writer << " [label=\"" << count << ":" << back << "\"]";
            writer << ";\n";
        }
    }
    writer << "}\n";
}

}  // namespace tightflip::kernel
