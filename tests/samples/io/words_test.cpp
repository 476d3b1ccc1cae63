#include "samples/io/words.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace relevo::io {
namespace {

void expect_word(const Word& word, std::string_view text, int line, int column) {
    EXPECT_EQ(word.text, text);
    EXPECT_EQ(word.line, line) << text;
    EXPECT_EQ(word.column, column) << text;
}

TEST(Words, KnowTheirPlaces) {
    Words words("ab  c\n\td");
    expect_word(words.in_line(), "ab", 1, 1);
    expect_word(words.in_line(), "c", 1, 5);
    expect_word(words.in_line(), "", 1, 6);
    EXPECT_TRUE(words.next_line());
    expect_word(words.in_line(), "d", 2, 2);
    EXPECT_FALSE(words.next_line());
}

TEST(Words, CommentsEndTheLine) {
    Words words("a # b \\\nc d#e");
    expect_word(words.in_line(), "a", 1, 1);
    expect_word(words.in_line(), "", 1, 3);
    EXPECT_TRUE(words.next_line());  // a backslash inside a comment continues nothing
    expect_word(words.in_line(), "c", 2, 1);
    expect_word(words.in_line(), "d#e", 2, 3);
}

TEST(Words, ABackslashContinuesTheLine) {
    Words words("f 1\\\n 2 \\\r\n3\nv");
    expect_word(words.in_line(), "f", 1, 1);
    expect_word(words.in_line(), "1", 1, 3);
    expect_word(words.in_line(), "2", 2, 2);
    expect_word(words.in_line(), "3", 3, 1);
    expect_word(words.in_line(), "", 3, 2);
    EXPECT_TRUE(words.next_line());
    expect_word(words.in_line(), "v", 4, 1);
}

TEST(Words, ABackslashElsewhereIsALetter) {
    Words words("a\\b \\");
    expect_word(words.in_line(), "a\\b", 1, 1);
    expect_word(words.in_line(), "\\", 1, 5);
    expect_word(words.in_line(), "", 1, 6);
}

TEST(Words, CarriageReturnsAreBlanks) {
    Words words("a\r\nb\r\n");
    expect_word(words.in_line(), "a", 1, 1);
    expect_word(words.anywhere(), "b", 2, 1);
    expect_word(words.anywhere(), "", 3, 1);
}

TEST(Words, TheRestOfALineKeepsInnerBlanks) {
    Words words("usemtl  dark  wood \t# old\n");
    words.in_line();
    expect_word(words.rest_of_line(), "dark  wood", 1, 9);
    expect_word(words.rest_of_line(), "", 1, 21);
}

TEST(ParseFloat, TakesDecimalNumbers) {
    EXPECT_EQ(parse_float("1"), 1.f);
    EXPECT_EQ(parse_float("+1.5"), 1.5f);
    EXPECT_EQ(parse_float("-.5e+2"), -50.f);
    EXPECT_EQ(parse_float("2."), 2.f);
    EXPECT_EQ(parse_float("0.1"), 0.1f);
    EXPECT_EQ(parse_float("3.4028235e38"), std::numeric_limits<float>::max());
    // Exactly between two floats, and just above: rounded once, not first to double.
    EXPECT_EQ(parse_float("1.00000005960464477539062500"), 1.f);
    EXPECT_EQ(parse_float("1.00000005960464477539062501"), 1.00000012f);
}

TEST(ParseFloat, TinyNumbersAreZero) {
    EXPECT_EQ(parse_float("1e-60"), 0.f);
    EXPECT_EQ(parse_float("-1e-400"), 0.f);
    EXPECT_EQ(parse_float("1e-99999999999999999999"), 0.f);
    EXPECT_EQ(parse_float("0.0000000000000000000000000000000000000000000000000001"), 0.f);
    EXPECT_EQ(parse_float("1e-45"), std::numeric_limits<float>::denorm_min());
}

TEST(ParseFloat, RefusesTheRest) {
    for (const char* text : {"",
                             "+",
                             "-",
                             ".",
                             "nan",
                             "inf",
                             "-inf",
                             "NAN",
                             "infinity",
                             "abc",
                             "0x10",
                             "1e39",
                             "-1e39",
                             "1e400",
                             "1e99999999999999999999",
                             "1000000000000000000000000000000000000000",
                             "3.5e38",
                             "1e",
                             "1e+",
                             "12abc",
                             "1,5",
                             "1 ",
                             " 1",
                             "++1",
                             "+-1",
                             "1_0"})
        EXPECT_FALSE(parse_float(text)) << text;
}

TEST(ParseInteger, TakesIntegersOnly) {
    EXPECT_EQ(parse_integer("12"), 12);
    EXPECT_EQ(parse_integer("+12"), 12);
    EXPECT_EQ(parse_integer("-12"), -12);
    EXPECT_EQ(parse_integer("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
    for (const char* text : {"", "-", "1.0", "9223372036854775808", "1e3", "0x1", "1 "})
        EXPECT_FALSE(parse_integer(text)) << text;
}

TEST(InQuotes, FitsOneLine) {
    EXPECT_EQ(in_quotes("abc"), "'abc'");
    EXPECT_EQ(in_quotes("maçã"), "'maçã'");
    EXPECT_EQ(in_quotes("a\x1b"
                        "b\xc3"),
              "'a?b?'");
    EXPECT_EQ(in_quotes(std::string(50, 'x')), "'" + std::string(40, 'x') + "...'");
}

}  // namespace
}  // namespace relevo::io
