#include "cromer/study/study_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

std::string message(std::string_view toml) {
  const auto study = read_study(toml, "lab.toml");
  return study ? "read" : in_words(study.error());
}

TEST(StudyFile, reads_tasks_figures_and_blocks_in_order) {
  const auto study = read_study(R"(
title = "A lab"
[[task]]
simulate = "swing"
mass = "200 g"
drive_frequency = [1, 3.5]
[[figure]]
id = "figure-1"
x = "t"
y = "x"
[[figure.curve]]
of = "swing.1"
role = "exact"
[[block]]
heading = "One"
[[block]]
figure = "figure-1"
[[block]]
table = "Numbers"
header = ["a", "b"]
rows = [["one", 1]]
)",
                                "folder/lab.toml");
  ASSERT_TRUE(study) << in_words(study.error());
  EXPECT_EQ(study->folder, "folder");
  ASSERT_EQ(study->tasks.size(), 1u);
  EXPECT_EQ(study->tasks[0].command, "simulate");
  EXPECT_EQ(study->tasks[0].id, "swing");
  ASSERT_EQ(study->tasks[0].settings.size(), 2u);
  for (const Setting& setting : study->tasks[0].settings)
    if (setting.option == "drive-frequency") {
      EXPECT_EQ(setting.values, (std::vector<std::string>{"1", "3.5"}));
      EXPECT_EQ(setting.place.line, 6u);
    }
  ASSERT_EQ(study->figures.size(), 1u);
  ASSERT_EQ(study->figures[0].panels.size(), 1u);
  EXPECT_EQ(study->figures[0].panels[0].curves[0].of, "swing.1");
  ASSERT_EQ(study->blocks.size(), 3u);
  EXPECT_TRUE(std::holds_alternative<BlockSpec::Heading>(study->blocks[0].content));
  EXPECT_TRUE(std::holds_alternative<BlockSpec::FigureName>(study->blocks[1].content));
  EXPECT_EQ(std::get<TableSpec>(study->blocks[2].content).rows[0][1], "1");
}

TEST(StudyFile, names_the_place_of_what_is_wrong) {
  EXPECT_EQ(message("titel = \"x\"\n"), "lab.toml:1:9: \"titel\" is not known here; did you mean \"title\"?");
  EXPECT_EQ(message("\ntitle = 3\n").rfind("lab.toml:2:9: ", 0), 0u);
  EXPECT_EQ(message("title = \"x\n").rfind("lab.toml:1:", 0), 0u);
  for (const char* no_key :
       {"[=]\n", "[[%]]\n", "[a.=]\n", "[a\xC2\xB1]\n", "m\xC2\xB1 = 1\n", "m = 1 \xC2\xB1 2\n"})
    EXPECT_EQ(message(no_key).rfind("lab.toml:1:", 0), 0u) << no_key;
  EXPECT_NE(message("[[task]]\nmass = 1\n").find("needs its command"), std::string::npos);
  EXPECT_NE(message("[[task]]\nfit = \"a\"\n[[task]]\nfit = \"a\"\n")
                .find("lab.toml:3:1: each task needs a name of its own"),
            std::string::npos);
  EXPECT_NE(message("[[block]]\nfigure = \"figure-9\"\n").find("is no figure of this study"),
            std::string::npos);
  EXPECT_NE(message("[[figure]]\nid = \"f\"\n[[figure.curve]]\nrole = \"exact\"\ncolour = \"red\"\n")
                .find("lab.toml:5:"),
            std::string::npos);
  EXPECT_NE(message("[[figure]]\nid = \"f\"\nsize = \"huge\"\n")
                .find("\"size\" is one of single, wide, phase, half, tall"),
            std::string::npos);
  EXPECT_NE(message("task = 3\n").find("[[task]]"), std::string::npos);
}

Study read(std::string_view toml) {
  const auto study = read_study(toml, "lab.toml");
  EXPECT_TRUE(study) << (study ? "" : in_words(study.error()));
  return study ? *study : Study{};
}

constexpr std::string_view a_task = "[[task]]\nsimulate = \"a\"\n";

