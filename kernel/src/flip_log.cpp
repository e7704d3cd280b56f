#include <tightflip/kernel/flip_log.hpp>

#include <stdexcept>

namespace tightflip::kernel {

Replay replay(const FlipLog& log) {
    Replay result{.surface = log.start, .done = 0, .reason = {}};
    for (const Edge e : log.flips) {
        if (e.id < 0 || e.id >= log.start.edge_count()) {
            result.reason = "edge " + std::to_string(e.id) + " does not exist: the surface has " +
                            std::to_string(log.start.edge_count()) + " of them, numbered from 0";
            break;
        }
        if (const FlipVerdict verdict = result.surface.flip(e); !verdict) {
            result.reason = "edge " + std::to_string(e.id) +
                            " cannot be flipped: " + std::string(describe(verdict.refusal()));
            break;
        }
        ++result.done;
    }
    return result;
}

RecordedSurface::RecordedSurface(FlipLog log) : log_(std::move(log)), surface_(log_.start) {
    Replay replayed = replay(log_);
    if (!replayed.is_complete()) {
        throw std::invalid_argument("flip " + std::to_string(replayed.done) +
                                    " of the log: " + replayed.reason);
    }
    surface_ = std::move(replayed.surface);
}

FlipVerdict RecordedSurface::flip(Edge e) {
    const FlipVerdict verdict = surface_.flip(e);
    if (verdict) log_.flips.push_back(e);
    return verdict;
}

bool RecordedSurface::undo() {
    if (log_.flips.empty()) return false;
    static_cast<void>(surface_.unflip(log_.flips.back()));
    log_.flips.pop_back();
    return true;
}

}  // namespace tightflip::kernel
