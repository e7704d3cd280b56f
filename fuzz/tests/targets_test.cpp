// What every target in the table keeps.

#include "targets.hpp"

#include "mutate.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

TEST(Targets, AreInTheOrderOfTheirNames) {
    EXPECT_TRUE(std::ranges::is_sorted(targets(), std::less<>(), &Target::name));
}

TEST(Targets, HaveTheSameSeedsEachTimeUnderDifferentNames) {
    for (const Target& target : targets()) {
        const auto seeds = target.seeds();
        const auto again = target.seeds();
        EXPECT_GE(seeds.size(), 3U) << target.name;
        EXPECT_TRUE(std::ranges::equal(seeds, again, [](const Seed& a, const Seed& b) {
            return a.name == b.name && a.bytes == b.bytes;
        })) << target.name;
        std::set<std::string> names;
        for (const Seed& seed : seeds) {
            EXPECT_TRUE(names.insert(seed.name).second) << target.name << ": " << seed.name;
            EXPECT_EQ(seed.name.find_first_of("/ \n"), std::string::npos) << seed.name;
            EXPECT_TRUE(is_of_this_version(target.layout, seed.bytes)) << seed.name;
        }
    }
}

TEST(Targets, ShowTheirSeedsInWords) {
    for (const Target& target : targets()) {
        const Seed seed = target.seeds().front();
        std::ostringstream words;
        target.show(words, seed.bytes);
        EXPECT_NE(words.str(), "") << target.name << ": " << seed.name;
    }
}

TEST(Targets, TakeAnyBytes) {
    for (const Target& target : targets()) {
        if (target.layout.is_text()) continue;
        for (const InputBytes& bytes :
             {InputBytes{}, InputBytes{format_version}, InputBytes(3, 255)}) {
            EXPECT_EQ(objection(target, bytes), "") << target.name;
        }
    }
}

TEST(Objection, NamesItsClaim) {
    EXPECT_EQ(claim_of("topology: after flip 3: broken"), "topology");
    EXPECT_EQ(claim_of("nothing more"), "nothing more");
    EXPECT_EQ(claim_of(""), "");
}

TEST(Version, IsTheFirstByteBehindWhichTextHasNone) {
    const Layout binary{.head = 1, .record = 1, .most_records = 1};
    EXPECT_TRUE(is_of_this_version(binary, InputBytes{format_version, 9}));
    EXPECT_FALSE(is_of_this_version(binary, InputBytes{format_version + 1}));
    EXPECT_FALSE(is_of_this_version(binary, {}));
    EXPECT_TRUE(is_of_this_version({}, {}));
}

}  // namespace
}  // namespace tightflip::fuzz
