// Which separator and decimal mark rows have.
#include "cromer/read/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/documents/words/words.h"
#include "cromer/read/cells.h"

namespace cromer::core::dialects {
namespace CROMER_FILE {

using testing::HasSubstr;

Result<Layout> layout_of(const std::string& text, const ReadOptions& options = {}) {
  return find_layout(split_lines(text), options);
}

std::size_t columns_of(const std::string& text) { return layout_of(text)->columns; }

/// Lines of which those with an even number, counted from 0, are one thing, the others another.
std::string alternating(int lines, const std::string& even, const std::string& odd, int blank = 0) {
  std::string text;
  for (int i = 0; i < lines; ++i)
    text += i < blank ? "" : i % 2 == 0 ? even : odd, text += i + 1 < lines ? "\n" : "";
  return text;
}

TEST(Layout, ALongFileIsSampledBehindItsFirstFiftyLines) {
  EXPECT_EQ(columns_of(alternating(500, "1;2", "1;2;3", 50)), 2u);
  EXPECT_EQ(columns_of(alternating(500, "1;2;3", "1;2", 50)), 3u);
  EXPECT_EQ(columns_of(alternating(100, "1;2", "1;2;3", 50)), 3u);  // all lines of a short one
  EXPECT_EQ(columns_of(alternating(499, "1;2;3;4", "1;2;3", 51)), 4u);
  // 25 odd ones among the first fifty, 224 even ones behind them; as many of both in all.
  EXPECT_EQ(columns_of(alternating(499, "1;2;3", "1;2", 0)), 3u);
}

TEST(Layout, TheWidestOfEquallyFrequentRowsIsTaken) {
  EXPECT_EQ(columns_of("1;2\n1;2;3\n1;2;3\n1;2\n"), 3u);
  EXPECT_EQ(columns_of("1;2;3\n1;2\n1;2\n"), 2u);
  EXPECT_EQ(columns_of("1;2\n1;2;3\n1;2\n"), 2u);
  EXPECT_EQ(columns_of("1;2\n1;2\n1;2;3\n1;2;3;4\n1;2;3;4\n1;2;3;4\n"), 4u);
}

TEST(Layout, RowsOfNumbersAloneGoBeforeMoreRowsWithText) {
  const auto columns = [](int numbers, int with_text) {
    std::string text;
    for (int i = 0; i < numbers; ++i) text += "1;2\n";
    for (int i = 0; i < with_text; ++i) text += "a;1;2\n";
    return columns_of(text);
  };
  EXPECT_EQ(columns(3, 4), 2u);
  EXPECT_EQ(columns(2, 4), 3u);  // fewer may be a title's numbers
  EXPECT_EQ(columns(2, 3), 3u);
  EXPECT_EQ(columns(1, 2), 2u);
  EXPECT_EQ(columns(2, 2), 2u);
  EXPECT_EQ(columns_of("x;y\na;1;2\nb;3;4\nc;5;6\n"), 3u);
}

TEST(Layout, ARowHasANumber) {
  EXPECT_EQ(layout_of("nan;nan\nnan;nan\n1 2\n")->separator, ' ');
  EXPECT_FALSE(layout_of("nan;\n;\n").ok());
  EXPECT_EQ(columns_of("nan;2;\n3;nan;\n"), 3u);
}

TEST(Layout, OneColumnHasNoSeparator) {
  EXPECT_EQ(layout_of("1\n2\n")->separator, 0);
  EXPECT_EQ(layout_of("1,5\n2,5\nx\n")->separator, ',');
  ReadOptions semicolon;
  semicolon.delimiter = ";";
  EXPECT_EQ(layout_of("1\n2\n", semicolon)->separator, ';');
}

TEST(Layout, TheWholeFileShowsTheDecimalMark) {
  const auto decimal = [](const std::string& text) { return layout_of(text)->decimal; };
  const auto hidden = [&](const std::string& odd) {
    return decimal("1;2\n" + alternating(500, "1;2", odd, 50));
  };
  EXPECT_EQ(hidden("1;2"), '.');
  EXPECT_EQ(hidden("1,5;2"), ',');
  EXPECT_EQ(hidden("12;3,4"), ',');
  EXPECT_EQ(hidden("1.5;2"), '.');
  EXPECT_EQ(hidden("1,5;2.5"), '.');
  EXPECT_EQ(hidden("1,a"), '.');
  EXPECT_EQ(hidden("a,1"), '.');
  EXPECT_EQ(decimal("# 1,5\n1;2\n3;4\n"), '.');
  EXPECT_EQ(decimal("# 1.5\n1;2\n3;4\nlast 1,5\n"), ',');
}

TEST(Layout, TwoThousandColumnsAreRead) {
  std::string wide = "1";
  for (int j = 1; j < 2000; ++j) wide += ";1";
  EXPECT_EQ(columns_of(wide), 2000u);
  const auto wider = layout_of(wide + ";1");
  ASSERT_FALSE(wider.ok());
  EXPECT_EQ(in_words(wider.error()), "there are more than 2000 columns");
}

TEST(Layout, OptionsAreKnownByWordsAndMarks) {
  const auto separator = [](const char* given) {
    ReadOptions options;
    options.delimiter = given;
    return layout_of("1,2;3\t4 5\n1\n", options)->separator;
  };
  for (const char* given : {"tab", "\\t", "\t"}) EXPECT_EQ(separator(given), '\t') << given;
  for (const char* given : {"blank", "blanks", "space", " "}) EXPECT_EQ(separator(given), ' ') << given;
  for (const char* given : {"comma", ","}) EXPECT_EQ(separator(given), ',') << given;
  for (const char* given : {"semicolon", ";"}) EXPECT_EQ(separator(given), ';') << given;
  const auto decimal = [](const char* given) {
    ReadOptions options;
    options.decimal = given;
    return layout_of("1;2\n3;4\n", options)->decimal;
  };
  for (const char* given : {"point", "."}) EXPECT_EQ(decimal(given), '.') << given;
  for (const char* given : {"comma", ","}) EXPECT_EQ(decimal(given), ',') << given;
  ReadOptions wrong;
  wrong.delimiter = "|";
  EXPECT_EQ(in_words(layout_of("1;2\n", wrong).error()),
            "--delimiter \"|\" is not known: comma, semicolon, tab or blank is expected");
  wrong = {};
  wrong.decimal = "'";
  EXPECT_EQ(in_words(layout_of("1;2\n", wrong).error()),
            "--decimal \"'\" is not known: point or comma is expected");
}

TEST(Layout, SaysWhichOptionLeavesNoRows) {
  const auto refusal_of = [](const std::string& text, std::string delimiter, std::string decimal) {
    const auto layout = layout_of(text, {.delimiter = std::move(delimiter), .decimal = std::move(decimal)});
    return layout ? std::string() : in_words(layout.error());
  };
  EXPECT_EQ(refusal_of("0.5 1.5\n1.5 2.5\n", "semicolon", ""),
            "no rows of numbers are found with this --delimiter; without it there are some");
  EXPECT_EQ(refusal_of("0.5 1.5\n1.5 2.5\n", "", "comma"),
            "no rows of numbers are found with this --decimal; without it there are some");
  EXPECT_EQ(refusal_of("0.5 1.5\n1.5 2.5\n", "blank", "comma"),
            "no rows of numbers are found with this --decimal; without it there are some");
  EXPECT_EQ(refusal_of("a b\nc d\n", "", "comma"),
            "no rows of numbers are found: a table of numbers in columns is expected");
}

TEST(Layout, QuotedDecimalsAreFoundAnywhereInALine) {
  EXPECT_FALSE(layout_of("\"1\",\"2,5\"\n\"2\",\"3,5\"\n")->paired);
  EXPECT_EQ(layout_of("\"1\",\"2,5\"\n\"2\",\"3,5\"\n")->decimal, ',');
  EXPECT_EQ(columns_of("\"1\",\"2,5\"\n\"2\",\"3,5\"\n"), 2u);
}

TEST(TextColumnsOfLayout, HaveNoNumberBesideEnoughThatHave) {
  const auto text_of = [](const std::string& text, std::size_t columns, double rate = 0,
                          const std::vector<bool>& named_time = {}) {
    ReadOptions options;
    options.rate = rate;
    std::string found;
    for (const bool is_text :
         text_columns(split_lines(text), 0, Layout{';', '.', columns}, options, named_time))
      found += is_text ? 'T' : 'n';
    return found;
  };
  EXPECT_EQ(text_of("1;up\n2;down\n", 2), "");
  EXPECT_EQ(text_of("1;up\n2;down\n", 2, 10), "nT");
  EXPECT_EQ(text_of("up;1;2\n", 3), "Tnn");
  EXPECT_EQ(text_of("up;1;2;left\n", 4), "TnnT");
  EXPECT_EQ(text_of("up;1;2;left;far\n", 5), "");
  EXPECT_EQ(text_of("1;2;3\n", 3), "");
  // A number in any row, or one badly written; comments, blank lines and cells too many say nothing.
  EXPECT_EQ(text_of("up;1;2\n7;1;2\n", 3), "");
  EXPECT_EQ(text_of("up;1;2\n7x;1;2\n", 3), "");
  EXPECT_EQ(text_of("# 7;1;2\n\n;1;2\nup;3;4;5\n;nan;\n", 3), "Tnn");
  // Dates are text only beside a time.
  EXPECT_EQ(text_of("2024-05-06;1;2\n", 3), "");
  EXPECT_EQ(text_of("2024-05-06;1;2\n", 3, 0, {false, true}), "Tnn");
  EXPECT_EQ(text_of("2024-05-06;1;2\n", 3, 0, {true, false}), "");
}

TEST(FindData, ARowWithABadCellIsTheFirst) {
  const auto first = [](const std::string& text, std::size_t columns) {
    return find_data(split_lines(text), Layout{';', '.', columns});
  };
  EXPECT_EQ(first("t;x\n\n# 1;2\n1;abc\n2;3\n", 2), 3u);
  EXPECT_EQ(first("7\n1;2\n", 2), 1u);
  EXPECT_EQ(first("7 a\n1;2\n", 2), 1u);
  EXPECT_EQ(first("abc\n1\n2\n", 1), 1u);
  EXPECT_EQ(first("1a\n1\n2\n", 1), 1u);
  // No row is as wide: the first row of any width, else none.
  EXPECT_EQ(first("t\n1;2\n1\n", 3), 1u);
  EXPECT_EQ(first("t\na;b", 3), 2u);
}

/// The layout of rows between commas, settled; 0 columns where it cannot be.
Layout settled(const std::string& text, std::size_t columns) {
  const auto layout = settle_commas(split_lines(text), Layout{',', '.', columns}, {});
  return layout ? *layout : Layout{',', '.', 0};
}

TEST(Commas, WhatSettlesThem) {
  const auto open = [](const std::string& text, std::size_t columns) {
    return settled(text, columns).columns == 0;
  };
  EXPECT_TRUE(open("1,2\n3,4\n", 2));
  EXPECT_TRUE(open("-1,2\n+3,4\n", 2));
  EXPECT_TRUE(open("1,2e5\n3,4E5\n", 2));
  EXPECT_TRUE(open("1,2e5,3,4e5,5,6e5\n", 6));
  EXPECT_TRUE(open("\n1,2\n# 1.5,2\n3,4\n", 2));
  EXPECT_TRUE(open("1,2\n1.5\n3,4\n", 2));
  for (const char* rows : {"1,2\n3,-4\n", "1,2\n3,+4\n", "1.5,2\n", "1,2.5\n", "1e5,2\n", "1,\n", ",1\n",
                           "1,2\n\n# a\n3\n4,5.5\n", "\"1\",2\n", "1,2\n-,3\n"})
    EXPECT_EQ(settled(rows, 2).columns, 2u) << rows;
  EXPECT_EQ(settled("1,2,3\n", 3).columns, 3u);
  EXPECT_FALSE(open("1,2,3,-4\n", 4));
}

TEST(Commas, TheNamesAboveSettleThem) {
  const Layout one = settled("Position (m)\n\n1,2\n", 2);
  EXPECT_EQ(one.columns, 1u);
  EXPECT_EQ(one.separator, 0);
  EXPECT_EQ(one.decimal, ',');
  EXPECT_FALSE(one.paired);
  const Layout two = settled("Time (s);Position (m)\n1,2,3,4\n", 4);
  EXPECT_EQ(two.columns, 2u);
  EXPECT_EQ(two.separator, ',');
  EXPECT_TRUE(two.paired);
  EXPECT_EQ(settled("# Time\tPosition\n1,2,3,4\n", 4).columns, 2u);
  EXPECT_EQ(settled("#t\tx\n1,2,3,4\n", 4).columns, 2u);
  EXPECT_EQ(settled("t,x\n1,2\n", 2).columns, 2u);
  EXPECT_EQ(settled("Time;Position;a;b\n1,2,3,4\n", 4).columns, 4u);
  // Names that say nothing, commas between half as many, and lines further above.
  EXPECT_EQ(settled("Bob;Eve\n1,2,3,4\n", 4).columns, 0u);
  EXPECT_EQ(settled("Time;Eve\n1,2,3,4\n", 4).columns, 0u);
  EXPECT_EQ(settled("Time,Position\n1,2,3,4\n", 4).columns, 0u);
  EXPECT_EQ(settled("t,x\nby me\n1,2\n", 2).columns, 0u);
}

TEST(Commas, TheMessageShowsTheFirstRow) {
  const auto refused = settle_commas(split_lines("by me\n1,2,3,4\n5,6,7,8\n"), Layout{',', '.', 4}, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(in_words(refused.error()),
            "the rows can be read in two ways: \"1,2,3,4\" as 4 whole numbers or as 2 with a decimal comma; "
            "--delimiter comma says the one, --decimal comma the other");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects
