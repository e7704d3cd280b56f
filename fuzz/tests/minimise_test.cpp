#include "minimise.hpp"

#include <algorithm>
#include <csignal>
#include <ostream>
#include <stdexcept>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using ::testing::StartsWith;

Target stub(Layout layout, std::string (*objection)(Input)) {
    return {.name = "stub",
            .description = "a target with a made-up objection",
            .layout = layout,
            .objection = objection,
            .show = [](std::ostream& out, Input) { out << "an input\n"; },
            .seeds = [] { return std::vector<Seed>(); }};
}

constexpr Layout layout{.head = 3, .record = 2, .most_records = 20};

/// The records, as numbers of two bytes.
std::vector<unsigned> numbers(Input input) {
    std::vector<unsigned> found;
    for (std::size_t at = layout.head; at + 1 < input.size(); at += 2)
        found.push_back(input[at] + 256U * input[at + 1]);
    return found;
}

bool has(Input input, unsigned number) {
    const auto all = numbers(input);
    return std::ranges::find(all, number) != all.end();
}

TEST(Minimise, LeavesOutRecordsAndMakesBytesSmaller) {
    // Breaks where the head's last byte is at least 5 and a record of 7 modulo 24 comes somewhere
    // before one of at least 1000.
    const Target target = stub(layout, [](Input input) -> std::string {
        const auto all = numbers(input);
        const auto seven =
            std::ranges::find_if(all, [](unsigned number) { return number % 24 == 7; });
        const bool large =
            seven != all.end() && std::any_of(std::next(seven), all.end(),
                                              [](unsigned number) { return number >= 1000; });
        return input.size() > 2 && input[2] >= 5 && large ? "claim: details" : "";
    });
    const InputBytes input{1, 99, 200, 3, 0, 0x37, 0x45 /* 7 mod 24 */, 9, 9, 8, 8, 255, 255, 1, 1};
    ASSERT_EQ(objection(target, input), "claim: details");
    EXPECT_EQ(minimise(target, input), (InputBytes{1, 0, 5, 7, 0, 0, 4}));  // 1024
}

TEST(Minimise, NamesANumberThatCountsModuloByOneByte) {
    // 768 is 3 modulo 5; no smaller value of either of its bytes alone is.
    const Target target = stub(layout, [](Input input) -> std::string {
        const auto all = numbers(input);
        return !all.empty() && all.front() % 5 == 3 ? "claim: 3" : "";
    });
    EXPECT_EQ(minimise(target, InputBytes{1, 0, 0, 0, 3}), (InputBytes{1, 0, 0, 3, 0}));
}

TEST(Minimise, KeepsToTheSameClaim) {
    const Target target = stub(layout, [](Input input) -> std::string {
        if (has(input, 500)) return "second: " + std::to_string(input.size()) + " bytes";
        return numbers(input).empty() ? "first: no record" : "";
    });
    EXPECT_EQ(minimise(target, InputBytes{1, 9, 9, 4, 4, 500 % 256, 1, 6, 6}),
              (InputBytes{1, 0, 0, 500 % 256, 1}));
    EXPECT_EQ(minimise(target, InputBytes{1, 9, 9}), (InputBytes{1, 0, 0}));
}

TEST(Minimise, LeavesAnInputThatHoldsAlone) {
    const Target target = stub(layout, [](Input) { return std::string(); });
    EXPECT_EQ(minimise(target, InputBytes{1, 9}), (InputBytes{1, 9}));
}

TEST(Minimise, ShortensTextByLinesAndBytes) {
    const Target target = stub({}, [](Input input) -> std::string {
        const std::string text(input.begin(), input.end());
        return text.find('x') < text.rfind('y') && text.rfind('y') != std::string::npos ? "claim: x"
                                                                                        : "";
    });
    const std::string text = "first line\nan x here\nanother\n\nand a y there\nlast";
    EXPECT_EQ(minimise(target, InputBytes(text.begin(), text.end())), (InputBytes{'x', 'y'}));
}

TEST(Minimise, TakesCrashesToo) {
    const Target target = stub(layout, [](Input input) -> std::string {
        if (has(input, 3)) static_cast<void>(std::raise(SIGABRT));
        return {};
    });
    EXPECT_EQ(minimise(target, InputBytes{1, 5, 5, 1, 0, 3, 0, 2, 0}), (InputBytes{1, 0, 0, 3, 0}));
}

TEST(GuardedObjection, NamesExceptionsCrashesAndTime) {
    EXPECT_EQ(guarded_objection(stub(layout, [](Input) { return std::string("claim: x"); }), {}),
              "claim: x");
    EXPECT_EQ(guarded_objection(
                  stub(layout, [](Input) -> std::string { throw std::runtime_error("why"); }), {}),
              "exception: why");
    EXPECT_THAT(guarded_objection(stub(layout,
                                       [](Input) {
                                           static_cast<void>(std::raise(SIGSEGV));
                                           return std::string();
                                       }),
                                  {}),
                StartsWith("crash: "));
    EXPECT_THAT(guarded_objection(stub(layout,
                                       [](Input) -> std::string {
                                           while (true)
                                               pause();
                                       }),
                                  {}, 1),
                StartsWith("time: "));
}

}  // namespace
}  // namespace tightflip::fuzz
