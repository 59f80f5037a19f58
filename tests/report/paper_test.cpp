// The sheets of a report, their texts and boxes; and, where librsvg and poppler's pdftotext are installed,
// what the PDF holds.
#include "cromer/report/paper.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "cromer/documents/words/words.h"
#include "cromer/report/figure.h"
#include "cromer/report/file.h"
#include "tests/report/overlap.h"
#include "tests/support/xml.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::Contains;
using testing::HasSubstr;

std::string filled(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t i = 0; (i = text.find(what, i)) != std::string::npos; i += with.size())
    text.replace(i, what.size(), with);
  return text;
}

/// What a text says, without its tags.
std::string said(const Printed& printed) {
  std::string words = std::regex_replace(printed.svg, std::regex("<[^>]*>"), "");
  words = filled(words, "\u00A0", " ");
  for (const auto& [name, sign] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&#39;", "'"}, {"&quot;", "\""}, {"&amp;", "&"}})
    words = filled(words, name, sign);
  return words;
}

std::vector<Printed> texts(const Sheet& sheet) {
  std::vector<Printed> found;
  for (const Printed& printed : sheet)
    if (printed.kind == Printed::Kind::text) found.push_back(printed);
  return found;
}

/// All lines of a sheet but the page's number.
std::vector<std::string> lines(const Sheet& sheet) {
  std::vector<std::string> found;
  for (const Printed& text : texts(sheet)) found.push_back(said(text));
  found.pop_back();
  return found;
}

std::string all_words(const std::vector<Sheet>& sheets) {
  std::string words;
  for (const Sheet& sheet : sheets)
    for (const std::string& line : lines(sheet)) words += line + ' ';
  return words;
}

std::size_t count(const std::vector<std::string>& lines, const std::string& line) {
  return static_cast<std::size_t>(std::count(lines.begin(), lines.end(), line));
}

/// Every text and figure is between the margins, and none lies on another.
void expect_clean(const std::vector<Sheet>& sheets) {
  for (const Sheet& sheet : sheets) {
    EXPECT_EQ(test::xml_fault(to_svg(sheet, Typeface::lato, "en")), "");
    std::vector<Printed> seen;
    for (const Printed& printed : sheet) {
      EXPECT_GE(printed.box.x, side_margin - 1e-6) << said(printed);
      EXPECT_LE(printed.box.right(), sheet_width - side_margin + 1e-6) << said(printed);
      EXPECT_GE(printed.box.y, upper_margin - 1e-6) << said(printed);
      // The sheet's number and the page's footer stand in the margin.
      const bool in_margin = printed.box.y > sheet_height - upper_margin;
      EXPECT_LE(printed.box.bottom(), in_margin ? sheet_height - 20 : sheet_height - upper_margin + 1)
          << said(printed);
      if (printed.kind == Printed::Kind::ground) continue;
      const Box& box = printed.box;
      const Box inner{box.x + 0.01, box.y + 0.01, box.width - 0.02, box.height - 0.02};
      for (const Printed& other : seen)
        EXPECT_FALSE(overlap(inner, other.box)) << said(printed) << " on " << said(other);
      seen.push_back(printed);
    }
  }
}

std::vector<Sheet> sheets_of_blocks(std::vector<Block> blocks, Typeface typeface = Typeface::lato) {
  Page page;
  page.blocks = std::move(blocks);
  const auto sheets = sheets_of(page, typeface);
  expect_clean(sheets);
  return sheets;
}

std::string picture(int width, int height) {
  return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
         std::to_string(width) + ' ' + std::to_string(height) +
         "\" font-family=\"Serif\"><text x=\"9\" y=\"20\">inside</text></svg>\n";
}

FigureBlock figure(int number, double width, int across = 760, int high = 300) {
  const std::string n = std::to_string(number);
  return {"figure-" + n, picture(across, high), "", "Figure " + n, "Caption of " + n + ".", width};
}

TableBlock table_of(std::size_t rows) {
  TableBlock table;
  table.caption = "Rates.";
  table.header = {"part", "rate (1/s)", "remark"};
  for (std::size_t r = 0; r < rows; ++r)
    table.rows.push_back(
        {"row " + std::to_string(r), std::to_string(r) + ".5", "remark " + std::to_string(r)});
  table.text_columns = {0, 2};
  table.answer_column = 1;
  return table;
}

Paragraph long_paragraph(int sentences) {
  std::string text;
  for (int i = 0; i < sentences; ++i) text += "The spring pulls the mass back, and the mass overshoots. ";
  return {text};
}

Page german() {
  Page page;
  page.title = "Die *Dämpfung* <einer> Feder";
  page.byline = "Versuch zwei · größer als üblich";
  page.summary =
      "Die Federkonstante ist 17.04 ± 0.02 N/m, die Steigung −0.5.\n\nDas Maß *ω*_{d}^{2} fällt um 10^{−3}.";
  page.key_figures = {{"Frequenz", "1.408 ± 0.001 Hz", "Periode 0.71 s"},
                      {"Rate", "0.0098(4) 1/s", ""},
                      {"Re", "2500", "Luft"}};
  page.blocks = {Heading{"Wie steif?"},
                 long_paragraph(4),
                 table_of(4),
                 figure(1, 0.5, 420, 300),
                 figure(2, 0.5, 420, 385),
                 figure(3, 1),
                 Code{"a = b\n  c = \"<d>\"\n", "So:"},
                 Heading{"Wie *lange*?"},
                 long_paragraph(30),
                 table_of(30)};
  page.footer = "cromer 0.1.0";
  page.language = "de";
  return page;
}

TEST(Paper, EveryTextOfThePageOccurs) {
  for (const Typeface typeface : {Typeface::lato, Typeface::dejavu_sans}) {
    const auto sheets = sheets_of(german(), typeface);
    expect_clean(sheets);
    const std::string words = all_words(sheets);
    for (const char* text : {"Die Dämpfung <einer> Feder",
                             "größer als üblich",
                             "17.04 ± 0.02 N/m",
                             "−0.5.",
                             "10−3.",
                             "Frequenz",
                             "1.408 ± 0.001 Hz",
                             "Periode 0.71 s",
                             "1\u2002Wie steif?",
                             "2\u2002Wie lange?",
                             "Table 1. Rates.",
                             "Table 2. Rates.",
                             "Figure 1. Caption of 1.",
                             "Figure 3. Caption of 3.",
                             "So:",
                             "a = b",
                             "  c = \"<d>\"",
                             "cromer 0.1.0",
                             "row 29",
                             "remark 29"})
      EXPECT_THAT(words, HasSubstr(text));
    EXPECT_THAT(to_svg(sheets.front(), typeface, "de"), HasSubstr("xml:lang=\"de\""));
  }
}

TEST(Paper, TheFooterStandsInTheLastMarginAndNeedsNoSheetOfItsOwn) {
  Page page;
  page.footer = "cromer 0.1.0 · g++ 12.2.0";
  for (int lines = 30; lines < 80; ++lines) {
    page.blocks.assign(static_cast<std::size_t>(lines), Paragraph{"Line."});
    const auto with = sheets_of(page, Typeface::lato);
    expect_clean(with);
    Page without = page;
    without.footer.clear();
    EXPECT_EQ(with.size(), sheets_of(without, Typeface::lato).size()) << lines;
    EXPECT_THAT(all_words({with.back()}), HasSubstr("g++")) << lines;
    if (with.size() > 1) {
      EXPECT_THAT(all_words({with.front()}), testing::Not(HasSubstr("g++"))) << lines;
    }
  }
}

TEST(Paper, SheetsAreNumbered) {
  const auto sheets = sheets_of(german(), Typeface::lato);
  ASSERT_EQ(sheets.size(), 3u);
  for (std::size_t i = 0; i < sheets.size(); ++i)
    EXPECT_EQ(said(sheets[i].back()), std::to_string(i + 1) + " / 3");
  EXPECT_EQ(sheets_of({}, Typeface::lato).size(), 1u);
}

TEST(Paper, ATableRepeatsItsHeaderOnEachSheet) {
  const auto sheets = sheets_of_blocks({table_of(100)});
  ASSERT_EQ(sheets.size(), 3u);
  std::size_t next = 0;
  for (const Sheet& sheet : sheets) {
    const auto seen = lines(sheet);
    EXPECT_EQ(count(seen, "rate (1/s)"), 1u);
    for (const std::string& line : seen)
      if (line.starts_with("row ")) {
        EXPECT_EQ(line, "row " + std::to_string(next++));
      }
  }
  EXPECT_EQ(next, 100u);
  EXPECT_EQ(count(lines(sheets[1]), "Table 1. Rates."), 0u);
}

TEST(Paper, NumbersAreAlignedAtTheRightWordsAtTheLeftAnswersBold) {
  const auto sheets = sheets_of_blocks({table_of(12)});
  std::set<int> numbers, words;
  for (const Printed& text : texts(sheets[0])) {
    const std::string line = said(text);
    if (line.ends_with(".5")) {
      numbers.insert(static_cast<int>(std::lround(100 * text.box.right())));
      EXPECT_THAT(text.svg, HasSubstr("font-weight=\"bold\""));
      EXPECT_THAT(text.svg, HasSubstr("text-anchor=\"end\""));
    }
    if (line.starts_with("remark ")) words.insert(static_cast<int>(std::lround(100 * text.box.x)));
  }
  EXPECT_EQ(numbers.size(), 1u);
  EXPECT_EQ(words.size(), 1u);
}

TEST(Paper, CellsWithTheSameWordsAreOneOnEachSheet) {
  TableBlock table = table_of(90);
  for (auto& row : table.rows) row[2] = "the same";
  const auto sheets = sheets_of_blocks({table});
  ASSERT_GE(sheets.size(), 3u);
  for (const Sheet& sheet : sheets) {
    const auto seen = lines(sheet);
    EXPECT_GE(count(seen, "the same"), 1u);
    EXPECT_LE(count(seen, "the same"), 4u);
  }
  table = table_of(3);
  table.rows[0][2] = table.rows[1][2] = "words for two rows";
  EXPECT_EQ(count(lines(sheets_of_blocks({table})[0]), "words for two rows"), 1u);
}

TEST(Paper, LongCellsAreWrappedAndARowHigherThanASheetGoesOn) {
  TableBlock table = table_of(2);
  table.rows[0][2] = long_paragraph(5).text + "END ONE";
  table.rows[1][2] = long_paragraph(150).text + "END TWO";
  const auto sheets = sheets_of_blocks({table});
  EXPECT_GE(sheets.size(), 2u);
  EXPECT_THAT(all_words(sheets), HasSubstr("END ONE"));
  EXPECT_THAT(all_words(sheets), HasSubstr("END TWO"));
}

TEST(Paper, AWideTableStaysBetweenTheMargins) {
  TableBlock table;
  for (int c = 0; c < 14; ++c) table.header.push_back("column " + std::to_string(c));
  table.rows.emplace_back(14, "123.456(7)");
  table.rows.emplace_back(14, "a_long_name_of_something_that_has_no_blank");
  const auto sheets = sheets_of_blocks({table});
  EXPECT_EQ(sheets.size(), 1u);
}

TEST(Paper, BesideALongNameNumbersStayInOneLine) {
  TableBlock table;
  table.header = {"recording", "frequency", "decay rate at the start", "decay rate at the end"};
  table.rows = {{"spring_with_a_full_disc_that_beats_0.1419kg_driven_at_1.207hz.csv", "1.22224 ± 0.00018 Hz",
                 "0.0566 ± 0.0015 1/s", "0.0197 ± 0.0007 1/s"}};
  table.text_columns = {0};
  const auto printed = lines(sheets_of_blocks({table})[0]);
  for (std::size_t c = 1; c < 4; ++c) EXPECT_EQ(count(printed, table.rows[0][c]), 1u) << table.rows[0][c];
  EXPECT_THAT(printed, Contains(testing::EndsWith("_"))) << "broken between its words";
}

TEST(Paper, AHeadingNeverStandsAloneAtTheFoot) {
  const std::vector<Block> followers = {long_paragraph(3), figure(1, 1), table_of(40), Code{"a\nb\nc", "So:"},
                                        Code{"a\nb\nc", ""}};
  std::set<std::size_t> sheet_of_heading;
  for (const Block& follower : followers)
    for (int filling = 38; filling < 60; ++filling) {
      const auto sheets =
          sheets_of_blocks({Code{std::string(static_cast<std::size_t>(filling), '\n') + "x", ""},
                            Heading{"A heading"}, follower});
      for (std::size_t i = 0; i < sheets.size(); ++i) {
        const auto seen = texts(sheets[i]);
        for (std::size_t k = 0; k + 1 < seen.size(); ++k)
          if (said(seen[k]).ends_with("A heading")) {
            sheet_of_heading.insert(i);
            const bool is_last = k + 2 == seen.size();
            EXPECT_TRUE(!is_last || std::holds_alternative<FigureBlock>(follower)) << filling;
            const auto has_figure =
                std::any_of(sheets[i].begin(), sheets[i].end(),
                            [](const Printed& printed) { return printed.kind == Printed::Kind::figure; });
            EXPECT_EQ(has_figure, std::holds_alternative<FigureBlock>(follower)) << filling;
          }
      }
    }
  EXPECT_EQ(sheet_of_heading, (std::set<std::size_t>{0, 1}));
}

TEST(Paper, NoLineOfAParagraphStandsAlone) {
  for (int filling = 40; filling < 64; ++filling) {
    const auto sheets = sheets_of_blocks(
        {Code{std::string(static_cast<std::size_t>(filling), '\n') + "x", ""}, long_paragraph(6)});
    for (const Sheet& sheet : sheets) {
      const auto seen = lines(sheet);
      const auto of_it =
          std::count_if(seen.begin(), seen.end(), [](const std::string& line) { return line.size() > 1; });
      EXPECT_NE(of_it, 1) << filling;
    }
  }
}

std::vector<Box> figures_on(const Sheet& sheet) {
  std::vector<Box> found;
  for (const Printed& printed : sheet)
    if (printed.kind == Printed::Kind::figure) found.push_back(printed.box);
  return found;
}

TEST(Paper, FiguresKeepTheirProportionsAndHalvesStandSideBySide) {
  const auto sheets = sheets_of_blocks(
      {figure(1, 0.5, 420, 300), figure(2, 0.5, 420, 385), figure(3, 1), figure(4, 0.5, 420, 300)});
  const auto boxes = figures_on(sheets[0]);
  ASSERT_EQ(boxes.size(), 4u);
  EXPECT_EQ(boxes[0].y, boxes[1].y);
  EXPECT_GT(boxes[1].x, boxes[0].right());
  EXPECT_NEAR(boxes[0].width / boxes[0].height, 420.0 / 300, 1e-9);
  EXPECT_NEAR(boxes[1].width / boxes[1].height, 420.0 / 385, 1e-9);
  EXPECT_NEAR(boxes[2].width / boxes[2].height, 760.0 / 300, 1e-9);
  EXPECT_NEAR(boxes[2].width, sheet_width - 2 * side_margin, 1e-9);
  EXPECT_NEAR(boxes[3].width, boxes[0].width, 1e-9);
}

TEST(Paper, AFigureHigherThanASheetIsMadeSmaller) {
  const auto sheets = sheets_of_blocks({long_paragraph(3), figure(1, 1, 400, 2000)});
  ASSERT_EQ(sheets.size(), 2u);
  const auto boxes = figures_on(sheets[1]);
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_NEAR(boxes[0].height / boxes[0].width, 5, 1e-9);
  EXPECT_EQ(count(lines(sheets[1]), "Figure 1. Caption of 1."), 1u);
}

TEST(Paper, WhatIsNoFigureLeavesItsCaption) {
  FigureBlock none = figure(1, 1);
  none.svg = "none";
  EXPECT_EQ(lines(sheets_of_blocks({none})[0]), std::vector<std::string>{"Figure 1. Caption of 1."});
}

TEST(Paper, OurFiguresHaveNoIdsThatCouldCollide) {
  Figure drawn;
  drawn.panels.resize(1);
  Curve& curve = drawn.panels[0].curves.emplace_back();
  curve.x = {0, 1, 2}, curve.y = {0, 1, 0}, curve.role = "measured", curve.name = "swing";
  const auto svg = draw(drawn, FigureFormat::svg);
  ASSERT_TRUE(svg.ok());
  EXPECT_THAT(*svg, testing::Not(HasSubstr(" id=")));
  FigureBlock block = figure(1, 1);
  block.svg = *svg;
  const auto sheets = sheets_of_blocks({block});
  EXPECT_THAT(to_svg(sheets[0], Typeface::lato, "en"), HasSubstr("font-family=\"inherit\""));
}

TEST(Paper, ScriptsStandAboveAndBelowTheLine) {
  const auto sheets = sheets_of_blocks({Paragraph{"x_{0} y^{2} *ω*_{d}^{22} end"}});
  const std::string svg = texts(sheets[0])[0].svg;
  EXPECT_THAT(svg,
              HasSubstr("<tspan font-size=\"10.08\" dy=\"2.52\">0</tspan><tspan dy=\"-2.52\"> y</tspan>"));
  EXPECT_THAT(svg, HasSubstr("<tspan font-size=\"10.08\" dy=\"-5.04\">2</tspan>"));
  // The narrower first; the wider begins where that began.
  EXPECT_TRUE(
      std::regex_search(svg, std::regex("dy=\"3.64\">d</tspan><tspan[^>]* dx=\"-[0-9.]+\">22</tspan>")))
      << svg;
}

TEST(Paper, ALongWordIsBroken) {
  const std::string path(300, 'm');
  const auto sheets = sheets_of_blocks({Paragraph{"See `" + path + "` and " + path}, Code{path, ""}});
  EXPECT_EQ(std::regex_replace(all_words(sheets), std::regex("[^m]"), "").size(), 900u);
}

/// The PDF's words with their boxes [pt], read by poppler.
struct PdfWord {
  std::size_t sheet = 0;
  double left = 0, top = 0, right = 0, bottom = 0;
  std::string text;
};

class PaperPdf : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("pdftotext -v >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  }

  static std::string output_of(const std::string& pdf, const std::string& options) {
    const std::string path =
        testing::TempDir() + "paper_" + testing::UnitTest::GetInstance()->current_test_info()->name();
    EXPECT_TRUE(write_file(path + ".pdf", pdf).ok());
    EXPECT_EQ(std::system(("pdftotext " + options + ' ' + path + ".pdf " + path + ".out").c_str()), 0);
    const auto text = read_file(path + ".out");
    std::filesystem::remove(path + ".pdf");
    std::filesystem::remove(path + ".out");
    return text ? *text : "";
  }

  static std::vector<PdfWord> words_in(const std::string& pdf) {
    std::vector<PdfWord> words;
    std::istringstream boxes(output_of(pdf, "-bbox"));
    std::size_t sheet = 0;
    const std::regex word(
        "<word xMin=\"([0-9.]+)\" yMin=\"([0-9.]+)\" xMax=\"([0-9.]+)\" yMax=\"([0-9.]+)\">(.*)</word>");
    for (std::string line; std::getline(boxes, line);) {
      std::smatch found;
      if (line.find("<page ") != std::string::npos) ++sheet;
      if (std::regex_search(line, found, word))
        words.push_back({sheet, std::stod(found[1]), std::stod(found[2]), std::stod(found[3]),
                         std::stod(found[4]), found[5]});
    }
    return words;
  }
};

TEST_F(PaperPdf, HoldsTheWordsBetweenTheMargins) {
  const auto pdf = to_pdf(german());
  if (!pdf && pdf.error().notice.code == "librsvg_is_missing") GTEST_SKIP() << in_words(pdf.error());
  ASSERT_TRUE(pdf.ok()) << in_words(pdf.error());
  const std::string text = output_of(*pdf, "-raw");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\f'), 3);
  for (const char* words :
       {"Die Dämpfung <einer> Feder", "größer als üblich", "−0.5", "Wie lange?", "remark 29"})
    EXPECT_THAT(text, HasSubstr(words));
  const auto words = words_in(*pdf);
  EXPECT_GT(words.size(), 300u);
  for (const PdfWord& word : words) {
    EXPECT_GE(word.left, 0.75 * side_margin - 0.5) << word.text;
    EXPECT_LE(word.right, 0.75 * (sheet_width - side_margin) + 0.5) << word.text;
    for (const PdfWord& other : words) {
      if (&other == &word || other.sheet != word.sheet) continue;
      const double across = std::min(word.right, other.right) - std::max(word.left, other.left);
      const double down = std::min(word.bottom, other.bottom) - std::max(word.top, other.top);
      EXPECT_FALSE(across > 0.5 && down > 0.6 * std::min(word.bottom - word.top, other.bottom - other.top) &&
                   word.text.size() > 2 && other.text.size() > 2)
          << word.text << " on " << other.text;
    }
  }
}

TEST_F(PaperPdf, SaysItsTitle) {
  Page page;
  page.title = "A *plain* title";
  const auto pdf = to_pdf(page);
  if (!pdf && pdf.error().notice.code == "librsvg_is_missing") GTEST_SKIP() << in_words(pdf.error());
  ASSERT_TRUE(pdf.ok()) << in_words(pdf.error());
  EXPECT_THAT(*pdf, HasSubstr("/Title (A plain title)"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
