#include "criterion_text.hpp"

#include "reading.hpp"
#include "targets.hpp"
#include <tightflip/geometry/composed_criteria.hpp>
#include <tightflip/geometry/functional_surface.hpp>
#include <tightflip/geometry/strategy.hpp>
#include <tightflip/kernel/families.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <ostream>
#include <stdexcept>

namespace tightflip::fuzz {
namespace {

using geometry::Criterion;
using geometry::Energy;
using geometry::Surface;
using kernel::Edge;
using kernel::Vertex;

/// A surface that criteria are bound to.
struct Ground {
    Surface surface;
    Vertex marked;
};

std::vector<geometry::Point> seven_points() {
    return {{0, 0, 0}, {4, 0, 1}, {4, 3, 0}, {0, 3, 2}, {1, 1, 3}, {3, 2, 1}, {2, 1.5, -1}};
}

const std::array<Ground, 2>& grounds() {
    static const std::array<Ground, 2> both = [] {
        auto functional = geometry::functional_surface(seven_points()).value();
        return std::array<Ground, 2>{
            Ground{Surface(kernel::families::stacked(7, 1), seven_points()), Vertex{}},
            Ground{functional.surface, functional.marked}};
    }();
    return both;
}

/// Long texts take long without saying more.
constexpr std::size_t most_characters = 160;

std::unique_ptr<Criterion> parsed(std::string_view text, const Ground& ground) {
    return geometry::parse_criterion(text, ground.surface.view(), ground.marked);
}

bool are_near(double a, double b) {
    if (!std::isfinite(a) || !std::isfinite(b))
        return true;  // beyond doubles sums are not compared
    return std::abs(a - b) <= 1e-9 * (1 + std::abs(a) + std::abs(b));
}

/// Whether `levels` levels from `first` on are `factor` times those of `other`.
bool are_times(const Energy& energy, std::size_t first, const Energy& other, std::size_t levels,
               double factor) {
    for (std::size_t i = 0; i < levels; ++i) {
        if (!are_near(energy.levels.at(first + i), factor * other.levels.at(i))) return false;
    }
    return true;
}

/// Blanks at the ends change nothing, a sum with itself is the double, an order of itself and
/// itself has its levels twice.
std::string composing_is_right(std::string_view text, const Ground& ground) {
    const std::string plain(text);
    const auto criterion = parsed(text, ground);
    const Energy value = criterion->value();
    const std::size_t levels = criterion->level_count();
    if (levels < 1 || levels > Energy::max_levels) return "criteria_have_levels: " + plain;
    if (!are_times(parsed("  " + plain + "  ", ground)->value(), 0, value, levels, 1)) {
        return "blanks_mean_nothing: " + plain;
    }
    if (plain.find(',') == std::string::npos &&
        !are_times(parsed(plain + " + " + plain, ground)->value(), 0, value, levels, 2)) {
        return "sums_add_up: " + plain;
    }
    if (2 * levels <= Energy::max_levels) {
        const Energy ranked = parsed(plain + "," + plain, ground)->value();
        if (!are_times(ranked, 0, value, levels, 1) ||
            !are_times(ranked, levels, value, levels, 1)) {
            return "orders_keep_values: " + plain;
        }
    }
    return {};
}

/// What a flip is said to change is what it changes, in sums; orders may pass over small changes.
std::string changes_are_right(std::string_view text, const Ground& ground) {
    Surface surface = ground.surface;
    const auto criterion = geometry::parse_criterion(text, surface.view(), ground.marked);
    if (text.find(',') != std::string_view::npos) return {};
    for (Edge e{0}; e.id < surface.triangulation().edge_count(); ++e.id) {
        if (!surface.triangulation().can_flip(e)) continue;
        const Energy change = criterion->change(e);
        if (change.is_forbidden()) continue;
        const Energy before = criterion->value();
        static_cast<void>(surface.triangulation().flip(e));
        criterion->flipped(e);
        const Energy after = criterion->value();
        if (!are_near(after.first(), before.first() + change.first())) {
            return "changes_are_differences: " + std::string(text) + ", edge " +
                   std::to_string(e.id);
        }
        static_cast<void>(surface.triangulation().unflip(e));
        criterion->flipped(e);
    }
    return {};
}

std::string objection_on(std::string_view text, const Ground& ground) {
    try {
        static_cast<void>(parsed(text, ground));
    } catch (const std::invalid_argument& refusal) {
        return std::string_view(refusal.what()).empty() ? "refusals_have_a_reason: none"
                                                        : std::string();
    }
    if (auto wrong = composing_is_right(text, ground); !wrong.empty()) return wrong;
    return changes_are_right(text, ground);
}

constexpr std::array texts{
    "",
    " ",
    "tight",
    " tight ",
    "area+0.5*edge_length",
    "tight,mean",
    "tight,mean,area",
    "tight,mean,area,volume",
    "delaunay,tight",
    "delaunay,delaunay,tight",
    "2*tight",
    "0*tight+area",
    "-1*area",
    "1e300*area+1e300*area",
    "1e-300*area",
    "1e999*area",
    "inf*area",
    "nan*area",
    "+1*area",
    "2*",
    "2 tight",
    "tight+",
    "+tight",
    "tight,",
    ",tight",
    "tight mean",
    "tights",
    "Tight",
    "tight++mean",
    "2*3*area",
    "1e5*volume + -2.5e-3*abn_squares, 3*min_angle",
};

std::vector<Seed> seeds() {
    std::vector<Seed> seeds;
    for (std::size_t i = 0; i < texts.size(); ++i)
        seeds.push_back({"text_" + std::to_string(i), as_bytes(texts.at(i))});
    for (const geometry::CriterionInfo& one : geometry::all_criteria()) {
        const std::string name(one.name);
        seeds.push_back({"alone_" + name, as_bytes(name)});
        seeds.push_back({"weighted_" + name, as_bytes("0.25*" + name + "+tight")});
        seeds.push_back({"ranked_" + name, as_bytes(name + ",area")});
    }
    return seeds;
}

}  // namespace

std::string criterion_text_objection(std::string_view text) {
    text = text.substr(0, most_characters);
    for (const Ground& ground : grounds()) {
        if (auto wrong = objection_on(text, ground); !wrong.empty()) return wrong;
    }
    return {};
}

const Target criterion_text_target{
    .name = "criterion_text",
    .description =
        "text as a criterion: refused with a reason, or its values compose and its "
        "changes are differences",
    .layout = {},
    .objection = [](Input input) { return criterion_text_objection(as_text(input)); },
    .show = show_bytes,
    .seeds = seeds,
};

}  // namespace tightflip::fuzz
