#include "optimise_course.hpp"

#include "interrupt.hpp"
#include "progress.hpp"
#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/file_io.hpp>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include <fmt/format.h>

namespace tightflip::tools {
namespace {

using kernel::Edge;

/// Every one of small surfaces; of larger ones so few that the energies, each taken from scratch,
/// cost seconds in all.
std::int64_t flips_between_traces(const kernel::Triangulation& surface) {
    const std::int64_t vertices = surface.vertex_count();
    return std::max<std::int64_t>(1, vertices * vertices / 100'000);
}

Course begin(const OptimiseRequest& request) {
    const SurfaceInput input(request.file, request.input);
    Course course{input.surface(), {}, input.surface(), {}};
    if (request.resume.empty()) return course;
    kernel::FlipLog log = kernel::parse_flip_log(kernel::read_file(request.resume), request.resume);
    if (log.start != course.start.triangulation()) {
        throw kernel::FileError(request.resume, "this log starts from another surface than " +
                                                    request.file +
                                                    " (or one numbered differently)");
    }
    kernel::Replay replayed = replay(log);
    if (!replayed.is_complete()) {
        throw kernel::FileError(request.resume, fmt::format("flip {} of {}: {}", replayed.done + 1,
                                                            log.flips.size(), replayed.reason));
    }
    course.flips = std::move(log.flips);
    course.surface.triangulation() = std::move(replayed.surface);
    return course;
}

class Run {
public:
    Run(const OptimiseRequest& request, Course& course) : request_(request), course_(course) {}

    void part(geometry::Strategy strategy, const std::string& criterion) {
        const geometry::Goal goal = geometry::goal_by_text(criterion, marked());
        CoursePart part{criterion, {}, goal.make(course_.surface.view())->level_count()};
        const auto flips_before = static_cast<std::int64_t>(course_.flips.size());
        part.result = optimise_by(strategy, course_.surface.triangulation(),
                                  course_.surface.points(), goal, limits(flips_before));
        if (part.result.refusal.fault != geometry::StrategyFault::none) {
            throw std::invalid_argument(message(part.result.refusal));
        }
        for (geometry::EnergyAt& at : part.result.trace)
            at.flips += flips_before;
        course_.flips.insert(course_.flips.end(), part.result.flips.begin(),
                             part.result.flips.end());
        course_.parts.push_back(std::move(part));
        course_.seconds = seconds();
    }

private:
    [[nodiscard]] geometry::Vertex marked() const {
        if (!request_.marked) return {};
        if (*request_.marked >= course_.start.triangulation().vertex_count()) {
            throw std::invalid_argument(
                fmt::format("there is no vertex {} to be --marked", *request_.marked));
        }
        return {*request_.marked};
    }
    [[nodiscard]] Edge existing(Edge e) const {
        const kernel::Index edges = course_.start.triangulation().edge_count();
        if (e.id < edges) return e;
        throw std::invalid_argument(fmt::format(
            "there is no edge {} to --lock: the surface has {}, numbered from 0", e.id, edges));
    }
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(Clock::now() - begin_).count();
    }
    geometry::OptimiseOptions limits(std::int64_t flips_before) {
        geometry::OptimiseOptions limits = request_.search;
        locked_.clear();
        for (const kernel::Index e : request_.locked)
            locked_.push_back(existing(Edge{e}));
        limits.locked = locked_;
        if (request_.seconds) {
            limits.max_time = std::chrono::duration<double>(*request_.seconds - seconds());
        }
        if (!request_.trace.empty() || !request_.report.empty()) {
            limits.trace_every = flips_between_traces(course_.start.triangulation());
        }
        limits.keep_going = [this, flips_before](std::int64_t flips,
                                                 const geometry::Energy& energy) {
            constexpr std::int64_t flips_between_looks = 64;
            if (flips % flips_between_looks != 0) return true;
            bar_.show({.done = static_cast<std::uint64_t>(flips_before + flips),
                       .seconds = seconds(),
                       .note = fmt::format("energy {:.9g}", energy.first())});
            return !was_interrupted();
        };
        return limits;
    }

    using Clock = std::chrono::steady_clock;

    const OptimiseRequest& request_;
    Course& course_;
    std::vector<Edge> locked_;
    Clock::time_point begin_ = Clock::now();
    ProgressBar bar_{request_.file};
};

}  // namespace

Course run_course(const OptimiseRequest& request) {
    Course course = begin(request);
    {
        Run run(request, course);
        run.part(request.strategy, request.criterion);
        if (!request.then.empty() && course.end() == geometry::OptimiseEnd::local_minimum) {
            run.part(geometry::Strategy::local, request.then);
        }
    }
    if (!audit(course.surface.triangulation()).is_valid()) {
        throw std::logic_error("the surface does not pass the audit after its flips");
    }
    return course;
}

}  // namespace tightflip::tools
