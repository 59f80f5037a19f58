// Lines to cells, cells to numbers.
#include "cromer/read/cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace cromer::core::dialects {
namespace {

using testing::ElementsAre;

std::vector<std::string_view> cells_of(std::string_view line, const Layout& layout) {
  std::vector<std::string_view> cells;
  split_cells(line, layout, cells);
  return cells;
}

TEST(Cells, QuotesMayHoldTheSeparatorAndQuotes) {
  const Layout comma{',', '.', 1}, tab{'\t', '.', 1};
  EXPECT_THAT(cells_of("\"a,b\",c", comma), ElementsAre("a,b", "c"));
  EXPECT_THAT(cells_of("\"a\"\",b\",c", comma), ElementsAre("a\"\",b", "c"));
  EXPECT_THAT(cells_of("\"a\"\"\",c", comma), ElementsAre("a\"\"", "c"));
  EXPECT_THAT(cells_of("\"\",c", comma), ElementsAre("", "c"));
  EXPECT_THAT(cells_of(" \t\"a,b\" ,c", comma), ElementsAre("a,b", "c"));
  EXPECT_THAT(cells_of("a,\" b \"", comma), ElementsAre("a", "b"));
  EXPECT_THAT(cells_of("\"a,b", comma), ElementsAre("\"a,b"));
  EXPECT_THAT(cells_of("\"a\"", comma), ElementsAre("a"));
  EXPECT_THAT(cells_of("\"", comma), ElementsAre("\""));
  EXPECT_THAT(cells_of("a\",b\"", comma), ElementsAre("a\"", "b\""));
  EXPECT_THAT(cells_of("\t\"a\tb\"\tc", tab), ElementsAre("", "a\tb", "c"));
  EXPECT_THAT(cells_of("\"a b\"  c", Layout{' ', '.', 1}), ElementsAre("a b", "c"));
}

TEST(Cells, EmptyOnesAtTheEndsAreCells) {
  EXPECT_THAT(cells_of("", Layout{}), ElementsAre(""));
  EXPECT_THAT(cells_of(",", Layout{}), ElementsAre("", ""));
  EXPECT_THAT(cells_of("a,,", Layout{}), ElementsAre("a", "", ""));
  EXPECT_THAT(cells_of("  a \t b  ", Layout{' ', '.', 1}), ElementsAre("a", "b"));
  EXPECT_THAT(cells_of(" a, b ", Layout{0, '.', 1}), ElementsAre("a, b"));
}

TEST(Cells, PairsOfPiecesAreCells) {
  const Layout paired{',', ',', 2, true};
  EXPECT_THAT(cells_of("1,5,2,25", paired), ElementsAre("1,5", "2,25"));
  EXPECT_THAT(cells_of("1,5,2", paired), ElementsAre("1,5", "2"));
  EXPECT_THAT(cells_of("\"1,5\",2,25,3,5", paired), ElementsAre("1,5", "2,25", "3,5"));
  EXPECT_TRUE(commas_pair_up("1,5,2,25", paired));
  EXPECT_FALSE(commas_pair_up("1,5,2", paired));
  EXPECT_FALSE(commas_pair_up("1,5", paired));
  EXPECT_FALSE(commas_pair_up("1,5,2,5,3,5", paired));
  const Layout any_width{',', ',', 1, true};
  EXPECT_TRUE(commas_pair_up("1,5,2,5,3,5", any_width));
  EXPECT_FALSE(commas_pair_up("1,5,2", any_width));
  EXPECT_TRUE(commas_pair_up("1,5,2", Layout{',', ',', 2, false}));
}

TEST(Cells, ANumberUpToItsSeparatorIsTakenAtOnce) {
  double value = 0;
  CellReader reader("1.5;-2;3", Layout{';', '.', 3});
  EXPECT_TRUE(reader.next_number(value));
  EXPECT_EQ(value, 1.5);
  EXPECT_TRUE(reader.next_number(value));
  EXPECT_TRUE(reader.next_number(value));
  EXPECT_EQ(value, 3);
  EXPECT_FALSE(reader.next_number(value));
  std::string_view cell;
  EXPECT_FALSE(reader.next(cell));
  for (const char* other : {"", "a;1", "1 ;1", "1e999;1", "1a;1", "\"1\";1"})
    EXPECT_FALSE(CellReader(other, Layout{';', '.', 2}).next_number(value)) << other;
  EXPECT_FALSE(CellReader("1,;2", Layout{';', ',', 2}).next_number(value));
  EXPECT_TRUE(CellReader("1,5;2", Layout{';', ',', 2}).next_number(value));
  EXPECT_FALSE(CellReader("1 2", Layout{' ', '.', 2}).next_number(value));
  EXPECT_FALSE(CellReader("1,5", Layout{',', ',', 1, true}).next_number(value));
}

TEST(Cells, AreNumbersMissingOrWords) {
  EXPECT_EQ(read_cell("1.", '.').value, 1);
  EXPECT_EQ(read_cell("1,5", ',').value, 1.5);
  for (const char* word : {"1,", "1.5", "1 2", "1e999", "abc", "nano", "n"})
    EXPECT_EQ(read_cell(word, ',').kind, CellKind::word) << word;
  for (const char* mark : {"", "NaN", "Null", "NA", "n/a", "#N/A", "-", "--", "---", "Inf", "-inf",
                           "undefined", "Undef", "-nan", "None", "Infinity"}) {
    EXPECT_EQ(read_cell(mark, '.').kind, CellKind::missing) << mark;
    EXPECT_TRUE(std::isnan(read_cell(mark, '.').value)) << mark;
  }
}

TEST(Cells, AreShownShort) {
  const std::string longest(40, 'a');
  EXPECT_EQ(dialects::shown(longest), longest);
  EXPECT_EQ(dialects::shown(longest + "b"), longest + "…");
  EXPECT_EQ(dialects::shown(longest.substr(1) + "äb"), longest.substr(1) + "…");
  EXPECT_EQ(dialects::shown(longest.substr(2) + "äb"), longest.substr(2) + "ä…");
  EXPECT_EQ(dialects::shown(std::string(60, '\x80')), "…");
  EXPECT_EQ(dialects::shown(" a\x1F\t\x7F~"), " a???~");
  EXPECT_EQ(dialects::shown(""), "");
}

}  // namespace
}  // namespace cromer::core::dialects
