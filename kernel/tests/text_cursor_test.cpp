#include "refusals.hpp"
#include <tightflip/kernel/text_cursor.hpp>

#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tightflip::kernel {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using testing::expect_refused_in_line;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::refusal_of;

using Words = std::vector<std::string>;

Words words_of_line(TextCursor& cursor) {
    Words words;
    for (auto word = cursor.word(); !word.empty(); word = cursor.word())
        words.emplace_back(word);
    return words;
}

std::vector<Words> words_of(const std::string& text) {
    TextCursor cursor(text, "t");
    std::vector<Words> lines;
    while (cursor.next_line())
        lines.push_back(words_of_line(cursor));
    return lines;
}

/// A cursor on the first line with words.
TextCursor on_first_line(const std::string& text) {
    TextCursor cursor(text, "data.txt");
    cursor.require_line("a line");
    return cursor;
}

TEST(TextCursor, WalksTheWordsOfEachLine) {
    EXPECT_THAT(words_of("one two\nthree\n"), ElementsAre(Words{"one", "two"}, Words{"three"}));
    EXPECT_THAT(words_of("\tone   two \n  three"),
                ElementsAre(Words{"one", "two"}, Words{"three"}));
}

TEST(TextCursor, HasNoLineInATextWithoutWords) {
    for (const std::string text : {"", "\n", "\r\n\r\n", " \t \n", "# only a comment", "#\n#"}) {
        EXPECT_THAT(words_of(text), ElementsAre()) << '"' << text << '"';
    }
}

TEST(TextCursor, SkipsCommentsAndBlankLines) {
    EXPECT_THAT(words_of("# head\n\none # two\n   # three\n  \nfour#five\n#"),
                ElementsAre(Words{"one"}, Words{"four"}));
}

TEST(TextCursor, TreatsCrLfAsLf) {
    EXPECT_THAT(words_of("one two\r\n\r\n# no\r\nthree\r\n"),
                ElementsAre(Words{"one", "two"}, Words{"three"}));
    const std::string text = "12\r\n";
    TextCursor cursor = on_first_line(text);
    EXPECT_EQ(cursor.integer("a number"), 12);
    cursor.require_end_of_line();
}

TEST(TextCursor, CountsEveryLineFromOne) {
    const std::string text = "first\n\n# no\r\nfourth\n\n\nseventh";
    TextCursor cursor(text, "t");
    for (const std::uint64_t line : {1U, 4U, 7U}) {
        ASSERT_TRUE(cursor.next_line());
        EXPECT_EQ(cursor.line(), line);
    }
    EXPECT_FALSE(cursor.next_line());
    EXPECT_EQ(cursor.word(), "");
    EXPECT_FALSE(cursor.next_line());
}

TEST(TextCursor, LeavesTheRestOfALineBehind) {
    const std::string text = "one two three\nfour\n";
    TextCursor cursor = on_first_line(text);
    EXPECT_EQ(cursor.word(), "one");
    ASSERT_TRUE(cursor.next_line());
    EXPECT_EQ(cursor.word(), "four");
    EXPECT_EQ(cursor.word(), "");
}

TEST(TextCursor, NamesSourceLineAndReason) {
    const std::string text = "\n\nword\n";
    const TextCursor cursor = on_first_line(text);
    EXPECT_EQ(cursor.source(), "data.txt");
    const auto refusal = refusal_of([&] { cursor.fail("no good"); });
    ASSERT_TRUE(refusal);
    EXPECT_STREQ(refusal->what(), "data.txt:3: no good");
    EXPECT_EQ(refusal->source(), "data.txt");
    EXPECT_EQ(refusal->reason(), "no good");
}

TEST(TextCursor, RequiredLineNamesWhatIsMissing) {
    const std::string text = "one\ntwo\n";
    TextCursor cursor(text, "t");
    cursor.require_line("the first");
    cursor.require_line("the second");
    EXPECT_EQ(cursor.word(), "two");
    expect_refused_in_line(refusal_of([&] { cursor.require_line("the third"); }), 2, "the third");
}

TEST(TextCursor, RequiredWordNamesBothWords) {
    const std::string text = "vertices edges\n";
    TextCursor cursor = on_first_line(text);
    cursor.require_word("vertices");
    const auto refusal = refusal_of([&] { cursor.require_word("faces"); });
    expect_refused_in_line(refusal, 1, "'faces'");
    ASSERT_TRUE(refusal);
    EXPECT_THAT(refusal->reason(), HasSubstr("'edges'"));
    EXPECT_TRUE(refusal_of([&] { cursor.require_word("more"); })) << "the line has ended";
}

TEST(TextCursor, RequiredWordIsMatchedWhole) {
    for (const std::string text : {"face", "facess", "Faces", "faces:"}) {
        TextCursor cursor = on_first_line(text);
        EXPECT_TRUE(refusal_of([&] { cursor.require_word("faces"); })) << text;
    }
}

TEST(TextCursor, ReadsIntegersInTheirRange) {
    const std::string text = "0 7 -1 2147483647 -2147483648 0012 -0";
    TextCursor cursor = on_first_line(text);
    for (const std::int64_t value : {0L, 7L, -1L, 2147483647L, -2147483648L, 12L, 0L}) {
        EXPECT_EQ(cursor.integer("a number"), value);
    }
    const std::string bounds = "3 5";
    TextCursor bounded = on_first_line(bounds);
    EXPECT_EQ(bounded.integer("a number", 3, 5), 3);
    EXPECT_EQ(bounded.integer("a number", 3, 5), 5);
    const std::string wide = "9223372036854775807 -9223372036854775808";
    using Limits = std::numeric_limits<std::int64_t>;
    TextCursor widest = on_first_line(wide);
    EXPECT_EQ(widest.integer("a number", Limits::min(), Limits::max()), Limits::max());
    EXPECT_EQ(widest.integer("a number", Limits::min(), Limits::max()), Limits::min());
}

