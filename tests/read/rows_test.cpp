// Rows of numbers, those that are none, and a last line that may be cut.
#include "cromer/read/rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/documents/words/words.h"
#include "cromer/read/cells.h"

namespace cromer::core::dialects {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::HasSubstr;

/// All lines of a text as rows of two columns, between semicolons.
Result<Rows> rows_of(const std::string& text, RowRules rules = {}) {
  const auto lines = split_lines(text);
  rules.to = lines.size();
  return read_rows(lines, Layout{';', '.', 2}, {"t", "x"}, rules);
}

std::string repeated(std::size_t count, const std::string& row) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += row;
  return text;
}

/// What is said of the last line below some rows.
std::string said(const std::string& rows, const std::string& last) {
  return in_words(rows_of(rows + last)->last_line);
}

TEST(Rows, BadOnesAreCountedAndTheFirstIsRemembered) {
  RowRules rules;
  rules.skip_bad_rows = true;
  rules.lines_before = 10;
  const auto rows = rows_of("0;1\n\n1;abc\n# 7\n2;3;4\n3;;\n4\n5;6\n", rules);
  ASSERT_TRUE(rows.ok());
  EXPECT_THAT(rows->lines, ElementsAre(11, 16, 17, 18));
  EXPECT_THAT(rows->columns[0], ElementsAre(0, 3, 4, 5));
  EXPECT_TRUE(std::isnan(rows->columns[1][1]));
  EXPECT_TRUE(std::isnan(rows->columns[1][2]));
  EXPECT_EQ(rows->bad_rows, 2u);
  EXPECT_EQ(rows->first_bad_line, 13);
  EXPECT_EQ(in_words(rows->first_complaint), "column \"x\": \"abc\" is not a number");
  EXPECT_EQ(in_words(rows->last_line), "");
}

TEST(Rows, ABadOneIsAnErrorWithItsLine) {
  EXPECT_EQ(in_words(rows_of("0;1\n1;abc\n").error()),
            "line 2: column \"x\": \"abc\" is not a number; --skip-bad-rows drops such rows");
  EXPECT_EQ(in_words(rows_of("0;1\n1;2;3\n").error()),
            "line 2: there are more values than the 2 columns; --skip-bad-rows drops such rows");
  RowRules remarks;
  remarks.ignore_beyond = true;
  EXPECT_TRUE(rows_of("0;1;said\n1;2;;3\n", remarks).ok());
  EXPECT_FALSE(rows_of("0;1;2\n", remarks).ok());
}

TEST(Rows, FarShorterOnesThanTheTableIsWideAreRefused) {
  const auto read = [](std::size_t count) {
    const std::string text = repeated(count, "1\n\n");
    const auto lines = split_lines(text);
    return read_rows(lines, Layout{';', '.', 64}, std::vector<std::string>(64, "x"), {0, lines.size()});
  };
  EXPECT_TRUE(read(128).ok());
  ASSERT_FALSE(read(129).ok());
  EXPECT_EQ(in_words(read(129).error()), "most rows are far shorter than the widest, which has 64 columns");
}

TEST(LastLine, EightRowsShowHowNumbersAreWritten) {
  EXPECT_THAT(said(repeated(8, "0.5;1.25\n"), "0.5;1.2"),
              "the last line, 9, seems cut within a number, \"1.2\": it is left out");
  EXPECT_EQ(said(repeated(7, "0.5;1.25\n"), "0.5;1.2"), "");
  // Rows without that value show nothing, and hide none behind them.
  EXPECT_NE(said(repeated(8, "0.5;1.25\n") + "0.5;\n0.5\n", "0.5;1.2"), "");
  EXPECT_EQ(said(repeated(7, "0.5;1.25\n") + "0.5;\n0.5\n", "0.5;1.2"), "");
}

TEST(LastLine, OneDecimalIsEnoughToMissIt) {
  EXPECT_THAT(said(repeated(8, "0;0.5\n"), "0;1"), HasSubstr("left out"));
  EXPECT_THAT(said(repeated(8, "0;0.5\n"), "0;1."), HasSubstr("left out"));
  EXPECT_THAT(said(repeated(8, "0;5E1\n"), "0;5"), HasSubstr("left out"));
}

TEST(LastLine, AThousandRowsAreLookedAt) {
  const std::string other = "0.5;1.5\n", usual = "0.5;1.25\n";
  EXPECT_THAT(said(other + repeated(1000, usual), "0.5;1.2"), HasSubstr("left out"));
  EXPECT_EQ(said(other + repeated(999, usual), "0.5;1.2"), "");
}

