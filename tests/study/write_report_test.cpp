#include "cromer/study/write_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "cromer/documents/words/words.h"
#include "cromer/study/study_writer.h"

namespace cromer::core {
namespace CROMER_FILE {

class MakeFigure : public testing::Test {
 protected:
  MakeFigure() {
    results_.set_column("a.t", {0, 1, 2}, "s", "time *t*");
    results_.set_column("a.x", {0.01, 0.02, 0.03}, "m", "position *x*");
    results_.set_column("b.t", {0, 1, 2}, "s", "time *t*");
    results_.set_column("b.x", {0.01, 0.01, 0.01}, "m", "position *x*");
    results_.set_column("short.x", {0.01}, "m", "position *x*");
    spec_.look.id = "figure-1";
    PanelSpec panel;
    panel.x = "t";
    panel.y = "x";
    panel.y_unit = "cm";
    CurveSpec curve;
    curve.of = "a";
    panel.curves = {curve};
    spec_.panels = {panel};
    spec_.place = spec_.panels[0].curves[0].place = {"lab.toml", 7, 1};
  }

  FigureSpec spec_;
  Results results_;
};

TEST_F(MakeFigure, converts_columns_and_names_axes) {
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << in_words(figure.error());
  const Panel& panel = figure->panels.at(0);
  EXPECT_EQ(panel.x.name, "time {/:Italic t} (s)");
  EXPECT_EQ(panel.y.name, "position {/:Italic x} (cm)");
  ASSERT_EQ(panel.curves.at(0).y.size(), 3u);
  EXPECT_DOUBLE_EQ(panel.curves[0].y[2], 3);
}

TEST_F(MakeFigure, cuts_by_time) {
  spec_.panels[0].curves[0].from = 1;
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << in_words(figure.error());
  EXPECT_EQ(figure->panels.at(0).curves.at(0).x, (std::vector<double>{1, 2}));
}

TEST_F(MakeFigure, subtracts_another_result) {
  spec_.panels[0].curves[0].minus = "b";
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << in_words(figure.error());
  EXPECT_DOUBLE_EQ(figure->panels.at(0).curves.at(0).y[2], 2);
  spec_.panels[0].curves[0].minus = "short";
  EXPECT_NE(in_words(make_figure(spec_, results_).error()).find("cannot be subtracted"), std::string::npos);
}

TEST_F(MakeFigure, names_the_place_of_what_is_missing) {
  spec_.panels[0].curves[0].of = "c";
  EXPECT_EQ(in_words(make_figure(spec_, results_).error()).rfind("lab.toml:7:1: \"c.t\" is no column", 0),
            0u);
  spec_.panels[0].curves[0].of = "a";
  spec_.panels[0].y_unit = "kg";
  EXPECT_NE(in_words(make_figure(spec_, results_).error()).find("cannot be drawn in \"kg\""),
            std::string::npos);
  spec_.panels[0].y_unit = "furlongs";
  EXPECT_THAT(in_words(make_figure(spec_, results_).error()), testing::HasSubstr("furlongs"));
  spec_.panels[0].y_unit = "cm";
  results_.set_column("a.x", {0.01, 0.02, 0.03}, "cubits", "position *x*");
  EXPECT_THAT(in_words(make_figure(spec_, results_).error()), testing::HasSubstr("cubits"));
}

TEST_F(MakeFigure, keeps_rows_from_the_first_time_to_the_last) {
  const auto drawn = [&] { return make_figure(spec_, results_)->panels.at(0).curves.at(0); };
  spec_.panels[0].to = 1;
  EXPECT_EQ(drawn().x, (std::vector<double>{0, 1}));
  EXPECT_EQ(drawn().y.size(), 2u);
  EXPECT_DOUBLE_EQ(drawn().y[1], 2);
  spec_.panels[0].from = 1;
  EXPECT_EQ(drawn().x, (std::vector<double>{1}));
  spec_.panels[0].curves[0].to = 5;
  EXPECT_EQ(drawn().x, (std::vector<double>{1, 2}));
  spec_.panels[0].curves[0].from = 0;
  EXPECT_EQ(drawn().x, (std::vector<double>{0, 1, 2}));
}

TEST_F(MakeFigure, a_range_needs_as_many_times_as_rows) {
  results_.set_column("odd.x", {1, 2}, "m", "x");
  results_.set_column("odd.u", {1, 2}, "m", "u");
  results_.set_column("odd.t", {1}, "s", "t");
  spec_.panels[0].x = "u";
  spec_.panels[0].curves[0].of = "odd";
  EXPECT_TRUE(make_figure(spec_, results_));
  spec_.panels[0].curves[0].from = 0;
  EXPECT_EQ(in_words(make_figure(spec_, results_).error()),
            "lab.toml:7:1: \"odd\": from and to need a column t as long as the ones drawn");
}

TEST_F(MakeFigure, a_curves_own_columns_come_first) {
  results_.set_column("a.v", {7, 8, 9}, "", "speed");
  spec_.panels[0].y_unit = "";
  spec_.panels[0].curves[0].y = "v";
  spec_.panels[0].curves[0].x = "x";
  spec_.panels[0].curves.push_back(spec_.panels[0].curves[0]);
  spec_.panels[0].curves[1].x = "t";
  spec_.panels[0].curves[1].y = "x";
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << in_words(figure.error());
  const Panel& panel = figure->panels.at(0);
  EXPECT_EQ(panel.x.name, "position {/:Italic x} (m)");
  EXPECT_EQ(panel.y.name, "speed");
  EXPECT_EQ(panel.curves.at(0).y, (std::vector<double>{7, 8, 9}));
  EXPECT_EQ(panel.curves.at(0).x, (std::vector<double>{0.01, 0.02, 0.03}));
  EXPECT_EQ(panel.curves.at(1).x, (std::vector<double>{0, 1, 2}));
}

TEST_F(MakeFigure, fills_every_text) {
  results_.set("n", 3, "m");
  spec_.look.title = "*t* {n}";
  spec_.look.caption = "*c* {n}";
  PanelSpec& panel = spec_.panels[0];
  panel.look.title = "*p* {n}";
  panel.look.x.name = "*x* {n}";
  panel.look.y.name = "*y* {n}";
  panel.look.notes.resize(2);
  panel.look.notes[1].text = "*n* {n}";
  panel.curves[0].look.name = "*k* {n}";
  panel.curves[0].look.remark = "*r* {n}";
  const auto figure = make_figure(spec_, results_);
  ASSERT_TRUE(figure) << in_words(figure.error());
  EXPECT_EQ(figure->title, "*t* 3\u00a0m");
  EXPECT_EQ(figure->caption, "*c* 3\u00a0m");
  EXPECT_EQ(figure->panels[0].title, "{/:Italic p} 3\u00a0m");
  EXPECT_EQ(figure->panels[0].x.name, "{/:Italic x} 3\u00a0m");
  EXPECT_EQ(figure->panels[0].y.name, "{/:Italic y} 3\u00a0m");
  EXPECT_EQ(figure->panels[0].notes[1].text, "{/:Italic n} 3\u00a0m");
  EXPECT_EQ(figure->panels[0].curves[0].name, "{/:Italic k} 3\u00a0m");
  EXPECT_EQ(figure->panels[0].curves[0].remark, "{/:Italic r} 3\u00a0m");
}

TEST_F(MakeFigure, says_what_cannot_be_filled) {
  spec_.panels[0].place = {"lab.toml", 5, 2};
  const auto said = [&](std::string& text) {
    text = "{missing}";
    const auto figure = make_figure(spec_, results_);
    text.clear();
    return figure ? "" : in_words(figure.error());
  };
  EXPECT_EQ(said(spec_.look.caption), "lab.toml:7:1: \"missing\" is no result of this study");
  EXPECT_EQ(said(spec_.panels[0].look.y.name), "lab.toml:5:2: \"missing\" is no result of this study");
  EXPECT_EQ(said(spec_.panels[0].curves[0].look.remark),
            "lab.toml:7:1: \"missing\" is no result of this study");
  spec_.panels[0].look.notes.resize(1);
  EXPECT_EQ(said(spec_.panels[0].look.notes[0].text), "lab.toml:5:2: \"missing\" is no result of this study");
  EXPECT_EQ(said(spec_.panels[0].curves[0].minus),
            "lab.toml:7:1: \"{missing}.x\" is no column of this study");
  spec_.panels[0].curves[0].minus = "short";
  EXPECT_EQ(in_words(make_figure(spec_, results_).error()),
            "lab.toml:7:1: \"short\" has 1 rows, \"a\" has 3: they cannot be subtracted");
}

TEST(Enhanced, italics_become_those_of_figures) {
  EXPECT_EQ(to_enhanced("position *x* (cm)"), "position {/:Italic x} (cm)");
  EXPECT_EQ(to_enhanced("2 * 3"), "2 * 3");
}

using testing::ElementsAre;
using testing::IsEmpty;

class MakePage : public testing::Test {
 protected:
  MakePage() {
    results_.set("k", 3, "N/m");
    for (const char* run : {"a.1", "a.2", "a.4"}) results_.set(std::string(run) + ".label", std::string(run));
    study_.file = "lab.toml";
    study_.title.text = "title {k}";
    study_.byline.text = "byline {k}";
    study_.summary.text = "summary {k}";
    study_.key_figures = {{{"name {k}"}, {"value {k}"}, {"remark {k}"}}, {{"n"}, {"v"}, {""}}};
    study_.figures.resize(2);
    study_.figures[0].look.id = "first";
    study_.figures[1].look.id = "second";
  }

