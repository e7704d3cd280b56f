#include "mutate.hpp"

#include "script_input.hpp"
#include "targets.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

constexpr Layout layout{.head = 3, .record = 2, .most_records = 5};
const InputBytes input{1, 10, 20, /* records */ 1, 1, 2, 2, 3, 3};

/// A whole head of this version, whole records, no more than fit.
void expect_valid(const Layout& of, Input made, std::size_t most_bytes) {
    ASSERT_FALSE(made.empty());
    EXPECT_EQ(made.front(), format_version);
    EXPECT_LE(made.size(), std::min(of.most_bytes(), most_bytes));
    if (most_bytes < of.head) return;
    ASSERT_GE(made.size(), of.head);
    const std::size_t records = made.size() - of.head;
    EXPECT_EQ(of.record == 0 ? records : records % of.record, 0U);
}

/// Stands in for a fuzzer: fills up with the byte 7, the version included.
std::size_t fill(std::uint8_t* data, std::size_t /*size*/, std::size_t most) {
    std::fill_n(data, most, std::uint8_t{7});
    return most;
}

std::size_t leave_nothing(std::uint8_t* /*data*/, std::size_t /*size*/, std::size_t /*most*/) {
    return 0;
}

TEST(Mutate, KeepsInputsValidAndWithinLimits) {
    const std::vector<InputBytes> inputs{
        {}, {1}, {9, 9}, {1, 2, 3}, input, {1, 2, 3, 4}, InputBytes(100, 255)};
    for (const Layout& of : {layout, script_layout, Layout{2, 3, 1}, Layout{4, 0, 0}}) {
        for (const InputBytes& from : inputs) {
            for (const std::size_t most_bytes : {1U, 2U, 3U, 4U, 8U, 13U, 4096U}) {
                for (std::uint64_t seed = 0; seed < 60; ++seed) {
                    for (const ByteMutator bytes : {ByteMutator{nullptr}, &fill, &leave_nothing})
                        expect_valid(of, mutate(of, from, most_bytes, seed, bytes), most_bytes);
                    for (const InputBytes& other : inputs)
                        expect_valid(of, cross_over(of, from, other, most_bytes, seed), most_bytes);
                }
            }
        }
    }
}

TEST(Mutate, IsTheSameForTheSameSeed) {
    std::set<InputBytes> made;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        EXPECT_EQ(mutate(layout, input, 100, seed), mutate(layout, input, 100, seed));
        EXPECT_EQ(cross_over(layout, input, made.empty() ? input : *made.begin(), 100, seed),
                  cross_over(layout, input, made.empty() ? input : *made.begin(), 100, seed));
        made.insert(mutate(layout, input, 100, seed));
    }
    EXPECT_GT(made.size(), 100U);
}

using Records = std::vector<InputBytes>;

Records records_in(const InputBytes& made) {
    Records records;
    for (std::size_t at = layout.head; at < made.size(); at += layout.record)
        records.emplace_back(made.begin() + static_cast<std::ptrdiff_t>(at),
                             made.begin() + static_cast<std::ptrdiff_t>(at + layout.record));
    return records;
}

/// What happened to an input, as far as it shows.
std::string kind_of_change(const InputBytes& made) {
    if (made == input) return "none";
    const Records before = records_in(input);
    const Records after = records_in(made);
    const bool same_head = std::equal(made.begin(), made.begin() + 3, input.begin());
    if (!same_head) return after == before ? "head" : "head and records";
    if (after.size() < before.size()) return "shorter";
    if (after.size() > before.size()) {
        const bool all_old = std::ranges::all_of(after, [&](const InputBytes& record) {
            return std::ranges::find(before, record) != before.end();
        });
        return all_old ? "doubled" : "longer";
    }
    return std::ranges::is_permutation(after, before) ? "exchanged" : "record";
}

TEST(Mutate, DoesEverythingToRecordsAndOneThingAtATime) {
    std::map<std::string, int> seen;
    for (std::uint64_t seed = 0; seed < 1000; ++seed)
        ++seen[kind_of_change(mutate(layout, input, 100, seed))];
    for (const char* kind : {"head", "shorter", "doubled", "longer", "exchanged", "record"})
        EXPECT_GT(seen[kind], 40) << kind;
    EXPECT_EQ(seen["head and records"], 0);
    EXPECT_LT(seen["none"], 20);
}

TEST(Mutate, LeavesEveryEighthInputToTheFuzzer) {
    int filled = 0;
    for (std::uint64_t seed = 0; seed < 800; ++seed) {
        const InputBytes made = mutate(layout, input, 100, seed, fill);
        filled += made == InputBytes{1, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7} ? 1 : 0;
    }
    EXPECT_GT(filled, 60);
    EXPECT_LT(filled, 140);
}

TEST(Mutate, LeavesTextToTheFuzzer) {
    const InputBytes text{'a', '\n'};
    EXPECT_EQ(mutate({}, text, 5, 1, fill), InputBytes(5, 7));
    EXPECT_EQ(mutate({}, text, 5, 1), text);
    EXPECT_EQ(cross_over({}, text, text, 5, 1), InputBytes());
}

TEST(CrossOver, JoinsTheFirstRecordsOfOneToTheLastOfTheOther) {
    const InputBytes other{1, 30, 40, 4, 4, 5, 5};
    std::set<InputBytes> heads;
    std::set<Records> made;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const InputBytes crossed = cross_over(layout, input, other, 100, seed);
        heads.insert(InputBytes(crossed.begin(), crossed.begin() + 3));
        made.insert(records_in(crossed));
    }
    EXPECT_EQ(heads, (std::set<InputBytes>{{1, 10, 20}, {1, 30, 40}}));
    EXPECT_TRUE(made.contains(Records{{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}}));
    EXPECT_TRUE(made.contains(Records{{1, 1}, {5, 5}}));
    EXPECT_TRUE(made.contains(Records{}));
    EXPECT_EQ(made.size(), 12U);  // 0 to 3 of the one, 0 to 2 of the other
}

}  // namespace
}  // namespace tightflip::fuzz
