// Reports with everything that can stand in one, as they are laid on sheets and written as HTML:
// tests/report/pictures/report_*.txt.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cromer/report/page.h"
#include "cromer/report/paper.h"
#include "tests/support/written_down.h"

namespace cromer::core {
namespace CROMER_FILE {

std::string repeated(int times, const std::string& words) {
  std::string all;
  for (int i = 0; i < times; ++i) all += words;
  return all;
}

FigureBlock square(double width, double height, double share, const std::string& caption) {
  return {"figure-1",
          fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
                      "height=\"{1}\"><rect width=\"{0}\" height=\"{1}\"/></svg>",
                      width, height),
          "a square",
          "Figure 1",
          caption,
          share};
}

TableBlock narrow_table() {
  TableBlock table;
  table.caption = "Springs, *k* and what was measured";
  table.header = {"spring", "remark", "*k* (N/m)", "answer"};
  table.rows = {
      {"steel", "as it came", "17.04", "17.1 ± 0.2"},
      {"brass", "as it came", "9.5", "9.6 ± 0.1"},
      {"steel", "cut in two and bent at one end, so that it may be hung up again", "34.1", "34 ± 1"}};
  table.text_columns = {0, 1}, table.answer_column = 3;
  return table;
}

/// Too wide for the column in its own size.
TableBlock wide_table(int columns) {
  TableBlock table;
  table.label = "Table A";
  for (int c = 0; c < columns; ++c) {
    table.header.push_back("quantity " + std::to_string(c));
    table.rows.resize(2);
    for (int r = 0; r < 2; ++r) table.rows[r].push_back(fmt::format("{}.1234 ± 0.0{}", 100 * r + c, c + 1));
  }
  return table;
}

/// Over several sheets, with a cell that is shared, one that is longer than a sheet, and no header.
TableBlock long_table() {
  TableBlock table;
  table.text_columns = {0, 1, 2};
  for (int r = 0; r < 45; ++r)
    table.rows.push_back({std::to_string(r), r < 30 ? "the same for many" : "others",
                          r == 40 ? repeated(180, "a word and ") : "row", std::to_string(r * r)});
  return table;
}

Page everything() {
  Page page;
  page.title = "A *disc* on a spring whose title is so long that one line of a sheet cannot hold it";
  page.byline = "Lab two";
  page.summary = "What came out: *k* = 17.04 ± 0.02 N/m.\n\nAnd a second paragraph.";
  page.key_figures = {{"frequency", "1.408 Hz", "period 0.71 s"},
                      {"spring", "17.04 N/m", ""},
                      {"a value that is long", "1234567890123.4567 N/m", "made smaller"},
                      {"last of row", "2", "x"},
                      {"fifth", "5", "in the second row"}};
  page.blocks.push_back(Heading{"What is *seen*"});
  page.blocks.push_back(
      Paragraph{"The motion *x*_{0} with **bold**, `code`, e^{−t}, *ω*_{d}^{2} and "
                "*γ*_{longer}^{2}, e^{x_{0}}. " +
                repeated(12, "A sentence of some words. ")});
  page.blocks.push_back(
      Code{"cromer fit\n\n  " + repeated(12, "--option value ") + "\nlast line\n", "As typed"});
  page.blocks.push_back(narrow_table());
  page.blocks.push_back(Paragraph{"After the table."});
  page.blocks.push_back(square(760, 440, 1, repeated(6, "A caption of more than a line. ")));
  page.blocks.push_back(square(420, 300, 0.5, "Left."));
  page.blocks.push_back(square(420, 385, 0.5, repeated(4, "Right, and higher. ")));
  page.blocks.push_back(square(420, 300, 0.5, "A half alone."));
  page.blocks.push_back(Heading{"Tables"});
  for (const int columns : {6, 7, 8}) page.blocks.push_back(wide_table(columns));
  page.blocks.push_back(square(400, 4000, 1, "High, and shrunk to the sheet."));
  page.blocks.push_back(long_table());
  page.blocks.push_back(Code{repeated(70, "line\n"), ""});
  page.footer = "cromer 1.0";
  return page;
}

std::filesystem::path page_picture(const std::string& name) {
  return std::string(CROMER_SOURCE_DIR) + "/tests/report/pictures/" + name + ".txt";
}

std::string sheets_drawn(const Page& page, Typeface typeface) {
  std::string all;
  for (const Sheet& sheet : sheets_of(page, typeface)) {
    all += "sheet\n";
    for (const Printed& printed : sheet)
      all += fmt::format("{:.2f} {:.2f} {:.2f} {:.2f} {}\n", printed.box.x, printed.box.y, printed.box.width,
                         printed.box.height, printed.svg);
  }
  return all;
}

TEST(Sheets, AreAsWrittenDown) {
  test::expect_as_written_down(sheets_drawn(everything(), Typeface::lato), page_picture("report_sheets"));
}

TEST(Sheets, OfDejaVuSansAreAsWrittenDown) {
  Page page = everything();
  page.blocks.resize(10);
  test::expect_as_written_down(sheets_drawn(page, Typeface::dejavu_sans),
                               page_picture("report_sheets_dejavu"));
}

TEST(Sheets, AreWrittenAsSvgAndHtmlAsWrittenDown) {
  Page page = everything();
  page.blocks.resize(11);
  test::expect_as_written_down(to_html(page), page_picture("report_html"));
  page.blocks.resize(1);
  page.key_figures.resize(3);
  test::expect_as_written_down(to_svg(sheets_of(page, Typeface::lato).at(0), Typeface::lato, "de"),
                               page_picture("report_svg"));
}

/// On how many sheets a table of so many rows stands that begins in the last fifth of the first one.
int sheets_of_table(int rows) {
  Page page;
  page.title = "t";
  page.blocks.push_back(Code{repeated(45, "line\n"), ""});
  TableBlock table;
  table.header = {"n"};
  for (int r = 0; r < rows; ++r) table.rows.push_back({"row"});
  page.blocks.push_back(table);
  int sheets = 0;
  for (const Sheet& sheet : sheets_of(page, Typeface::lato))
    sheets += std::any_of(sheet.begin(), sheet.end(), [](const Printed& printed) {
      return printed.svg.find(">row<") != std::string::npos;
    });
  return sheets;
}

TEST(Sheets, ATableOfUpToAThirdOfASheetStandsOnOne) {
  // A sheet has 986.5 px; a header 23, a row 24.5: 12 of them are 317 px, 13 are 341.5.
  EXPECT_EQ(sheets_of_table(12), 1);
  EXPECT_EQ(sheets_of_table(13), 2);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
