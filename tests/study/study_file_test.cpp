#include "cromer/study/study_file.h"

#include <gtest/gtest.h>

namespace cromer {
namespace {

std::string message(std::string_view toml) {
  const auto study = read_study(toml, "lab.toml");
  return study ? "read" : study.error().message;
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
  ASSERT_TRUE(study) << study.error().message;
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

}  // namespace
}  // namespace cromer