TEST(StudyFile, a_panel_of_its_own_is_the_figure) {
  const Study study = read(std::string(a_task) + R"(
[[figure]]
id = "f_1-A"
title = "T"
caption = "C"
columns = 3
width = 0.5
size = "wide"
[[figure.panel]]
panel_title = "P"
x = "t"
y = "x"
x_unit = "ms"
y_unit = "cm"
from = 1
to = 2.5
x_name = "time"
x_low = -1
x_high = 4
x_step = 0.5
y_logarithmic = true
phase_portrait = true
[[figure.panel.curve]]
of = "a.1"
minus = "b.1"
x = "u"
y = "w"
from = 0.5
to = 3
role = "exact"
name = "N"
remark = "R"
dashed = true
mark = "band"
label_x = 1
label_y = 2
text_x = 0.25
text_y = 0.75
[[figure.panel.curve]]
mark = "dots"
[[figure.panel.note]]
text = "here"
x = 5
y = 6
text_x = 0.1
circle = true
no_leader = true
[[figure.panel.note]]
text = "there"
[[figure.panel]]
[[figure.panel.curve]]
)");
  const FigureSpec& figure = study.figures.at(0);
  EXPECT_EQ(figure.look.id + figure.look.title + figure.look.caption, "f_1-ATC");
  EXPECT_EQ(figure.look.columns, 3);
  EXPECT_EQ(figure.width, 0.5);
  EXPECT_EQ(figure.look.size, FigureSize::wide);
  ASSERT_EQ(figure.panels.size(), 2u);
  const PanelSpec& panel = figure.panels[0];
  EXPECT_EQ(panel.look.title + panel.x + panel.y + panel.x_unit + panel.y_unit, "Ptxmscm");
  EXPECT_EQ(*panel.from, 1);
  EXPECT_EQ(*panel.to, 2.5);
  EXPECT_EQ(panel.look.x.name, "time");
  EXPECT_EQ(panel.look.x.low, -1);
  EXPECT_EQ(panel.look.x.high, 4);
  EXPECT_EQ(panel.look.x.step, 0.5);
  EXPECT_FALSE(panel.look.x.logarithmic);
  EXPECT_TRUE(panel.look.y.logarithmic);
  EXPECT_TRUE(std::isnan(panel.look.y.low));
  EXPECT_TRUE(std::isnan(panel.look.y.high));
  EXPECT_EQ(panel.look.y.step, 0);
  EXPECT_TRUE(panel.look.phase_portrait);
  EXPECT_FALSE(figure.panels[1].look.phase_portrait);
  const CurveSpec& curve = panel.curves.at(0);
  EXPECT_EQ(curve.of + curve.minus + curve.x + curve.y, "a.1b.1uw");
  EXPECT_EQ(*curve.from, 0.5);
  EXPECT_EQ(*curve.to, 3);
  EXPECT_EQ(curve.look.role + curve.look.name + curve.look.remark, "exactNR");
  EXPECT_TRUE(curve.look.dashed);
  EXPECT_EQ(curve.look.mark, Mark::band);
  EXPECT_EQ(*curve.look.label_x, 1);
  EXPECT_EQ(*curve.look.label_y, 2);
  EXPECT_EQ(*curve.look.text_x, 0.25);
  EXPECT_EQ(*curve.look.text_y, 0.75);
  EXPECT_EQ(panel.curves.at(1).look.mark, Mark::dots);
  EXPECT_EQ(figure.panels[1].curves.at(0).look.mark, Mark::line);
  EXPECT_FALSE(panel.curves[1].from || panel.curves[1].to || panel.curves[1].look.dashed);
  ASSERT_EQ(panel.look.notes.size(), 2u);
  EXPECT_EQ(panel.look.notes[0].text, "here");
  EXPECT_EQ(panel.look.notes[0].x, 5);
  EXPECT_EQ(panel.look.notes[0].y, 6);
  EXPECT_EQ(panel.look.notes[0].text_x, 0.1);
  EXPECT_EQ(panel.look.notes[0].text_y, 0.5);
  EXPECT_TRUE(panel.look.notes[0].circle);
  EXPECT_FALSE(panel.look.notes[0].leader);
  EXPECT_EQ(panel.look.notes[1].x, 0);
  EXPECT_EQ(panel.look.notes[1].y, 0);
  EXPECT_EQ(panel.look.notes[1].text_x, 0.5);
  EXPECT_FALSE(panel.look.notes[1].circle);
  EXPECT_TRUE(panel.look.notes[1].leader);
}