TEST(TextCursor, RefusesWhatIsNoInteger) {
    for (const std::string word : {"x", "1.5", "1e3", "+1", "0x10", "1,", "--1", "-", "1_000",
                                   "nan", "12a", "\xd9\xa3", "99999999999999999999x"}) {
        const std::string text = "\n" + word + " 5\n";
        TextCursor cursor = on_first_line(text);
        const auto refusal = refusal_of([&] { return cursor.integer("the answer"); });
        expect_refused_in_line(refusal, 2, "the answer");
        ASSERT_TRUE(refusal);
        EXPECT_THAT(refusal->reason(), HasSubstr("no whole number")) << word;
    }
}

TEST(TextCursor, RefusesAMissingInteger) {
    const std::string text = "5 # 6\n7";
    TextCursor cursor = on_first_line(text);
    EXPECT_EQ(cursor.integer("the first"), 5);
    expect_refused_in_line(refusal_of([&] { return cursor.integer("the second"); }), 1,
                           "the second");
}

TEST(TextCursor, RefusesAnIntegerOutOfRangeAndNamesTheRange) {
    struct Case {
        std::string word;
        std::int64_t low, high;
    };
    constexpr std::int64_t least = std::numeric_limits<Index>::min();
    constexpr std::int64_t most = std::numeric_limits<Index>::max();
    for (const auto& [word, low, high] :
         {Case{"2147483648", least, most}, Case{"-2147483649", least, most}, Case{"2", 3, 5},
          Case{"6", 3, 5}, Case{"-1", 0, 10}, Case{"99999999999999999999999999", least, most},
          Case{"-99999999999999999999999999", least, most}, Case{"0", 0, -1}}) {
        TextCursor cursor = on_first_line(word);
        const auto refusal =
            refusal_of([&, l = low, h = high] { return cursor.integer("the answer", l, h); });
        expect_refused_in_line(refusal, 1, "the answer");
        ASSERT_TRUE(refusal);
        EXPECT_THAT(refusal->reason(),
                    AllOf(HasSubstr(std::to_string(low)), HasSubstr(std::to_string(high))));
    }
}

TEST(TextCursor, CountsAreBoundedByTheTextThatIsLeft) {
    const std::string three_lines = "1\n2\n3\n";
    for (const std::string& rest : {three_lines, three_lines.substr(0, 5)}) {
        const std::string text = "numbers 3\n" + rest;
        TextCursor cursor(text, "t");
        EXPECT_EQ(cursor.count("numbers", 2), 3);
        cursor.require_line("a number");
        EXPECT_EQ(cursor.word(), "1");
    }
    for (const std::string count : {"5", "100", "2147483647"}) {
        const std::string text = "\nnumbers " + count + "\n" + three_lines;
        TextCursor cursor(text, "t");
        expect_refused_in_line(refusal_of([&] { return cursor.count("numbers", 2); }), 2, count);
    }
}

TEST(TextCursor, LongLinesLowerTheBoundOnCounts) {
    const std::string text = "faces 4\n" + std::string(36, 'x') + "\n";
    TextCursor narrow(text, "t");
    EXPECT_EQ(narrow.count("faces", 9), 4);
    TextCursor wide(text, "t");
    expect_refused_in_line(refusal_of([&] { return wide.count("faces", 20); }), 1, "4 faces");
}

TEST(TextCursor, ZeroIsACount) {
    const std::string text = "flips 0";
    TextCursor cursor(text, "t");
    EXPECT_EQ(cursor.count("flips", 2), 0);
}

TEST(TextCursor, RefusesMalformedCounts) {
    struct Case {
        std::string text, word;
    };
    for (const auto& [text, word] :
         {Case{"", "faces"}, Case{"edges 1\n1\n", "edges"}, Case{"faces\n1\n", "count"},
          Case{"faces -1\n1\n", "-1"}, Case{"faces one\n1\n", "one"}, Case{"faces 1 1\n1\n", "'1'"},
          Case{"faces 4294967297\n1\n", "4294967297"}}) {
        const auto refusal = refusal_of(
            [&, cursor = TextCursor(text, "t")]() mutable { return cursor.count("faces", 2); });
        ASSERT_TRUE(refusal) << text;
        EXPECT_THAT(refusal->reason(), HasSubstr(word));
    }
}

TEST(TextCursor, RefusesWordsAfterTheEnd) {
    const std::string text = "one two # three\n";
    TextCursor cursor = on_first_line(text);
    cursor.word();
    expect_refused_in_line(refusal_of([&] { cursor.require_end_of_line(); }), 1, "'two'");
    EXPECT_FALSE(refusal_of([&] { cursor.require_end_of_line(); })) << "a comment is no word";
}

TEST(TextCursor, QuotesBrokenBytesHarmlessly) {
    const std::string text = std::string("\x1b[31m\0\xff\x07", 8) + std::string(5000, 'x');
    TextCursor cursor = on_first_line(text);
    const auto refusal = refusal_of([&] { return cursor.integer("a number"); });
    ASSERT_TRUE(refusal);
    EXPECT_LT(refusal->reason().size(), 200U);
    for (const char c : refusal->reason())
        EXPECT_TRUE(c >= ' ' && c <= '~') << int{c};
    EXPECT_THAT(refusal->reason(), Not(HasSubstr("xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx")));
}

}  // namespace
}  // namespace tightflip::kernel
