#include "targets/criterion_text.hpp"

#include "reading.hpp"
#include "targets.hpp"
#include <tightflip/geometry/composed_criteria.hpp>
#include <tightflip/kernel/families.hpp>

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

TEST(CriterionTextSeeds, AreReadWithEveryNumberOfLevelsAndRefused) {
    const std::vector<geometry::Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const geometry::Surface surface(kernel::families::tetrahedron(), points);
    std::set<std::size_t> levels;
    std::set<std::string> refusals;
    for (const Seed& seed : criterion_text_target.seeds()) {
        try {
            levels.insert(
                geometry::parse_criterion(as_text(seed.bytes), surface.view())->level_count());
        } catch (const std::invalid_argument& refusal) {
            refusals.insert(refusal.what());
        }
    }
    EXPECT_EQ(levels, (std::set<std::size_t>{1, 2, 3}));
    EXPECT_GE(refusals.size(), 15U);
}

TEST(CriterionText, HoldsForWeightsOfAnySize) {
    for (const char* const text :
         {"1e308*area", "1e308*area+1e308*tight", "-1e308*area+1e308*area", "4.9e-324*mean"})
        EXPECT_EQ(criterion_text_objection(text), "");
}

}  // namespace
}  // namespace tightflip::fuzz