  void add(decltype(BlockSpec::content) content) {
    study_.blocks.push_back({std::move(content), {"lab.toml", 9, 1}});
  }
  Page page() {
    const auto made =
        make_page(study_, results_, {{"second", {"<svg/>", "title", "caption", 0.5}}}, "footer");
    EXPECT_TRUE(made) << (made ? "" : in_words(made.error()));
    return made ? *made : Page{};
  }
  std::string refusal() {
    const auto made = make_page(study_, results_, {}, "");
    return made ? "" : in_words(made.error());
  }

  Study study_;
  Results results_;
};

TEST_F(MakePage, FillsWhatStandsAtItsTop) {
  const Page made = page();
  EXPECT_EQ(made.title, "title 3\u00a0N/m");
  EXPECT_EQ(made.byline, "byline 3\u00a0N/m");
  EXPECT_EQ(made.summary, "summary 3\u00a0N/m");
  EXPECT_EQ(made.footer, "footer");
  ASSERT_EQ(made.key_figures.size(), 2u);
  EXPECT_EQ(made.key_figures[0].name, "name 3\u00a0N/m");
  EXPECT_EQ(made.key_figures[0].value, "value 3\u00a0N/m");
  EXPECT_EQ(made.key_figures[0].remark, "remark 3\u00a0N/m");
  EXPECT_THAT(made.blocks, IsEmpty());
}

TEST_F(MakePage, HasTheBlocksInTheirOrder) {
  add(BlockSpec::Heading{{"h {k}"}});
  add(BlockSpec::Text{{"t {k}"}});
  add(BlockSpec::Code{{"c {k}"}, {"d {k}"}});
  add(BlockSpec::FigureName{"second"});
  const Page made = page();
  ASSERT_EQ(made.blocks.size(), 4u);
  EXPECT_EQ(std::get<Heading>(made.blocks[0]).text, "h 3\u00a0N/m");
  EXPECT_EQ(std::get<Paragraph>(made.blocks[1]).text, "t 3\u00a0N/m");
  EXPECT_EQ(std::get<Code>(made.blocks[2]).text, "c 3\u00a0N/m");
  EXPECT_EQ(std::get<Code>(made.blocks[2]).caption, "d 3\u00a0N/m");
  const auto& figure = std::get<FigureBlock>(made.blocks[3]);
  EXPECT_EQ(figure.id + figure.svg + figure.alt + figure.caption, "second<svg/>titlecaption");
  EXPECT_EQ(figure.label, "Figure 2");
  EXPECT_EQ(figure.width, 0.5);
}

TEST_F(MakePage, ATableRepeatsItsRowForEveryRun) {
  TableSpec table;
  table.caption = "c {k}";
  table.header = {"one {k}", "two"};
  table.rows = {{"r {k}", "s"}, {"u", "v"}};
  table.each = {"a"};
  table.row = {"{.label}", "{k, bare}"};
  table.text_columns = {0, 1};
  table.answer_column = 1;
  add(table);
  const Page page_of_table = page();
  const auto& made = std::get<TableBlock>(page_of_table.blocks.at(0));
  EXPECT_EQ(made.caption, "c 3\u00a0N/m");
  EXPECT_THAT(made.header, ElementsAre("one 3\u00a0N/m", "two"));
  // The third run is missing, so the fourth is not listed.
  EXPECT_THAT(made.rows, ElementsAre(ElementsAre("r 3\u00a0N/m", "s"), ElementsAre("u", "v"),
                                     ElementsAre("a.1", "3"), ElementsAre("a.2", "3")));
  EXPECT_THAT(made.text_columns, ElementsAre(0, 1));
  EXPECT_EQ(made.answer_column, 1);
}

TEST_F(MakePage, SaysWhereATextIsThatCannotBeFilled) {
  add(BlockSpec::Text{{"{first} {second}", {"lab.toml", 10, 8}}});
  EXPECT_EQ(refusal(), "lab.toml:10:8: \"first\" is no result of this study");
  TableSpec table;
  table.each = {"b", "c"};
  study_.blocks.clear();
  add(table);
  EXPECT_EQ(refusal(), "lab.toml:9:1: \"b\" has no runs to list");
  study_.key_figures[1].remark = {"{missing}", {"lab.toml", 4, 10}};
  EXPECT_EQ(refusal(), "lab.toml:4:10: \"missing\" is no result of this study");
}

// Of a report that fails nothing is left, and the folder only where it was there before.
TEST(ReportFolder, IsLeftAsItWas) {
  const std::string place = testing::TempDir() + "cromer_reports";
  std::filesystem::remove_all(place);
  const std::string study = place + "/lab.toml", made = place + "/made", there = place + "/there";
  std::filesystem::create_directories(there);
  std::ofstream(study) << "title = \"Away\"\n[[task]]\nsimulate = \"away\"\nmethod = \"forward-euler\"\n"
                          "step = 1\nuntil = 2000\n";
  for (const std::string& folder : {made, there}) {
    const auto written = write_report(study, folder, "today", "cromer");
    ASSERT_TRUE(written) << in_words(written.error());
    EXPECT_THAT(in_words(written->failure), testing::HasSubstr("diverged"));
  }
  EXPECT_FALSE(std::filesystem::exists(made));
  EXPECT_TRUE(std::filesystem::is_empty(there));
  std::filesystem::remove_all(place);
}

class WriteReport : public testing::Test {
 protected:
  WriteReport() {
    std::filesystem::remove_all(place_);
    std::filesystem::create_directories(place_);
    std::ofstream(study_) << "title = \"Falls\"\nbyline = \"A test\"\n"
                             "[[task]]\nsimulate = \"a\"\nuntil = 1\nmethod = \"exact\"\n"
                             "[[figure]]\nid = \"fall\"\ntitle = \"The fall\"\nx = \"t\"\ny = \"x\"\n"
                             "[[figure.curve]]\nof = \"a.1\"\n[[block]]\nfigure = \"fall\"\n";
  }
  ~WriteReport() override { std::filesystem::remove_all(place_); }

  Result<WrittenReport> written(const std::string& pdf = "", const Watch& watch = {}) {
    return write_report(
        study_, folder_, "today", "cromer 1", watch,
        [this](const std::string& what, double share) {
          said_.push_back(what);
          share_ = share;
          if (what == "figures") stop_ = stops_;
        },
        {}, pdf);
  }
  static std::string bytes_of(const std::string& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  const std::string place_ = testing::TempDir() + "cromer_report_files_" +
                             testing::UnitTest::GetInstance()->current_test_info()->name(),
                    study_ = place_ + "/lab.toml", folder_ = place_ + "/made";
  std::vector<std::string> said_;
  double share_ = 0;
  std::atomic<bool> stop_{false};
  bool stops_ = false;
};

TEST_F(WriteReport, WritesPageFiguresResultsAndPdf) {
  const auto without = written();
  ASSERT_TRUE(without) << in_words(without.error());
  EXPECT_EQ(without->index, folder_ + "/index.html");
  EXPECT_THAT(without->figures, testing::ElementsAre(folder_ + "/fall.svg"));
  EXPECT_EQ(without->pdf, "");
  EXPECT_THAT(to_json(*without), testing::Not(testing::HasSubstr("pdf")));
  EXPECT_THAT(said_, testing::ElementsAre("simulate a", "figures"));
  EXPECT_EQ(share_, 1);
  EXPECT_THAT(bytes_of(without->index), testing::HasSubstr("A test · today · cromer 1"));
  EXPECT_THAT(bytes_of(without->index), testing::HasSubstr("The fall"));
  EXPECT_THAT(bytes_of(folder_ + "/fall.svg"), testing::HasSubstr("<svg"));
  EXPECT_THAT(bytes_of(folder_ + "/results.json"), testing::HasSubstr("\"a.1."));
  const auto with = written(place_ + "/lab.pdf");
  ASSERT_TRUE(with) << in_words(with.error());
  EXPECT_EQ(with->pdf, place_ + "/lab.pdf");
  EXPECT_THAT(to_json(*with), testing::HasSubstr("\"pdf\": \"" + place_ + "/lab.pdf\""));
  EXPECT_EQ(bytes_of(with->pdf).substr(0, 5), "%PDF-");
}

TEST_F(WriteReport, SaysWhatCannotBeWritten) {
  const auto pdf = written(place_ + "/none/lab.pdf");
  ASSERT_FALSE(pdf);
  EXPECT_THAT(in_words(pdf.error()), testing::HasSubstr("/none/lab.pdf"));
  for (const std::string file : {"fall.svg", "results.json", "index.html"}) {
    std::filesystem::create_directories(folder_ + "/" + file);
    const auto made = written();
    ASSERT_FALSE(made) << file;
    EXPECT_THAT(in_words(made.error()), testing::HasSubstr(file));
    std::filesystem::remove_all(folder_);
  }
}

TEST_F(WriteReport, KeepsAPageThatIsNotItsOwn) {
  ASSERT_TRUE(written());
  ASSERT_TRUE(written());
  std::ofstream(folder_ + "/index.html") << "<h1>My page</h1>\n";
  const auto made = written();
  ASSERT_FALSE(made);
  EXPECT_EQ(in_words(made.error()),
            folder_ + "/index.html is a page that Cromer did not write, and is kept: name another folder");
  EXPECT_EQ(bytes_of(folder_ + "/index.html"), "<h1>My page</h1>\n");
}

TEST_F(WriteReport, TakesNoFileForAFolder) {
  for (const std::string inside : {"", "/in/it"}) {
    const auto made = make_folder(study_ + inside);
    ASSERT_FALSE(made);
    EXPECT_EQ(in_words(made.error()), study_ + " is a file: name a folder");
  }
}

TEST_F(WriteReport, SaysThatAFolderCannotBeMade) {
  const auto made = make_folder("/proc/cromer/report");
  ASSERT_FALSE(made);
  EXPECT_THAT(in_words(made.error()), testing::HasSubstr("/proc/cromer/report"));
}

TEST_F(WriteReport, SaysBeforeWhichFigureItIsInterrupted) {
  stops_ = true;
  const auto made = written("", {&stop_, {}});
  ASSERT_FALSE(made);
  EXPECT_EQ(in_words(made.error()),
            study_ + ":7:1: " + in_words(Notice{"interrupted_before", {{"figure", "fall"}}}));
}

TEST(StudyText, StandsForItself) {
  EXPECT_EQ(toml_text("a \"b\" \\ \n\t\x1f\x7f\x20"), R"("a \"b\" \\ \n\u0009\u001F\u007F ")");
  EXPECT_EQ(verbatim("{a} x_{1} y^{2} {"), "{{a} x_{1} y^{2} {{");
  EXPECT_EQ(toml_settings({{"damping-ratios", "0.1"}, {"mass", "2 kg"}, {"damping-ratios", "0.2"}}),
            "damping_ratios = [\"0.1\", \"0.2\"]\nmass = \"2 kg\"\n");
}

TEST(StudyText, OfACurveHasWhatIsGiven) {
  StudyWriter writer;
  writer.figure({.id = "f",
                 .title = "T",
                 .caption = "",
                 .size = "wide",
                 .x = "t",
                 .y = "x",
                 .x_name = "",
                 .y_name = "",
                 .curves = {{.of = "a", .role = "data", .to = 1.5, .dots = true, .dashed = true},
                            {.of = "b", .role = ""}}});
  EXPECT_EQ(writer.written(),
            "\n[[figure]]\nid = \"f\"\ntitle = \"T\"\nsize = \"wide\"\nx = \"t\"\ny = \"x\"\n"
            "\n[[figure.curve]]\nof = \"a\"\nrole = \"data\"\nto = 1.5\nmark = \"dots\"\n"
            "dashed = true\n\n[[figure.curve]]\nof = \"b\"\n\n[[block]]\nfigure = \"f\"\n");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
