#include "mesh_text_cursor.hpp"

#include <tightflip/kernel/file_error.hpp>

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::geometry {
namespace {

/// Every line that has tokens as "line: token|token|".
std::vector<std::string> lines_of(std::string_view text, LineSyntax syntax = {}) {
    std::vector<std::string> lines;
    MeshTextCursor cursor(text, "text", syntax);
    while (cursor.next_line()) {
        std::string line = std::to_string(cursor.line()) + ":";
        for (auto token = cursor.token(); !token.empty(); token = cursor.token()) {
            line += " " + std::string(token);
        }
        lines.push_back(line);
    }
    return lines;
}

using testing::ElementsAre;
using testing::IsEmpty;

TEST(MeshTextCursor, CountsLinesWhateverTheirEnds) {
    EXPECT_THAT(lines_of("a b\n\n \t\nc\n"), ElementsAre("1: a b", "4: c"));
    EXPECT_THAT(lines_of("\r\na\r\n\r\nb"), ElementsAre("2: a", "4: b"));
    EXPECT_THAT(lines_of(""), IsEmpty());
    EXPECT_THAT(lines_of("\n \n\r\n"), IsEmpty());
}

TEST(MeshTextCursor, LeavesOutCommentsOnlyWhereThereAreSome) {
    EXPECT_THAT(lines_of("#x\na#b\n", {.comment = '#'}), ElementsAre("2: a"));
    EXPECT_THAT(lines_of("#x\na#b\n"), ElementsAre("1: #x", "2: a#b"));
}

TEST(MeshTextCursor, JoinsLinesOnlyWhereTheFormatDoes) {
    const LineSyntax continued{.comment = '#', .continued_lines = true};
    EXPECT_THAT(lines_of("a\\\nb\\\r\n\\\nc\nd \\e\\", continued),
                ElementsAre("1: a b c", "5: d \\e\\"));
    EXPECT_THAT(lines_of("a #x\\\nb\n", continued), ElementsAre("1: a", "2: b"));
    EXPECT_THAT(lines_of("a\\\nb\n"), ElementsAre("1: a\\", "2: b"));
}

TEST(MeshTextCursor, SkipsTheRestOfAContinuedLineUnread) {
    MeshTextCursor cursor("a \\\nb \\\nc\nd\n", "text", {.continued_lines = true});
    ASSERT_TRUE(cursor.next_line());
    ASSERT_TRUE(cursor.next_line());
    EXPECT_EQ(cursor.token(), "d");
    EXPECT_EQ(cursor.line(), 4U);
}

TEST(MeshTextCursor, PeeksWithoutTaking) {
    MeshTextCursor cursor("one two\n", "text");
    ASSERT_TRUE(cursor.next_line());
    EXPECT_EQ(cursor.peek(), "one");
    cursor.skip_bytes(2);
    EXPECT_EQ(cursor.token(), "e");
    EXPECT_EQ(cursor.token(), "two");
    EXPECT_TRUE(cursor.peek().empty());
    EXPECT_EQ(cursor.after_line(), 8U);
    EXPECT_FALSE(cursor.next_line());
    EXPECT_FALSE(cursor.next_line());
    EXPECT_EQ(cursor.line(), 1U);
}

TEST(MeshTextCursor, NamesTheLineAndWhatIsMissing) {
    MeshTextCursor cursor("\n1 2", "text");
    ASSERT_TRUE(cursor.next_line());
    EXPECT_EQ(cursor.integer("a"), 1);
    EXPECT_EQ(cursor.number("b"), 2);
    try {
        (void)cursor.number("c");
        FAIL();
    } catch (const kernel::FileError& error) {
        EXPECT_STREQ(error.what(), "text:2: the line ends where c should follow");
    }
}

TEST(Quoted, MakesAnythingFitForALine) {
    EXPECT_EQ(quoted("a b"), "'a b'");
    EXPECT_EQ(quoted(std::string_view("\0\n\x7f\xff", 4)), "'\\x00\\x0a\\x7f\\xff'");
    EXPECT_EQ(geometry::quoted(std::string(33, 'x')), "'" + std::string(32, 'x') + "...'");
}

}  // namespace
}  // namespace tightflip::geometry
