// The core of tightflip::properties in a program without a test library: starts of every kind,
// random scripts, claims as checks, and what a claim that does not hold looks like.
#include <tightflip/properties/claims.hpp>
#include <tightflip/properties/failing_case.hpp>
#include <tightflip/properties/generators.hpp>

#include <iostream>

using namespace tightflip::properties;

/// What a claim of one's own may return: anything that `describe` can say.
struct LowDegree {
    std::size_t step;
};
std::string describe(const LowDegree& finding) {
    return "after flip " + std::to_string(finding.step) + " there is a vertex of degree 2";
}

/// A claim that is wrong: on a simple surface no flip leaves a vertex with degree 2.
std::optional<LowDegree> degrees_stay_above_two(const Triangulation& start,
                                                std::span<const Edge> script) {
    Triangulation surface = start;
    for (std::size_t step = 0; step < script.size(); ++step) {
        if (!surface.flip(script[step])) continue;
        if (audit(surface).degrees->min == 2) return LowDegree{step + 1};
    }
    return std::nullopt;
}

int main() {
    tightflip::kernel::RandomStream random(1);
    for (const StartKind& kind : start_kinds()) {
        const Triangulation start = make_nearest(kind, {.vertices = 20, .genus = 1, .seed = 1});
        const FlipScript script = random_script(start, 100, random);
        if (const auto failing = failing_case(reference_model_agrees, start, script)) {
            std::cout << kind.name << ": " << in_words(*failing);
            return 1;
        }
    }
    const Triangulation start = make_nearest(*find_start_kind("simple"), {.vertices = 8});
    const auto failing =
        failing_case(degrees_stay_above_two, start, random_script(start, 100, random));
    if (!failing) return 1;
    std::cout << in_words(*failing);
    return 0;
}
