// Lines to cells, cells to numbers; what is none is said with its cure.
#include "cromer/read/cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/base/concat.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/recording.h"
#include "tests/read/reading.h"

namespace cromer::core::dialects {
namespace CROMER_FILE {

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

}  // namespace CROMER_FILE
}  // namespace cromer::core::dialects

namespace cromer::core {
namespace CROMER_FILE {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string bad_cell(std::string_view cell, char decimal) {
  return in_words(dialects::bad_cell(cell, decimal));
}

TEST(BadCell, IsCalledByItsName) {
  EXPECT_EQ(bad_cell("1,000.0", '.'), "it has thousands separators: write 1000.0");
  EXPECT_EQ(bad_cell("-1.234.567,5", ','), "it has thousands separators: write -1234567,5");
  EXPECT_EQ(bad_cell("12:00:00.50", '.'), "it is a clock time: write the seconds since the start");
  EXPECT_EQ(bad_cell("2024-03-01T12:00:00", '.'), "it is a date: write the seconds since the start");
  EXPECT_EQ(bad_cell("01.03.2024", '.'), "it is a date: write the seconds since the start");
  EXPECT_EQ(bad_cell("1.5D-03", '.'), "it has Fortran's exponent: write 1.5E-03");
  EXPECT_THAT(bad_cell("-1e309", '.'), HasSubstr("too large"));
  EXPECT_THAT(bad_cell("1,5", '.'), HasSubstr("the decimal mark of this file is a point"));
  EXPECT_EQ(bad_cell("abc", '.'), "");
  EXPECT_EQ(bad_cell("", '.'), "");
  EXPECT_EQ(bad_cell("1.2.3.4", '.'), "");
}

TEST(BadCell, ThousandsStandInThrees) {
  const auto write = [](std::string_view number) {
    return concat({"it has thousands separators: write ", number});
  };
  EXPECT_EQ(bad_cell("1,234,567", '.'), write("1234567"));
  EXPECT_EQ(bad_cell("1.234.567", '.'), write("1234567"));
  EXPECT_EQ(bad_cell("+123,456.", '.'), write("+123456."));
  EXPECT_EQ(bad_cell("12.345,6", '.'), write("12345.6"));
  EXPECT_EQ(bad_cell("12.345,6", ','), write("12345,6"));
  EXPECT_EQ(bad_cell("1,234,567.25", ','), write("1234567,25"));
  for (const char* none : {"1,234", "1.234", "1234,567.5", "1,23,456.5", "1,2345.5", "1,234.5x", "1,234x5",
                           ",234.5", "-,234.5", "1,234,", "1,234,56", "1,x34.5", "1,2x4.5", "1,23x.5"})
    EXPECT_EQ(bad_cell(none, '.').find("thousands"), std::string::npos) << none;
}

TEST(BadCell, DatesAndClockTimesAreTold) {
  for (const char* date : {"1-2-2024", "01/02/24", "01.02.2024 12:00", "1.2.24"})
    EXPECT_THAT(bad_cell(date, '.'), StartsWith("it is a date")) << date;
  for (const char* clock : {"12:00", "1:2:3", "00:00:01,5 h"})
    EXPECT_THAT(bad_cell(clock, '.'), StartsWith("it is a clock time")) << clock;
  for (const char* none : {"1.2.3.4", ":00", "a12:00", "1-2", "1/2"}) EXPECT_EQ(bad_cell(none, '.'), "");
}

TEST(BadCell, ExponentsAndDecimalMarksAreTold) {
  EXPECT_EQ(bad_cell("1d2", '.'), "it has Fortran's exponent: write 1E2");
  EXPECT_EQ(bad_cell("1,5D2", ','), "it has Fortran's exponent: write 1,5E2");
  for (const char* none : {"d2", "1D", "D", "1Dx"}) EXPECT_EQ(bad_cell(none, '.'), "") << none;
  EXPECT_EQ(bad_cell("1,5", '.'), "the decimal mark of this file is a point");
  EXPECT_EQ(bad_cell("1.5", ','), "the decimal mark of this file is a comma");
  EXPECT_EQ(bad_cell("1e309", '.'), "it is too large: numbers end at 1.8e308");
  EXPECT_EQ(bad_cell("1e309x", '.'), "");
}

TEST(BadCell, IsNamedInAColumn) {
  EXPECT_THAT(refusal("t;x\n0;1.5\n1;1,000.0\n2;2.5\n"),
              AllOf(StartsWith("lab.txt:3: column \"x\": \"1,000.0\""), HasSubstr("write 1000.0")));
  EXPECT_THAT(refusal("t,x\n0,1.5\n1,-1e309\n2,2.5\n"),
              AllOf(StartsWith("lab.txt:3: column \"x\": \"-1e309\""), HasSubstr("too large")));
}

TEST(BadCell, IsNamedWhereNoRowIsLeft) {
  for (const bool skip : {false, true}) {
    ReadOptions options;
    options.skip_bad_rows = skip;
    EXPECT_THAT(
        refusal("t,x\n12:00:00.50,1.5\n12:00:00.60,2.5\n", options),
        AllOf(StartsWith("lab.txt:2: "), HasSubstr("\"12:00:00.50\" is not a number; it is a clock time")));
    EXPECT_THAT(refusal("t;x\n0;1,001.0\n1;1,000.0\n", options),
                AllOf(StartsWith("lab.txt:2: "), HasSubstr("write 1001.0")));
    EXPECT_THAT(refusal("t x\n0.0D0 1.5D-03\n1.0D0 2.5D-03\n", options),
                AllOf(StartsWith("lab.txt:2: "), HasSubstr("Fortran")));
  }
}

TEST(BadCell, HalfOfTheRowsAreNotMost) {
  ReadOptions options;
  options.skip_bad_rows = true;
  const auto recording = read_recording("t;x\n0;1\n1;2\n2;abc\n3;abc\n", "lab.txt", options);
  ASSERT_TRUE(recording.ok());
  EXPECT_EQ(in_words(recording->notices).at(0), "2 bad rows left out, the first in line 4");
}

TEST(BadCell, MostRowsLostIsSaidFirst) {
  std::string text = "t;x\n0;1\n1;2\n2;3\n";
  for (int i = 3; i < 7; ++i) text += concat({std::to_string(i), ";1,000.5\n"});
  ReadOptions options;
  options.skip_bad_rows = true;
  const auto recording = read_recording(text, "lab.txt", options);
  ASSERT_TRUE(recording.ok());
  EXPECT_THAT(in_words(recording->notices).at(0),
              AllOf(StartsWith("MOST ROWS ARE LOST: 4 bad rows left out, 3 rows kept, the first in line 5"),
                    HasSubstr("thousands")));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