TEST(LastLine, ACutExponentIsLeftOut) {
  EXPECT_THAT(said(repeated(8, "0;1.25E10\n"), "0;1.25E1"), HasSubstr("left out"));
  EXPECT_THAT(said(repeated(8, "0;1.25E10\n"), "0;9.5E10"), HasSubstr("left out"));
  EXPECT_EQ(said(repeated(8, "0;10.25E10\n"), "0;9.25E10"), "");
  EXPECT_EQ(said(repeated(8, "0;15E10\n"), "0;5E10"), "");
}

TEST(LastLine, AllItsDecimalsShowThatItIsWhole) {
  EXPECT_EQ(said(repeated(8, "0;10.25\n"), "0;9.25"), "");
  EXPECT_EQ(said(repeated(8, "0;10.25\n"), "0;9.255"), "");
}

TEST(LastLine, WhatIsShorterThanAllOthersIsKeptAndSaid) {
  const std::string mixed = repeated(5, "0;0.34\n0;0.345\n");
  EXPECT_EQ(said(mixed, "0;0.34"), "");
  EXPECT_EQ(said(mixed, "0;0.3"),
            "the last line, 11, has no end and may end within a number, \"0.3\": it is kept");
  EXPECT_THAT(said(mixed, "0;1234.5"), HasSubstr("it is kept"));
  EXPECT_EQ(said(mixed, "0;1234.56"), "");
  const std::string whole = repeated(8, "0;1234\n");
  EXPECT_EQ(said(whole, "0;1234"), "");
  EXPECT_EQ(said(whole, "0;12345"), "");
  EXPECT_THAT(said(whole, "0;123"), HasSubstr("it is kept"));
  const std::string exponents = repeated(5, "0;1.5E12\n0;1.5E123\n");
  EXPECT_EQ(said(exponents, "0;1.5E12"), "");
  EXPECT_THAT(said(exponents, "0;1.5555E1"), HasSubstr("it is kept"));
}

TEST(LastLine, ARemarkBehindTheRowsIsNone) {
  const auto rows = rows_of(repeated(9, "0;1.25\n") + "#;1.2");
  EXPECT_EQ(rows->lines.size(), 9u);
  EXPECT_EQ(in_words(rows->last_line), "");
  // Nor is a last row above other lines of the file.
  const std::string text = repeated(8, "0;1.25\n") + "0;1.2\nThe end";
  const auto lines = split_lines(text);
  const auto above = read_rows(lines, Layout{';', '.', 2}, {"t", "x"}, {0, lines.size() - 1});
  EXPECT_EQ(above->lines.size(), 9u);
  EXPECT_EQ(in_words(above->last_line), "");
}

TEST(LastLine, ThatIsNoNumberAndBeginsAsOneIsLeftOut) {
  const auto rows = rows_of("0;1\n1;1.5e");
  ASSERT_TRUE(rows.ok());
  EXPECT_EQ(in_words(rows->last_line),
            "the last line, 2, seems cut within a number, \"1;1.5e\": it is left out");
  EXPECT_EQ(rows->lines.size(), 1u);
  EXPECT_EQ(rows_of("0;1\n1;1.5e-")->lines.size(), 1u);
  for (const char* text : {"0;1\n1;1.5e\n", "0;1\n1;abc", "0;1\nabe;e", "1;1.5e", "0;1\n12 done", "0;1\n1;E"})
    EXPECT_FALSE(rows_of(text).ok()) << text;
}

TEST(NoRows, TheShortestBadCellIsNamed) {
  const Error reason{"no_rows_of_numbers"}, option{"unknown_delimiter", {{"given", "x"}}};
  const auto message = [&](const std::string& text) {
    return in_words(no_rows(split_lines(text), reason, 10));
  };
  EXPECT_EQ(
      message("\nTime;x\n12:00:00;1\n13:00;1"),
      "line 13: no rows of numbers are found: \"12:00:00\" is not a number; it is a clock time: write the "
      "seconds since the start");
  EXPECT_THAT(message("2 12:00:00 13:00:00"),
              HasSubstr("line 11: no rows of numbers are found: \"12:00:00\""));
  EXPECT_THAT(message("1.5D3"), HasSubstr("write 1.5E3"));
  EXPECT_EQ(message("a 12:00:00"), in_words(reason));
  EXPECT_EQ(no_rows(split_lines("12:00:00"), option, 0).notice, option.notice);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects
