#include "flip_script.hpp"

#include <tightflip/properties/claims.hpp>

#include <array>
#include <span>

namespace tightflip::fuzz {
namespace {

using properties::Edge;
using properties::Finding;
using properties::Triangulation;

struct NamedClaim {
    std::string_view name;
    std::optional<Finding> (*check)(const Triangulation&, std::span<const Edge>);
};

constexpr std::array claims{
    NamedClaim{"topology_is_preserved",
               [](const Triangulation& start, std::span<const Edge> script) {
                   return properties::topology_is_preserved(start, script);
               }},
    NamedClaim{"reference_model_agrees", properties::reference_model_agrees},
    NamedClaim{"flip_laws_hold", properties::flip_laws_hold},
    NamedClaim{"log_reproduces_run", properties::log_reproduces_run},
};

}  // namespace

std::optional<BrokenClaim> first_broken_claim(const kernel::FlipLog& log) {
    for (const auto& [name, check] : claims) {
        if (auto finding = check(log.start, log.flips)) return BrokenClaim{name, *finding};
    }
    return std::nullopt;
}

}  // namespace tightflip::fuzz
