#include "refusals.hpp"
#include <tightflip/kernel/text_cursor.hpp>

#include <cmath>
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

/// No comments, no continued lines, plus signs allowed.
constexpr LineSyntax bare{.comment = '\0', .plus_signs = true};
constexpr LineSyntax continued{.continued_lines = true};

Words words_of_line(TextCursor& cursor) {
    Words words;
    for (auto word = cursor.word(); !word.empty(); word = cursor.word())
        words.emplace_back(word);
    return words;
}

std::vector<Words> words_of(const std::string& text, LineSyntax syntax = {}) {
    TextCursor cursor(text, "t", syntax);
    std::vector<Words> lines;
    while (cursor.next_line())
        lines.push_back(words_of_line(cursor));
    return lines;
}

/// Every line that has words as "number: word word".
std::vector<std::string> numbered_lines_of(const std::string& text, LineSyntax syntax) {
    std::vector<std::string> lines;
    TextCursor cursor(text, "t", syntax);
    while (cursor.next_line()) {
        std::string line = std::to_string(cursor.line()) + ":";
        for (const std::string& word : words_of_line(cursor))
            line += " " + word;
        lines.push_back(line);
    }
    return lines;
}

/// A cursor on the first line with words.
TextCursor on_first_line(const std::string& text, LineSyntax syntax = {}) {
    TextCursor cursor(text, "data.txt", syntax);
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
    cursor.require_end_of_line("the number");
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

TEST(TextCursor, CountsLinesWhateverTheirEnds) {
    EXPECT_THAT(numbered_lines_of("a b\n\n \t\nc\n", bare), ElementsAre("1: a b", "4: c"));
    EXPECT_THAT(numbered_lines_of("\r\na\r\n\r\nb", bare), ElementsAre("2: a", "4: b"));
    EXPECT_THAT(numbered_lines_of("", bare), ElementsAre());
    EXPECT_THAT(numbered_lines_of("\n \n\r\n", bare), ElementsAre());
}

TEST(TextCursor, LeavesOutCommentsOnlyWhereThereAreSome) {
    EXPECT_THAT(numbered_lines_of("#x\na#b\n", {}), ElementsAre("2: a"));
    EXPECT_THAT(numbered_lines_of("#x\na#b\n", bare), ElementsAre("1: #x", "2: a#b"));
    EXPECT_THAT(numbered_lines_of("%x\na#b\n", {.comment = '%'}), ElementsAre("2: a#b"));
}

TEST(TextCursor, JoinsLinesOnlyWhereTheFormatDoes) {
    EXPECT_THAT(numbered_lines_of("a\\\nb\\\r\n\\\nc\nd \\e\\", continued),
                ElementsAre("1: a b c", "5: d \\e\\"));
    EXPECT_THAT(numbered_lines_of("a #x\\\nb\n", continued), ElementsAre("1: a", "2: b"));
    EXPECT_THAT(numbered_lines_of("a\\\nb\n", bare), ElementsAre("1: a\\", "2: b"));
    EXPECT_THAT(numbered_lines_of("a\\\nb\n", {}), ElementsAre("1: a\\", "2: b"));
}

TEST(TextCursor, SkipsTheRestOfAContinuedLineUnread) {
    const std::string text = "a \\\nb \\\nc\nd\n";
    TextCursor cursor = on_first_line(text, continued);
    ASSERT_TRUE(cursor.next_line());
    EXPECT_EQ(cursor.word(), "d");
    EXPECT_EQ(cursor.line(), 4U);
}

TEST(TextCursor, PeeksWithoutTaking) {
    const std::string text = "one two\n";
    TextCursor cursor = on_first_line(text);
    EXPECT_EQ(cursor.peek(), "one");
    cursor.skip_bytes(2);
    EXPECT_EQ(cursor.word(), "e");
    EXPECT_EQ(cursor.word(), "two");
    EXPECT_TRUE(cursor.peek().empty());
    EXPECT_EQ(cursor.after_line(), 8U);
    EXPECT_FALSE(cursor.next_line());
    EXPECT_FALSE(cursor.next_line());
    EXPECT_EQ(cursor.line(), 1U);
}

TEST(TextCursor, PeeksOverAContinuation) {
    const std::string text = "a \\\n b\n";
    TextCursor cursor = on_first_line(text, continued);
    EXPECT_EQ(cursor.word(), "a");
    EXPECT_EQ(cursor.peek(), "b");
    EXPECT_EQ(cursor.peek(), "b");
    EXPECT_EQ(cursor.word(), "b");
    EXPECT_EQ(cursor.word(), "");
    EXPECT_EQ(cursor.line(), 2U);
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

TEST(TextCursor, NamesTheLineAndWhatIsMissing) {
    const std::string text = "\n1 2";
    TextCursor cursor = on_first_line(text);
    EXPECT_EQ(cursor.integer("a"), 1);
    EXPECT_EQ(cursor.number("b"), 2);
    const auto refusals = {refusal_of([&] { return cursor.number("c"); }),
                           refusal_of([&] { return cursor.integer("c"); }),
                           refusal_of([&] { return cursor.index("c"); }),
                           refusal_of([&] { return cursor.count("c"); }),
                           refusal_of([&] { return cursor.word("c"); })};
    for (const auto& refusal : refusals) {
        ASSERT_TRUE(refusal);
        EXPECT_STREQ(refusal->what(), "data.txt:2: the line ends where c should follow");
    }
}

TEST(TextCursor, FailsInTheFirstLineBeforeAnyIsRead) {
    expect_refused_in_line(refusal_of([] { TextCursor("a", "t").fail("no good"); }), 1, "no good");
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
        EXPECT_THAT(refusal->reason(), HasSubstr("should be a whole number")) << word;
    }
}

TEST(TextCursor, TakesPlusSignsOnlyWhereTheFormatDoes) {
    const std::string text = "+1 +2.5 +3 +-1 ++1 +";
    TextCursor cursor = on_first_line(text, bare);
    EXPECT_EQ(cursor.integer("a number"), 1);
    EXPECT_EQ(cursor.number("a number"), 2.5);
    EXPECT_EQ(cursor.parse_integer("+7"), 7);
    EXPECT_EQ(cursor.count("a number"), 3U);
    for (const std::string word : {"+-1", "++1", "+"}) {
        EXPECT_TRUE(refusal_of([&] { return cursor.integer("a number"); })) << word;
        EXPECT_FALSE(cursor.parse_integer(word)) << word;
    }
    TextCursor strict = on_first_line(text);
    EXPECT_TRUE(refusal_of([&] { return strict.integer("a number"); }));
    EXPECT_TRUE(refusal_of([&] { return strict.number("a number"); }));
    EXPECT_FALSE(strict.parse_integer("+7"));
}

TEST(TextCursor, ReadsNumbers) {
    const std::string text = "1 -.5 2. 1e-3 -1E+2 inf nan";
    TextCursor cursor = on_first_line(text);
    for (const double value : {1.0, -0.5, 2.0, 1e-3, -100.0})
        EXPECT_EQ(cursor.number("a number"), value);
    EXPECT_TRUE(std::isinf(cursor.number("a number")));
    EXPECT_TRUE(std::isnan(cursor.number("a number")));
}

TEST(TextCursor, RefusesWhatIsNoNumber) {
    for (const std::string word : {"x", "1,5", "0x10", "1.5.", "--1", "-", "1e999x"}) {
        TextCursor cursor = on_first_line(word);
        const auto refusal = refusal_of([&] { return cursor.number("the answer"); });
        expect_refused_in_line(refusal, 1, "the answer should be a number");
        expect_refused_in_line(refusal, 1, kernel::quoted(word) + " is none");
    }
    const std::string large = "1e999";
    TextCursor cursor = on_first_line(large);
    expect_refused_in_line(refusal_of([&] { return cursor.number("the answer"); }), 1,
                           "the answer, '1e999', is beyond the range of a double");
}

TEST(TextCursor, ParsesPartsOfWordsAsIntegers) {
    const TextCursor cursor("", "t");
    EXPECT_EQ(cursor.parse_integer("-12"), -12);
    EXPECT_EQ(cursor.parse_integer("9223372036854775807"), 9223372036854775807);
    for (const std::string text : {"", "-", "1/2", " 1", "1 ", "9223372036854775808"})
        EXPECT_FALSE(cursor.parse_integer(text)) << text;
}

TEST(TextCursor, IndicesAreOf32BitsUnlessBoundedFurther) {
    const std::string text = "2147483647 -2147483648 7";
    TextCursor cursor = on_first_line(text);
    EXPECT_EQ(cursor.index("an index"), 2147483647);
    EXPECT_EQ(cursor.index("an index"), std::numeric_limits<Index>::min());
    expect_refused_in_line(refusal_of([&] { return cursor.index("an index", 0, 6); }), 1, "0 .. 6");
    for (const std::string word : {"2147483648", "-2147483649", "4294967296"}) {
        TextCursor beyond = on_first_line(word);
        expect_refused_in_line(refusal_of([&] { return beyond.index("an index"); }), 1,
                               "an index is '" + word + "'");
    }
}

TEST(TextCursor, NumbersOfThingsAreNotNegative) {
    const std::string text = "0 9223372036854775807 -3";
    TextCursor cursor = on_first_line(text);
    EXPECT_EQ(cursor.count("a number"), 0U);
    EXPECT_EQ(cursor.count("a number"), 9223372036854775807U);
    expect_refused_in_line(refusal_of([&] { return cursor.count("the number"); }), 1,
                           "the number is negative: -3");
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
        EXPECT_EQ(cursor.announced_lines("numbers", 2), 3);
        cursor.require_line("a number");
        EXPECT_EQ(cursor.word(), "1");
    }
    for (const std::string count : {"5", "100", "2147483647"}) {
        std::string text = "\nnumbers " + count;
        text += "\n" + three_lines;
        TextCursor cursor(text, "t");
        expect_refused_in_line(refusal_of([&] { return cursor.announced_lines("numbers", 2); }), 2,
                               count);
    }
}

