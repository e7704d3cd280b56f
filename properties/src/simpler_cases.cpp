#include <tightflip/properties/simpler_cases.hpp>
#include <tightflip/properties/simpler_points.hpp>

#include <algorithm>

namespace tightflip::properties {
namespace {

/// Smaller numbers down to `least`, the smallest first.
template <class Number>
std::vector<Number> smaller(Number number, Number least) {
    std::vector<Number> found;
    for (Number step = number > least ? number - least : 0; step > 0; step /= 2)
        found.push_back(number - step);
    return found;
}

/// The case itself, its size and picks said as they are used.
FlipCase as_used(const FlipCase& flip_case) {
    FlipCase used = flip_case;
    const kernel::FlipLog log = flip_case.log();
    used.request.vertices = log.start.vertex_count();
    if (!used.kind->any_genus) used.request.genus = 0;
    std::ranges::transform(log.flips, used.picks.begin(),
                           [](Edge e) { return static_cast<std::uint32_t>(e.id); });
    return used;
}

void append_shorter_scripts(const FlipCase& flip_case, std::vector<FlipCase>& simpler) {
    const auto count = static_cast<std::ptrdiff_t>(flip_case.picks.size());
    for (std::ptrdiff_t block = count; block > 0; block /= 2) {
        for (std::ptrdiff_t begin = 0; begin < count; begin += block) {
            FlipCase shorter = flip_case;
            const auto first = shorter.picks.begin() + begin;
            shorter.picks.erase(first, first + std::min(block, count - begin));
            simpler.push_back(std::move(shorter));
        }
    }
}

}  // namespace

std::vector<FlipCase> simpler_cases(const FlipCase& flip_case) {
    const FlipCase used = as_used(flip_case);
    std::vector<FlipCase> simpler;
    for (const StartKind* kind = start_kinds().data(); kind < used.kind; ++kind) {
        simpler.push_back(used);
        simpler.back().kind = kind;
    }
    const auto lower = [&](auto StartRequest::*member, auto least) {
        for (const auto number : smaller(used.request.*member, least)) {
            simpler.push_back(used);
            simpler.back().request.*member = number;
        }
    };
    lower(&StartRequest::genus, Index{0});
    lower(&StartRequest::vertices, used.kind->least_vertices(used.request.genus));
    lower(&StartRequest::seed, std::uint64_t{0});
    append_shorter_scripts(used, simpler);
    for (std::size_t i = 0; i < used.picks.size(); ++i) {
        for (const std::uint32_t pick : smaller(used.picks[i], 0U)) {
            simpler.push_back(used);
            simpler.back().picks[i] = pick;
        }
    }
    return simpler;
}

std::vector<SurfaceCase> simpler_cases(const SurfaceCase& surface_case) {
    std::vector<SurfaceCase> simpler;
    for (FlipCase& flips : simpler_cases(surface_case.flips)) {
        simpler.push_back(surface_case);
        simpler.back().flips = std::move(flips);
    }
    for (std::vector<geometry::Point>& points : simpler_points(surface_case.start().points())) {
        simpler.push_back(surface_case);
        simpler.back().points = std::move(points);
    }
    return simpler;
}

}  // namespace tightflip::properties