TEST(StudyFile, sizes_have_names_and_a_phase_is_of_phase_portraits) {
  const auto figure = [](const std::string& size) {
    return read(std::string(a_task) + "[[figure]]\nid = \"f\"\n" + size + "[[figure.curve]]\nof = \"a.1\"\n")
        .figures.at(0);
  };
  EXPECT_EQ(figure("").look.size, FigureSize::single);
  EXPECT_EQ(figure("").look.columns, 1);
  EXPECT_EQ(figure("").width, 1);
  EXPECT_EQ(figure("size = \"single\"\n").look.size, FigureSize::single);
  EXPECT_EQ(figure("size = \"half\"\n").look.size, FigureSize::half);
  EXPECT_EQ(figure("size = \"tall\"\n").look.size, FigureSize::tall);
  EXPECT_EQ(figure("size = \"phase\"\n").look.size, FigureSize::phase);
  EXPECT_TRUE(figure("size = \"phase\"\n").panels.at(0).look.phase_portrait);
  EXPECT_FALSE(figure("size = \"tall\"\n").panels.at(0).look.phase_portrait);
}

TEST(StudyFile, reads_every_kind_of_block) {
  const Study study = read(std::string(R"(title = "T"
byline = "B"
summary = "S"
[[key_figure]]
name = "n"
value = "v"
remark = "r"
[[key_figure]]
name = "m"
[[block]]
text = "plain"
[[block]]
code = "cromer"
caption = "run"
[[block]]
table = "caption"
each = ["a", "b"]
row = ["{.x}"]
rows = [["one", 2, 2.5, true], ["three"]]
text_columns = [0, 1000]
answer_column = 2
[[block]]
table = "plain"
)") + std::string(a_task));
  EXPECT_EQ(study.title.text + study.byline.text + study.summary.text, "TBS");
  ASSERT_EQ(study.key_figures.size(), 2u);
  EXPECT_EQ(
      study.key_figures[0].name.text + study.key_figures[0].value.text + study.key_figures[0].remark.text,
      "nvr");
  EXPECT_EQ(study.title.place.line, 1u);
  EXPECT_GT(study.key_figures[0].remark.place.line, study.key_figures[0].name.place.line);
  EXPECT_EQ(std::get<BlockSpec::Text>(study.blocks.at(0).content).text.text, "plain");
  EXPECT_EQ(std::get<BlockSpec::Code>(study.blocks.at(1).content).text.text, "cromer");
  EXPECT_EQ(std::get<BlockSpec::Code>(study.blocks.at(1).content).caption.text, "run");
  const auto& table = std::get<TableSpec>(study.blocks.at(2).content);
  EXPECT_EQ(table.each, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(table.row, std::vector<std::string>{"{.x}"});
  EXPECT_EQ(table.rows, (std::vector<std::vector<std::string>>{{"one", "2", "2.5", "true"}, {"three"}}));
  EXPECT_EQ(table.text_columns, (std::vector<int>{0, 1000}));
  EXPECT_EQ(table.answer_column, 2);
  const auto& plain = std::get<TableSpec>(study.blocks.at(3).content);
  EXPECT_EQ(plain.text_columns, std::vector<int>{0});
  EXPECT_EQ(plain.answer_column, -1);
}

TEST(StudyFile, says_what_each_key_takes) {
  const auto in_figure = [](const std::string& line) {
    return message("[[figure]]\nid = \"f\"\n" + line + "\n[[figure.curve]]\n" + std::string(a_task));
  };
  EXPECT_EQ(in_figure("title = 3"), "lab.toml:3:9: \"title\" takes a text in quotes");
  EXPECT_EQ(in_figure("width = \"w\""), "lab.toml:3:9: \"width\" takes a number");
  EXPECT_EQ(in_figure("columns = 1.5"), "lab.toml:3:11: \"columns\" takes a whole number");
  EXPECT_EQ(in_figure("columns = 1000001"), "lab.toml:3:11: \"columns\" takes a whole number");
  EXPECT_EQ(in_figure("columns = -1000001"), "lab.toml:3:11: \"columns\" takes a whole number");
  EXPECT_EQ(in_figure("columns = 1000000"), "read");
  EXPECT_EQ(in_figure("columns = -1000000"), "read");
  EXPECT_EQ(in_figure("phase_portrait = 1"), "lab.toml:3:18: \"phase_portrait\" takes true or false");
  EXPECT_EQ(in_figure("size = \"huge\""), "lab.toml:3:8: \"size\" is one of single, wide, phase, half, tall");
  EXPECT_EQ(in_figure("panel = 3"), "lab.toml:3:9: \"panel\" is a list of tables: write [[panel]]");
  EXPECT_EQ(in_figure("panel = [3]"), "lab.toml:3:10: \"panel\" is a list of tables");
  const auto in_table = [](const std::string& line) {
    return message("[[block]]\ntable = \"t\"\n" + line + "\n" + std::string(a_task));
  };
  EXPECT_EQ(in_table("rows = 3"), "lab.toml:3:8: \"rows\" takes a list of rows");
  EXPECT_EQ(in_table("rows = [3]"), "lab.toml:3:9: a row is a list of texts");
  EXPECT_EQ(in_table("rows = [[[1]]]"), "lab.toml:3:10: a cell is a text or a number");
  EXPECT_EQ(in_table("header = {a = 1}"),
            "lab.toml:3:10: \"header\" takes a number, a text or a list of them");
  EXPECT_EQ(in_table("header = [[1]]"), "lab.toml:3:11: \"header\" takes numbers or texts");
  EXPECT_EQ(in_table("text_columns = 0"), "lab.toml:3:16: \"text_columns\" takes a list of whole numbers");
  for (const char* bad : {"-1", "1001", "0.5"})
    EXPECT_EQ(in_table(std::string("text_columns = [") + bad + "]"),
              "lab.toml:3:17: \"text_columns\" takes a list of whole numbers from 0 to 1000");
  EXPECT_EQ(in_table("zzzzzzzz = 0"), "lab.toml:3:12: \"zzzzzzzz\" is not known here");
}

TEST(StudyFile, says_what_is_missing) {
  EXPECT_EQ(message("title = \"x\"\n"),
            "lab.toml: there is nothing to do: a study has at least one [[task]]");
  EXPECT_EQ(message("[[task]]\nfit = \"\"\n"), "lab.toml:1:1: each task needs a name of its own");
  EXPECT_EQ(
      message("[[task]]\nmass = 1\n"),
      "lab.toml:1:1: a [[task]] needs its command and a name for its results: simulate = \"name\" (or fit, "
      "compare, resonance, local_error, method_map, work_precision, spectrum, sweep, difference)");
  const std::string task(a_task);
  const std::string figure = "[[figure]]\nid = \"f\"\n[[figure.curve]]\n";
  EXPECT_EQ(message(task + "[[figure]]\n[[figure.curve]]\n"),
            "lab.toml:3:1: each figure needs an id of its own");
  EXPECT_EQ(message(task + figure + figure), "lab.toml:6:1: each figure needs an id of its own");
  EXPECT_EQ(message(task + "[[figure]]\nid = \"a b\"\n[[figure.curve]]\n"),
            "lab.toml:3:1: the id \"a b\" becomes a file's name: letters, digits, - and _ only");
  EXPECT_EQ(message(task + "[[figure]]\nid = \"f\"\n"),
            "lab.toml:3:1: a figure or panel needs curves: write [[figure.curve]] or [[figure.panel.curve]]");
  EXPECT_EQ(message(task + figure + "[[block]]\nfigure = \"g\"\n"),
            "lab.toml:6:1: \"g\" is no figure of this study");
  EXPECT_EQ(message(task + figure + "[[block]]\nfigure = \"f\"\n"), "read");
  EXPECT_EQ(message("[[task]]\nmass = 1\n[[figure]]\nx = 3\ny = 4\n"),
            "lab.toml:4:5: \"x\" takes a text in quotes");
}

TEST(StudyFile, a_task_keeps_its_settings_as_they_would_be_typed) {
  const Study study = read(
      "[[task]]\nlocal_error = \"e\"\nshows = \"unstable\"\nmass = 0.25\nevery = 3\nlist = [1, \"a b\", "
      "true]\n");
  const TaskSpec& task = study.tasks.at(0);
  EXPECT_EQ(task.command, "local-error");
  EXPECT_EQ(task.id, "e");
  EXPECT_EQ(task.shows, "unstable");
  ASSERT_EQ(task.settings.size(), 3u);
  for (const Setting& setting : task.settings)
    EXPECT_EQ(setting.values, setting.option == "mass"    ? std::vector<std::string>{"0.25"}
                              : setting.option == "every" ? std::vector<std::string>{"3"}
                                                          : (std::vector<std::string>{"1", "a b", "true"}))
        << setting.option;
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
