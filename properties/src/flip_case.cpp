#include <tightflip/properties/flip_case.hpp>

#include <ostream>

namespace tightflip::properties {

kernel::FlipLog FlipCase::log() const {
    kernel::FlipLog log{start(), {}};
    const auto edges = static_cast<std::uint32_t>(log.start.edge_count());
    log.flips.reserve(picks.size());
    for (const std::uint32_t pick : picks)
        log.flips.push_back({static_cast<Index>(pick % edges)});
    return log;
}

std::string describe(const FlipCase& flip_case) {
    const kernel::FlipLog log = flip_case.log();
    std::string text(flip_case.kind->name);
    text += ", V = " + std::to_string(log.start.vertex_count());
    text += ", genus " + std::to_string(log.start.genus());
    text += ", seed " + std::to_string(flip_case.request.seed);
    text += ", E = " + std::to_string(log.start.edge_count()) + "; flips";
    for (const Edge e : log.flips)
        text += " " + std::to_string(e.id);
    if (log.flips.empty()) text += " none";
    return text;
}

void write_in_words(std::ostream& out, const kernel::FlipLog& log) {
    Triangulation surface = log.start;
    const auto ends = [&](Edge e) {
        const kernel::Halfedge h = halfedge_of(e);
        return std::to_string(surface.origin(h).id) + "-" + std::to_string(surface.target(h).id);
    };
    out << "a surface of genus " << surface.genus() << " with " << surface.vertex_count()
        << " vertices and " << surface.edge_count() << " edges\n";
    std::size_t step = 0;
    for (const Edge e : log.flips) {
        out << "flip " << ++step << ": edge " << e.id << " joins " << ends(e);
        if (const auto verdict = surface.flip(e)) {
            out << ", becomes " << ends(e) << "\n";
        } else {
            out << ", refused: " << describe(verdict.refusal()) << "\n";
        }
    }
}

}  // namespace tightflip::properties
