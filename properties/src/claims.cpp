#include <tightflip/kernel/file_error.hpp>
#include <tightflip/kernel/flip_log.hpp>
#include <tightflip/kernel/surface_text.hpp>
#include <tightflip/properties/claims.hpp>
#include <tightflip/properties/invariants.hpp>
#include <tightflip/properties/reference_model.hpp>

#include <cstring>
#include <sstream>
#include <type_traits>

namespace tightflip::properties {
namespace {

Finding at_edge(std::size_t step, ViolationCode code, Edge e) {
    return {step, {.code = code, .kind = kernel::PlaceKind::edge, .place = e.id}};
}

/// Whether the same handles mean the same, as operator== finds out record by record; much is
/// compared here.
bool same_tables(const Triangulation& a, const Triangulation& b) {
    static_assert(std::has_unique_object_representations_v<kernel::HalfedgeRecord>);
    const auto left = std::as_bytes(a.table());
    const auto right = std::as_bytes(b.table());
    return a.vertex_count() == b.vertex_count() && left.size() == right.size() &&
           std::memcmp(left.data(), right.data(), left.size()) == 0;
}

/// Whether `b` is `a` with the two halfedges of `e` renamed into each other.
bool halves_are_exchanged(const Triangulation& a, const Triangulation& b, Edge e) {
    const auto renamed = [&](kernel::Halfedge h) { return edge_of(h) == e ? twin(h) : h; };
    for (Index id = 0; id < a.halfedge_count(); ++id) {
        const kernel::Halfedge h{id};
        const auto& [next, origin] = at(a.table(), h);
        if (at(b.table(), renamed(h)) != kernel::HalfedgeRecord{renamed(next), origin})
            return false;
    }
    return true;
}

/// Flips a copy of the surface to and fro, which is the surface again where the laws hold.
bool laws_hold_at(const Triangulation& surface, Edge e, Triangulation& copy) {
    if (!copy.flip(e)) {
        return same_tables(copy, surface) && !copy.unflip(e) && same_tables(copy, surface);
    }
    bool holds = static_cast<bool>(copy.unflip(e)) && same_tables(copy, surface);
    holds = holds && copy.unflip(e) && copy.flip(e) && same_tables(copy, surface);
    holds = holds && copy.flip(e) && copy.flip(e);
    holds = holds && halves_are_exchanged(surface, copy, e);
    return holds && copy.flip(e) && copy.flip(e) && same_tables(copy, surface);
}

/// Of a start; without statistics, which cost much more.
Topology topology_of(const Triangulation& surface) {
    return audit(surface, {.max_per_code = 1, .statistics = false}).topology;
}

}  // namespace

std::optional<Finding> topology_is_preserved(const Triangulation& start,
                                             std::span<const Edge> script,
                                             std::size_t audit_every) {
    const Topology topology = topology_of(start);
    Triangulation surface = start;
    const auto audit_after = [&](std::size_t step, auto judge) -> std::optional<Finding> {
        auto violation = judge(surface, topology);
        if (!violation) return std::nullopt;
        return Finding{step, *std::move(violation)};
    };
    for (std::size_t k = 0; k < script.size(); ++k) {
        const CheckedFlip step = checked_flip(surface, script[k]);
        if (step.code) return Finding{k + 1, explain(surface, script[k], *step.code)};
        if (audit_every == 0 || (k + 1) % audit_every != 0) continue;
        if (auto finding = audit_after(k + 1, first_violation_quickly)) return finding;
    }
    return audit_after(script.size(), first_violation);
}

std::optional<Finding> reference_model_agrees(const Triangulation& start,
                                              std::span<const Edge> script) {
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
    }
    return std::nullopt;
}

std::optional<Finding> flip_laws_hold(const Triangulation& start, std::span<const Edge> script) {
    Triangulation surface = start;
    Triangulation copy = start;
    FlipScript done;
    done.reserve(script.size());
    for (std::size_t k = 0; k < script.size(); ++k) {
        if (!laws_hold_at(surface, script[k], copy)) {
            return at_edge(k + 1, ViolationCode::flip_law_broken, script[k]);
        }
        if (!surface.flip(script[k])) continue;
        static_cast<void>(copy.flip(script[k]));
        done.push_back(script[k]);
    }
    for (std::size_t k = done.size(); k-- > 0;)
        static_cast<void>(surface.unflip(done[k]));
    if (!same_tables(surface, start)) {
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
