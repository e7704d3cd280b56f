/// \file
/// Ways out of a local minimum: flips that do not improve, kept where others after them make good
/// for it.
#pragma once

#include "effort.hpp"
#include <tightflip/geometry/criterion.hpp>
#include <tightflip/kernel/random.hpp>

#include <array>
#include <deque>
#include <span>
#include <vector>

namespace tightflip::geometry {

/// Works on the surface that the criterion is bound to, and appends what it keeps to a log.
///
/// An attempt flips some edges, and then what improves near them; all is taken back unless it
/// improves in sum. Sums of changes are off by roundings, without bound where faces have no area.
/// So the energy is taken anew now and then, and where it has not fallen all since is taken back,
/// and that is the end.
class Escapes {
public:
    /// Energies are told to `effort` if the criterion is the wanted one.
    Escapes(Triangulation& surface, Points points, Criterion& criterion, bool is_wanted,
            const OptimiseOptions& options, Effort& effort, std::vector<Edge>& log);

    /// Attempts from each edge, and again from those near what was kept, until nothing is.
    void look_ahead();

    /// So many attempts from `size` random edges near one another.
    void kick(std::int64_t count, Index size, kernel::RandomStream& random);

    [[nodiscard]] std::int64_t evaluated() const noexcept { return evaluated_; }

private:
    /// The edges that wait, each once, first come, first served.
    class Queue {
    public:
        explicit Queue(Index edges) : waits_(static_cast<std::size_t>(edges), 0) {}
        void push(Edge e);
        [[nodiscard]] std::optional<Edge> pop();

    private:
        std::deque<Edge> edges_;
        std::vector<char> waits_;
    };

    void attempt(std::span<const Edge> forced);
    [[nodiscard]] std::optional<Energy> change(Edge e);
    [[nodiscard]] bool improves(const Energy& change) const;
    bool flip(Edge e, const Energy& change);
    void repair(Edge held);
    void take_back(std::size_t length);
    [[nodiscard]] bool may_go_on();
    void make_sure();

    Triangulation& surface_;
    Points points_;
    Criterion& criterion_;
    bool is_wanted_;
    const OptimiseOptions& options_;
    Effort& effort_;
    std::vector<Edge>& log_;
    std::vector<char> locked_;
    Queue untried_;
    Queue near_;
    std::vector<Edge> affected_;  // by the flips of an attempt
    std::array<double, Energy::max_levels> least_gain_{};
    Energy sum_;               // of the changes of an attempt
    Energy energy_;            // by changes
    Energy sure_;              // the energy taken anew, and
    std::size_t sure_length_;  // how long the log was then
    std::int64_t attempts_ = 0;
    std::int64_t evaluated_ = 0;
    bool goes_in_circles_ = false;
};

}  // namespace tightflip::geometry
