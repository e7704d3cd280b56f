#include <tightflip/kernel/random.hpp>
#include <tightflip/properties/shrink.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace tightflip::properties {

void PrintTo(const FlipScript& script, std::ostream* out) {
    for (const Edge e : script)
        *out << e.id << ' ';
}

namespace {

using Predicate = std::function<bool(std::span<const Edge>)>;

FlipScript script_of(std::initializer_list<Index> ids) {
    FlipScript script;
    for (const Index id : ids)
        script.push_back({id});
    return script;
}

FlipScript random_ids(std::size_t length, std::uint32_t bound, std::uint64_t seed) {
    kernel::RandomStream random(seed);
    FlipScript script(length);
    for (Edge& e : script)
        e = {static_cast<Index>(random.below(bound))};
    return script;
}

bool is_subsequence(std::span<const Edge> part, std::span<const Edge> whole) {
    auto next = part.begin();
    for (const Edge e : whole) {
        if (next != part.end() && *next == e) ++next;
    }
    return next == part.end();
}

Predicate contains(FlipScript part) {
    return [part = std::move(part)](std::span<const Edge> s) { return is_subsequence(part, s); };
}

/// No single flip can be left out.
void expect_one_minimal(const FlipScript& script, const Predicate& fails) {
    EXPECT_TRUE(fails(script));
    for (std::size_t k = 0; k < script.size(); ++k) {
        FlipScript shorter = script;
        shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(k));
        EXPECT_FALSE(fails(shorter)) << "without flip " << k;
    }
}

struct Counted {
    Predicate fails;
    std::size_t calls = 0;
    bool operator()(std::span<const Edge> s) {
        ++calls;
        return fails(s);
    }
};

TEST(Shrink, LeavesExactlyTheFlipsThatAreNeededInTheirOrder) {
    for (const FlipScript& needed : {script_of({5}), script_of({5, 5}), script_of({3, 1, 4}),
                                     script_of({0, 1, 2, 3, 4, 5}), script_of({19, 0, 19, 0})}) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const FlipScript script = random_ids(400, 20, seed);
            ASSERT_TRUE(contains(needed)(script)) << "seed " << seed;
            EXPECT_EQ(shrink(script, contains(needed)), needed) << "seed " << seed;
        }
    }
}

TEST(Shrink, IsOneMinimalWhateverThePredicate) {
    const auto sum = [](std::span<const Edge> s) {
        Index total = 0;
        for (const Edge e : s)
            total += e.id;
        return total;
    };
    const std::vector<std::pair<const char*, Predicate>> predicates{
        {"sum divisible by 7", [&](auto s) { return !s.empty() && sum(s) % 7 == 0; }},
        {"odd length and odd sum", [&](auto s) { return s.size() % 2 == 1 && sum(s) % 2 == 1; }},
        {"at least 10 flips", [](auto s) { return s.size() >= 10; }},
        {"a flip repeated at once",
         [](auto s) { return std::ranges::adjacent_find(s) != s.end(); }},
        {"a descent after an ascent",
         [](auto s) {
             for (std::size_t k = 0; k + 2 < s.size(); ++k) {
                 if (s[k] < s[k + 1] && s[k + 2] < s[k + 1]) return true;
             }
             return false;
         }},
        {"length a multiple of 5, or more than 30",
         [](auto s) { return s.size() > 30 || (!s.empty() && s.size() % 5 == 0); }},
    };
    for (const auto& [name, fails] : predicates) {
        SCOPED_TRACE(name);
        int tried = 0;
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            const FlipScript script = random_ids(20 + seed, 9, seed);
            if (!fails(script)) continue;
            ++tried;
            const FlipScript small = shrink(script, fails);
            EXPECT_TRUE(is_subsequence(small, script));
            expect_one_minimal(small, fails);
            EXPECT_EQ(shrink(script, fails), small) << "not deterministic";
        }
        EXPECT_GT(tried, 0);
    }
}

// The second flip can go once the first is gone, and passes run from the end.
TEST(Shrink, GoesOnForAsLongAsSomethingGoes) {
    const auto fails = [](std::span<const Edge> s) {
        const auto has = [&](Index id) { return std::ranges::find(s, Edge{id}) != s.end(); };
        return has(3) && (!has(1) || has(2));
    };
    EXPECT_EQ(shrink(script_of({1, 2, 3}), fails), script_of({3}));
}

TEST(Shrink, CutsAFailureThatNeedsNoFlipToNone) {
    const auto always = [](std::span<const Edge>) { return true; };
    EXPECT_TRUE(shrink({}, always).empty());
    EXPECT_TRUE(shrink(script_of({4}), always).empty());
    EXPECT_TRUE(shrink(random_ids(1000, 9, 1), always).empty());
}

TEST(Shrink, StopsAtTheCallLimitWithAScriptThatStillFails) {
    const FlipScript script = random_ids(300, 20, 8);
    const Predicate fails = contains(script_of({3, 1, 4, 1, 5, 9, 2, 6}));
    std::size_t last = script.size();
    for (const std::size_t limit : {0, 1, 5, 20, 60, 100, 10000}) {
        Counted counted{fails};
        const FlipScript small = shrink(script, std::ref(counted), limit);
        EXPECT_LE(counted.calls, limit);
        EXPECT_TRUE(fails(small));
        EXPECT_LE(small.size(), last) << "more calls, longer script";
        last = small.size();
    }
    EXPECT_EQ(shrink(script, fails, 0), script);
    EXPECT_EQ(last, 8U);
}

TEST(Shrink, NeedsFewCallsOnLongScriptsWithFewCulprits) {
    FlipScript script(100'000, Edge{0});
    for (const std::size_t place : {777U, 50'000U, 91'234U})
        script[place] = {1};
    Counted counted{contains(script_of({1, 1, 1}))};
    EXPECT_EQ(shrink(script, std::ref(counted)), script_of({1, 1, 1}));
    EXPECT_LT(counted.calls, 500U);
}

}  // namespace
}  // namespace tightflip::properties
