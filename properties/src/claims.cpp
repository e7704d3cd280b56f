#include <tightflip/kernel/file_error.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/kernel/surface_text.hpp>
#include <tightflip/properties/claims.hpp>
#include <tightflip/properties/invariants.hpp>
#include <tightflip/properties/reference_model.hpp>

#include <algorithm>
#include <sstream>

namespace tightflip::properties {
namespace {

Finding at_edge(std::size_t step, ViolationCode code, Edge e) {
    return {step, {.code = code, .kind = kernel::PlaceKind::edge, .place = e.id}};
}

/// The surface with the two halfedges of `e` renamed into each other.
std::vector<kernel::HalfedgeRecord> with_halves_exchanged(const Triangulation& surface, Edge e) {
    const auto renamed = [&](kernel::Halfedge h) { return edge_of(h) == e ? twin(h) : h; };
    std::vector<kernel::HalfedgeRecord> records(surface.table().size());
    for (Index h = 0; h < surface.halfedge_count(); ++h) {
        const auto& [next, origin] = at(surface.table(), kernel::Halfedge{h});
        records[static_cast<std::size_t>(renamed({h}).id)] = {renamed(next), origin};
    }
    return records;
}

bool laws_hold_at(const Triangulation& surface, Edge e) {
    Triangulation moved = surface;
    if (!moved.flip(e)) return moved == surface && !moved.unflip(e) && moved == surface;
    bool holds = static_cast<bool>(moved.unflip(e)) && moved == surface;
    holds = holds && moved.unflip(e) && moved.flip(e) && moved == surface;
    holds = holds && moved.flip(e) && moved.flip(e);
    const auto exchanged = with_halves_exchanged(surface, e);
    holds = holds && std::ranges::equal(moved.table(), exchanged);
    return holds && moved.flip(e) && moved.flip(e) && moved == surface;
}

}  // namespace

std::optional<Finding> topology_is_preserved(const Triangulation& start,
                                             std::span<const Edge> script,
                                             std::size_t audit_every) {
    const Topology topology = audit(start).topology;
    Triangulation surface = start;
    std::size_t audited = script.size() + 1;  // steps before the last full audit; none yet
    const auto audit_after = [&](std::size_t step) -> std::optional<Finding> {
        audited = step;
        auto violation = first_violation(surface, topology);
        if (!violation) return std::nullopt;
        return Finding{step, *std::move(violation)};
    };
    for (std::size_t k = 0; k < script.size(); ++k) {
        const CheckedFlip step = checked_flip(surface, script[k]);
        if (step.code) return Finding{k + 1, explain(surface, script[k], *step.code)};
        if (audit_every == 0 || (k + 1) % audit_every != 0) continue;
        if (auto finding = audit_after(k + 1)) return finding;
    }
    return audited == script.size() ? std::nullopt : audit_after(script.size());
}

std::optional<Finding> reference_model_agrees(const Triangulation& start,
                                              std::span<const Edge> script) {
    const Topology topology = audit(start).topology;
    Triangulation surface = start;
    ReferenceModel model(start);
    for (std::size_t k = 0; k < script.size(); ++k) {
        const Edge e = script[k];
        const bool allowed = static_cast<bool>(surface.can_flip(e));
        const bool flipped = static_cast<bool>(surface.flip(e));
        if (allowed != flipped || model.flip(e) != flipped) {
            return at_edge(k + 1, ViolationCode::reference_model_disagrees, e);
        }
        if (const auto edge = model.difference(surface)) {
            return at_edge(k + 1, ViolationCode::reference_model_disagrees, *edge);
        }
        AuditReport report =
            kernel::audit(model.gluing(), {.max_per_code = 1, .statistics = false});
        if (!report.is_valid()) return Finding{k + 1, std::move(report.violations.front())};
        std::vector<Violation> changed = changes(topology, report.topology);
        if (!changed.empty()) return Finding{k + 1, std::move(changed.front())};
    }
    return std::nullopt;
}

std::optional<Finding> flip_laws_hold(const Triangulation& start, std::span<const Edge> script) {
    Triangulation surface = start;
    FlipScript done;
    for (std::size_t k = 0; k < script.size(); ++k) {
        if (!laws_hold_at(surface, script[k])) {
            return at_edge(k + 1, ViolationCode::flip_law_broken, script[k]);
        }
        if (surface.flip(script[k])) done.push_back(script[k]);
    }
    for (std::size_t k = done.size(); k-- > 0;)
        static_cast<void>(surface.unflip(done[k]));
    if (surface != start) {
        return Finding{script.size(), {.code = ViolationCode::flip_law_broken}};
    }
    return std::nullopt;
}

std::optional<Finding> log_reproduces_run(const Triangulation& start,
                                          std::span<const Edge> script) {
    kernel::RecordedSurface recorded(start);
    for (const Edge e : script)
        static_cast<void>(recorded.flip(e));
    const auto survives = [&](auto&& write) {
        std::ostringstream out;
        write(out);
        const kernel::FlipLog log = kernel::parse_flip_log(out.str(), "log");
        const kernel::Replay replayed = replay(log);
        return log == recorded.log() && replayed.is_complete() &&
               replayed.surface == recorded.surface();
    };
    const auto all_survive = [&] {
        std::ostringstream text;
        write_text(text, recorded.surface());
        const auto reread = build(kernel::parse_surface(text.str(), "surface"));
        return survives([&](std::ostream& out) { write_text(out, recorded.log()); }) &&
               survives([&](std::ostream& out) { write_binary(out, recorded.log()); }) && reread &&
               reread.value() == recorded.surface();
    };
    const Finding not_reproduced{script.size(), {.code = ViolationCode::log_not_reproduced}};
    try {
        if (!all_survive()) return not_reproduced;
    } catch (const kernel::FileError&) {  // what was written cannot be read
        return not_reproduced;
    }
    return std::nullopt;
}

}  // namespace tightflip::properties
