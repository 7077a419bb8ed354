// SPDX-License-Identifier: Apache-2.0
//
// Lines, comments and numbers of OBJ and MTL.

#include "renderer/import/text_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace wellstrat::render {
namespace {

using Lines = std::vector<std::vector<std::string>>;

Lines linesOf(const std::string& text) {
    TextLines lines(text);
    Lines all;
    while (lines.next()) all.emplace_back(lines.words().begin(), lines.words().end());
    return all;
}

TEST(TextLines, EndsOfLines) {
    for (const char* const end : {"\n", "\r\n", "\r"})
        EXPECT_EQ(linesOf(std::string("a b") + end + end + " \tc  d\t" + end + "e"),
                  (Lines{{"a", "b"}, {"c", "d"}, {"e"}}));
    EXPECT_TRUE(linesOf("").empty());
    EXPECT_TRUE(linesOf(" \n\t\r\n").empty());
}

TEST(TextLines, CommentsBeginWithAWord) {
    EXPECT_EQ(linesOf("# all\na # rest\nb#1 c#\n#\n  # more\nd"),
              (Lines{{"a"}, {"b#1", "c#"}, {"d"}}));
}

TEST(TextLines, BackslashesJoinLines) {
    EXPECT_EQ(linesOf("a \\\nb\\\r\nc\nd"), (Lines{{"a", "b", "c"}, {"d"}}));
    EXPECT_EQ(linesOf("a # no \\\nb"), (Lines{{"a"}, {"b"}})); // in a comment
    EXPECT_EQ(linesOf("a \\"), (Lines{{"a"}}));
    EXPECT_EQ(linesOf("a\\b c"), (Lines{{"a\\b", "c"}}));
}

TEST(TextLines, ByteOrderMarksAreNoText) {
    EXPECT_EQ(linesOf("\xef\xbb\xbfv 1"), (Lines{{"v", "1"}}));
}

TEST(TextLines, NamesKeepTheirBlanks) {
    TextLines lines("newmtl  my  red # comment\n");
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.from(1), "my  red");
    EXPECT_EQ(lines.from(9), "");
}

TEST(TextLines, Numbers) {
    EXPECT_EQ(numberOf("-1.5e2"), -150);
    EXPECT_EQ(numberOf("+0.25"), 0.25);
    EXPECT_EQ(numberOf(".5"), 0.5);
    EXPECT_EQ(numberOf("1e999"), HUGE_VAL);
    EXPECT_EQ(numberOf("-1e-999"), 0);
    EXPECT_EQ(numberOf("inf"), HUGE_VAL);
    for (const char* const word : {"", "+", "+-1", "nan", "1.0x", "one", "1,5", "0x1"})
        EXPECT_TRUE(std::isnan(numberOf(word))) << word;
}

} // namespace
} // namespace wellstrat::render