TEST(TextCursor, LongLinesLowerTheBoundOnCounts) {
    const std::string text = "faces 4\n" + std::string(36, 'x') + "\n";
    TextCursor narrow(text, "t");
    EXPECT_EQ(narrow.announced_lines("faces", 9), 4);
    TextCursor wide(text, "t");
    expect_refused_in_line(refusal_of([&] { return wide.announced_lines("faces", 20); }), 1,
                           "4 faces");
}

TEST(TextCursor, ZeroIsACount) {
    const std::string text = "flips 0";
    TextCursor cursor(text, "t");
    EXPECT_EQ(cursor.announced_lines("flips", 2), 0);
}

TEST(TextCursor, RefusesMalformedCounts) {
    struct Case {
        std::string text, word;
    };
    for (const auto& [text, word] :
         {Case{"", "faces"}, Case{"edges 1\n1\n", "edges"}, Case{"faces\n1\n", "count"},
          Case{"faces -1\n1\n", "-1"}, Case{"faces one\n1\n", "one"}, Case{"faces 1 1\n1\n", "'1'"},
          Case{"faces 4294967297\n1\n", "4294967297"}}) {
        const auto refusal = refusal_of([&, cursor = TextCursor(text, "t")]() mutable {
            return cursor.announced_lines("faces", 2);
        });
        ASSERT_TRUE(refusal) << text;
        EXPECT_THAT(refusal->reason(), HasSubstr(word));
    }
}

TEST(TextCursor, RefusesWordsAfterTheEnd) {
    const std::string text = "one two # three\n";
    TextCursor cursor = on_first_line(text);
    cursor.word();
    expect_refused_in_line(refusal_of([&] { cursor.require_end_of_line("the number"); }), 1,
                           "goes on with 'two' after the number");
    EXPECT_FALSE(refusal_of([&] { cursor.require_end_of_line("the number"); }))
        << "a comment is no word";
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

TEST(Quoted, MakesAnythingFitForALine) {
    EXPECT_EQ(quoted("a b"), "'a b'");
    EXPECT_EQ(quoted(std::string_view("\0\n\x7f\xff", 4)), "'\\x00\\x0a\\x7f\\xff'");
    EXPECT_EQ(kernel::quoted(std::string(33, 'x')), "'" + std::string(32, 'x') + "...'");
}

}  // namespace
}  // namespace tightflip::kernel
