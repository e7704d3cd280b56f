#include "targets/plantri.hpp"

#include "reading.hpp"
#include "targets.hpp"

#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

TEST(PlantriSeeds, AreReadAndRefusedForManyReasons) {
    std::size_t graphs = 0;
    std::set<std::string> reasons;
    for (const Seed& seed : plantri_target.seeds()) {
        std::istringstream in{std::string(as_text(seed.bytes))};
        kernel::PlantriReader reader(in, "graphs");
        try {
            while (reader.next())
                ++graphs;
        } catch (const kernel::FileError& error) {
            reasons.insert(error.reason());
        }
    }
    EXPECT_GE(graphs, 60U);
    EXPECT_GE(reasons.size(), 15U);
}

TEST(Plantri, HoldsForCodesCutAnywhereInEitherFormat) {
    for (const Seed& seed : plantri_target.seeds()) {
        if (seed.bytes.size() > 200) continue;
        for (std::size_t size = 0; size < seed.bytes.size(); size += 3) {
            for (const auto format :
                 {kernel::PlantriFormat::planar_code, kernel::PlantriFormat::edge_code})
                EXPECT_EQ(plantri_objection(as_text(seed.bytes).substr(0, size), format), "");
        }
    }
}

}  // namespace
}  // namespace tightflip::fuzz
