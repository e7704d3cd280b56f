#include "reading.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::fuzz {
namespace {

using kernel::FileError;
using ::testing::StartsWith;

std::string shown(const InputBytes& bytes) {
    return written([&](std::ostream& out) { show_bytes(out, bytes); });
}

TEST(ReadingAttempt, KeepsTheValueOrTheRefusal) {
    const auto read = attempt("x", [] { return 7; });
    EXPECT_EQ(read.value, 7);
    EXPECT_EQ(read.refusal + read.objection, "");
    const auto refused =
        attempt("x\ny", []() -> int { throw FileError("f", FileError::Unit::line, 2, "bad"); });
    EXPECT_FALSE(refused.value);
    EXPECT_EQ(refused.refusal, "f:2: bad");
    EXPECT_EQ(refused.objection, "");
}

TEST(ReadingAttempt, ObjectsToMemoryBeyondTheBytes) {
    const auto read = attempt("x", [] { return std::string(1 << 20, 'x').size(); });
    EXPECT_THAT(read.objection, StartsWith("memory_is_worth_the_bytes"));
}

TEST(ReadingAttempt, LeavesOtherExceptionsToTheCaller) {
    EXPECT_THROW(
        static_cast<void>(attempt("x", []() -> int { throw std::out_of_range("vector"); })),
        std::out_of_range);
}

TEST(Refusal, NeedsAReasonAndAPlaceThatExists) {
    const std::string text = "one\ntwo\n";  // three lines, the last one empty; bytes 0 to 8
    const auto line = [&](std::uint64_t at) {
        return objection_to_refusal(FileError("f", FileError::Unit::line, at, "bad"), text);
    };
    const auto byte = [&](std::uint64_t at) {
        return objection_to_refusal(FileError("f", FileError::Unit::byte, at, "bad"), text);
    };
    EXPECT_EQ(line(3), "");
    EXPECT_THAT(line(4), StartsWith("refusals_name_a_place_that_exists: f:4"));
    EXPECT_EQ(byte(8), "");
    EXPECT_THAT(byte(9), StartsWith("refusals_name_a_place_that_exists"));
    EXPECT_THAT(objection_to_refusal(FileError("f", FileError::Unit::line, 1, ""), text),
                StartsWith("refusals_have_a_reason"));
}

TEST(Refusal, OfAWholeFileMayLackThePlaceForReasonsNamed) {
    constexpr std::array<std::string_view, 2> reasons{"the file is empty", "the file has no faces"};
    EXPECT_EQ(objection_to_refusal(FileError("f", "the file has no faces, none"), "x", reasons),
              "");
    EXPECT_THAT(objection_to_refusal(FileError("f", "bad"), "x", reasons),
                StartsWith("refusals_have_a_place"));
    EXPECT_THAT(objection_to_refusal(FileError("f", "the file is empty"), "x"),
                StartsWith("refusals_have_a_place"));
}

TEST(ShowBytes, ShowsTextAsLinesAndAnythingElseInRows) {
    EXPECT_EQ(shown({}), "no bytes\n");
    EXPECT_EQ(shown(as_bytes("a\tb\\\r\nc")), "a\\tb\\\\\\r\nc\\ (no line end)\n");
    EXPECT_EQ(shown({'a', 0, 255}), "00000000  61 00 ff" + std::string(39, ' ') + "  a..\n");
    const std::string rows = shown(InputBytes(17, 0));
    EXPECT_THAT(rows, ::testing::HasSubstr("\n00000010  00"));
}

TEST(Bytes, AreTextAndBack) {
    const std::string text("\x89\0z", 3);
    EXPECT_EQ(as_text(as_bytes(text)), text);
}

}  // namespace
}  // namespace tightflip::fuzz
