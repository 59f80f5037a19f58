// Many recordings and whole folders in one call.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using testing::HasSubstr;

/// Five recordings with decay rates of their own, one that is none, and a file that is no recording's.
void fill(const Folder& folder) {
  std::filesystem::create_directory(folder.path("runs"));
  for (int i = 1; i <= 5; ++i)
    folder.write("runs/" + std::to_string(i) + ".csv", recording(1000 + 100 * i, 0.02 * i));
  folder.write("runs/notes.md", "what we did");
  folder.write("runs/words.csv", "Time (s),Position (m)\n0.00,here\n0.01,there\n");
}

TEST(FitMany, AFoldersRowsStandInItsNamesOrder) {
  Folder folder;
  fill(folder);
  const Finished end = folder.run({"fit", "runs", "--law", "viscous", "--json"});
  EXPECT_EQ(end.status, 1);  // words.csv
  const auto document = end.json();
  ASSERT_EQ(document["fits"].size(), 6u);
  for (int i = 0; i < 5; ++i) {
    const auto& fit = document["fits"][i];
    EXPECT_EQ(fit["recording"]["file"], "runs/" + std::to_string(i + 1) + ".csv");
    EXPECT_NEAR(fit["parameters"]["decay_rate"]["value"].get<double>(), 0.02 * (i + 1), 1e-5);
  }
  const auto& failed = document["fits"][5];
  EXPECT_EQ(failed["status"], "wrong_input");
  EXPECT_THAT(failed["message"].get<std::string>(), HasSubstr("no rows of numbers"));
  EXPECT_EQ(document["message"], "1 of 6 fits did not succeed");
  EXPECT_THAT(end.err, HasSubstr("1 of 7 entries"));
}

TEST(FitMany, OfManyRecordingsTheFigureShowsSomeAndSaysSo) {
  Folder folder;
  std::filesystem::create_directory(folder.path("runs"));
  for (int i = 10; i < 36; ++i)
    folder.write("runs/a_" + std::to_string(i) + ".csv", recording(300, 0.01 * i));
  const Finished end = folder.run({"fit", "runs", "--law", "viscous", "--quiet", "--plot", "runs.svg"});
  EXPECT_THAT(end.out, HasSubstr("26 of 26 fits succeeded"));
  EXPECT_EQ(end.status, 0) << end.err;
  const std::string figure = folder.read("runs.svg");
  EXPECT_THAT(figure, HasSubstr("The first 24 of 26 recordings."));
  EXPECT_THAT(figure, HasSubstr("a_10.csv, run 1: viscous"));
}

TEST(FitMany, AnInterruptNamesTheFilesThatAreMissing) {
  Folder folder;
  std::vector<std::string> arguments{"fit", "--json"};
  for (int i = 0; i < 200; ++i) {
    arguments.push_back("r" + std::to_string(i) + ".csv");
    folder.write(arguments.back(), recording(6000, 0.02));
  }
  const pid_t process = folder.start(arguments);
  ASSERT_TRUE(wait_for_handler(process, SIGINT));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  kill(process, SIGINT);
  const Finished end = folder.wait(process);
  ASSERT_EQ(end.status, 1);
  EXPECT_THAT(end.err, testing::ContainsRegex("results of [0-9]+ of 200 files; missing: .*and [0-9]+ more"));
  const auto document = end.json();
  EXPECT_LT(document["fits"].size(), 200u);
  EXPECT_EQ(document["missing"].size(), 200 - document["fits"].size());
  EXPECT_EQ(document["missing"].back(), "r199.csv");
}

/// Positions of noise alone: no law, and nothing to write.
std::string noise() {
  std::string text = "Time (s),Position (m)\n";
  unsigned state = 1;
  for (int i = 0; i < 400; ++i) {
    state = state * 1664525u + 1013904223u;
    text += std::to_string(0.01 * i) + "," + std::to_string(state >> 20) + "\n";
  }
  return text;
}

TEST(FitMany, WhereThereIsNothingToWriteTheFileStays) {
  Folder folder;
  folder.write("noise.csv", noise());
  folder.write("kept.csv", "keep\n");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"compare", "noise.csv", "-o", "kept.csv"},
        std::vector<std::string>{"fit", "noise.csv", "--motion", "kept.csv"}}) {
    const Finished end = folder.run(command);
    EXPECT_EQ(end.status, 1) << end.err;
    EXPECT_THAT(end.out, HasSubstr("noise.csv"));
    EXPECT_THAT(end.err, HasSubstr("kept.csv is not written"));
    EXPECT_EQ(folder.read("kept.csv"), "keep\n");
  }
}

TEST(FitMany, WhatIsSaidOfTheFileIsSaidThoughItsFirstRunIsEmpty) {
  Folder folder;
  std::string text = "Time (s) Run #1,Position (m) Run #1,Time (s) Run #2,Position (m) Run #2\n";
  for (int i = 0; i < 1000; ++i) {
    const std::string t = std::to_string(0.01 * i);
    text += t + ",," + t + "," + (i == 500 ? "bad" : std::to_string(0.1 * std::cos(0.06 * i))) + "\n";
  }
  folder.write("runs.csv", text);
  const auto document =
      folder.run({"fit", "runs.csv", "--skip-bad-rows", "--law", "viscous", "--json"}).json();
  ASSERT_EQ(document["fits"].size(), 2u);
  EXPECT_EQ(document["fits"][0]["status"], "wrong_input");
  EXPECT_THAT(document["fits"][1]["warnings"].dump(), HasSubstr("bad row"));
}

// A file that is no library stands in the place of librsvg.
TEST(FitMany, AFigureThatFailsLeavesTheResult) {
  Folder folder;
  folder.write("lab.csv", recording(1000));
  folder.write("librsvg-2.so.2", "no library");
  const char* path = std::getenv("LD_LIBRARY_PATH");
  const std::string before = path ? path : "";
  setenv("LD_LIBRARY_PATH", folder.path("").c_str(), 1);
  const Finished fitted = folder.run({"fit", "lab.csv", "--law", "viscous", "--plot", "lab.png"}),
                 compared = folder.run({"compare", "lab.csv", "--law", "viscous", "--plot", "lab.pdf"}),
                 as_svg = folder.run({"fit", "lab.csv", "--law", "viscous", "--plot", "lab.svg"});
  path ? setenv("LD_LIBRARY_PATH", before.c_str(), 1) : unsetenv("LD_LIBRARY_PATH");
  for (const Finished& end : {fitted, compared}) {
    EXPECT_EQ(end.status, 2);
    EXPECT_THAT(end.err, HasSubstr("install it (Debian's package librsvg2-2) or write .svg"));
  }
  EXPECT_FALSE(folder.has("lab.png") || folder.has("lab.pdf"));
  EXPECT_THAT(fitted.out, HasSubstr("decay rate"));
  EXPECT_THAT(compared.out, HasSubstr("No other law was tried"));
  EXPECT_EQ(as_svg.status, 0) << as_svg.err;
  EXPECT_TRUE(folder.has("lab.svg"));
}

TEST(FitMany, EachIsFittedAsIfItWereAlone) {
  Folder folder;
  fill(folder);
  const auto together = folder.run({"fit", "runs", "--json", "--quiet"}).json();
  for (int i = 0; i < 5; ++i) {
    const auto alone =
        folder.run({"fit", "runs/" + std::to_string(i + 1) + ".csv", "--json", "--quiet"}).json();
    EXPECT_EQ(together["fits"][i], alone);
  }
}

TEST(FitMany, EachHasItsOwnMass) {
  Folder folder;
  fill(folder);
  const auto stiffness = [](const auto& fit) {
    return fit["parameters"]["stiffness"]["value"].template get<double>();
  };
  const auto heavy = folder.run({"fit", "runs/1.csv", "--mass", "200 g", "--json"}).json();
  const auto both =
      folder.run({"fit", "runs/2.csv", "runs/1.csv", "--mass", "0.1, 200 g", "--json", "--quiet"}).json();
  EXPECT_EQ(stiffness(both["fits"][1]), stiffness(heavy));
  EXPECT_LT(stiffness(both["fits"][0]), 1e-3 * stiffness(heavy));
  const Finished three = folder.run({"fit", "runs/2.csv", "runs/1.csv", "--mass", "1 g, 2 g, 3 g"});
  EXPECT_EQ(three.status, 2);
  EXPECT_THAT(three.err,
              HasSubstr("--mass: 3 masses are given for 2 files; give one for all, or one for each"));
  EXPECT_THAT(folder.run({"fit", "runs/1.csv", "--mass", "94.72, 55.19"}).err,
              HasSubstr("write --mass \"94.72, 55.19 g\""));
}

TEST(FitMany, OneTableHasARowForEach) {
  Folder folder;
  fill(folder);
  const Finished end = folder.run({"fit", "runs/1.csv", "runs/words.csv", "runs/2.csv", "-o", "all.csv"});
  EXPECT_EQ(end.status, 1);
  const std::string csv = folder.read("all.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  EXPECT_TRUE(
      csv.starts_with("file,run,column,law,status,angular_frequency (rad/s),angular_frequency standard"));
  EXPECT_THAT(csv, HasSubstr("runs/words.csv,1,,,wrong_input,"));
  EXPECT_THAT(csv, HasSubstr("no rows of numbers"));  // why
  EXPECT_THAT(end.out, HasSubstr("wrong_input"));
  EXPECT_THAT(end.out, HasSubstr("2 of 3 fits succeeded"));
  EXPECT_LT(end.out.find("1.csv"), end.out.find("words.csv"));
  EXPECT_LT(end.out.find("words.csv"), end.out.find("2.csv"));
}

TEST(FitMany, AnEmptyFolderOrAWrongOptionEndsItAll) {
  Folder folder;
  fill(folder);
  std::filesystem::create_directory(folder.path("empty"));
  Finished end = folder.run({"fit", "empty", "-o", "all.csv"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("empty: the folder holds no recording (a file ending in one of .csv"));
  EXPECT_THAT(end.err, HasSubstr(".unv; folders in it are not searched)"));
  EXPECT_FALSE(folder.has("all.csv"));
  end = folder.run({"fit", "runs", "--law", "drg"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("did you mean drag?"));
}

/// Three runs below each other: a swing, one that stands still, another swing.
std::string runs_with_one_at_rest() {
  std::string text = "Time (s),Position (m)\n";
  for (const double w : {7.0, 0.0, 9.0})
    for (int i = 0; i < 500; ++i)
      text += std::to_string(0.01 * i) + "," + std::to_string(0.1 * std::cos(0.01 * w * i)) + "\n";
  return text;
}

TEST(FitMany, OneMassForFilesThatSwingUnlikeIsSaid) {
  Folder folder;
  const auto swing = [](double w) {
    std::string text = "Time (s),Position (m)\n";
    for (int i = 0; i < 500; ++i)
      text += std::to_string(0.01 * i) + "," + std::to_string(0.1 * std::cos(0.01 * w * i)) + "\n";
    return text;
  };
  folder.write("a.csv", swing(7));
  folder.write("b.csv", swing(7 * 1.05));
  folder.write("c.csv", swing(7.02));
  const Finished end = folder.run({"fit", "a.csv", "b.csv", "c.csv", "--mass", "0.1 kg"});
  EXPECT_THAT(end.err, HasSubstr("b.csv: the frequency is 5 % above that of a.csv, and one mass is used"));
  for (const std::vector<std::string>& alike :
       {std::vector<std::string>{"a.csv", "c.csv", "--mass", "0.1 kg"},
        {"a.csv", "b.csv"},
        {"a.csv", "b.csv", "--mass", "0.11 kg, 0.1 kg"}}) {
    std::vector<std::string> arguments{"fit"};
    arguments.insert(arguments.end(), alike.begin(), alike.end());
    EXPECT_THAT(folder.run(arguments).err, testing::Not(HasSubstr("one mass is used")));
  }
}

TEST(FitMany, EachNoticeNamesItsRun) {
  Folder folder;
  folder.write("runs.csv", runs_with_one_at_rest());
  folder.write("one.csv", recording(500));
  for (const char* command : {"fit", "compare", "inspect"}) {
    const Finished end = folder.run({command, "runs.csv"});
    EXPECT_THAT(end.err, HasSubstr("cromer: warning: run 2: column \"Position (m)\" never changes\n"));
    EXPECT_THAT(end.err, HasSubstr("cromer: note: the time starts again in line 502"));
  }
  const Finished both = folder.run({"fit", "runs.csv", "one.csv"});
  EXPECT_THAT(both.err, HasSubstr("warning: runs.csv: run 2: column \"Position (m)\" never changes"));
  EXPECT_THAT(both.err, HasSubstr("note: runs.csv: the time starts again in line 502"));
  const Finished alone = folder.run({"fit", "runs.csv", "--run", "2"});
  EXPECT_THAT(alone.err, HasSubstr("warning: column \"Position (m)\" never changes"));

  const auto fits = folder.run({"fit", "runs.csv", "--json"}).json()["fits"],
             compared = folder.run({"compare", "runs.csv", "--json"}).json()["comparisons"];
  for (const auto& second : {fits[1], compared[1], compared[1]["fit"]}) {
    EXPECT_EQ(second["warnings"][0], "run 2: column \"Position (m)\" never changes");
    EXPECT_EQ(second["notices"][0]["text"], second["warnings"][0]);
    EXPECT_EQ(second["notices"][0]["code"], "column_never_changes");
    EXPECT_EQ(second["notices"][0]["severity"], "worth_knowing");
    EXPECT_EQ(second["notices"][0]["values"]["column"], "Position (m)");
    EXPECT_EQ(second["notices"][0]["values"]["run"], 2);
  }
}

TEST(FitMany, WhatIsSaidOfSeveralRunsIsSaidOnce) {
  Folder folder;
  std::string text = runs_with_one_at_rest();
  text.replace(0, text.find('\n'), "Time (s),Position");
  folder.write("runs.csv", text);
  for (const char* command : {"fit", "inspect"}) {
    const Finished end = folder.run({command, "runs.csv"});
    EXPECT_THAT(end.err,
                HasSubstr("runs 1, 2 and 3: column \"Position\" has no unit: m is assumed; the header "
                          "can name another, in brackets behind the column's name\n"));
    EXPECT_EQ(end.err.find("is assumed"), end.err.rfind("is assumed"));
  }
}

TEST(FitMany, CompareGoesOnWithTheOtherRuns) {
  Folder folder;
  std::string text =
      "Run 1: Time (s),Run 1: Position (m),Run 2: Time (s),Run 2: Position (m),"
      "Run 3: Time (s),Run 3: Velocity (m/s)\n";
  for (int i = 0; i < 800; ++i) {
    const std::string t = std::to_string(0.01 * i), x = std::to_string(0.1 * std::cos(0.07 * i));
    text += t + "," + x + "," + t + ",," + t + "," + x + "\n";
  }
  folder.write("three.csv", text);
  const Finished end = folder.run({"compare", "three.csv", "--law", "viscous", "-o", "curves.csv"});
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.out, HasSubstr("three.csv, Position (m), run 1\n"));
  EXPECT_THAT(end.out, HasSubstr("No other law was tried"));
  EXPECT_THAT(end.out,
              HasSubstr("three.csv, run 2: column \"Position (m)\" of run 2 has no values\n"));
  EXPECT_THAT(end.err, HasSubstr("cromer: three.csv: run 2: column \"Position (m)\" of run 2"));
  EXPECT_THAT(end.err,
              HasSubstr("cromer: three.csv: run 3: compare needs a position or an angle"));
  EXPECT_THAT(folder.read("curves.csv"), HasSubstr("\n1,"));
  const Finished as_json = folder.run({"compare", "three.csv", "--law", "viscous", "--json"});
  EXPECT_EQ(as_json.status, 1);
  const auto document = as_json.json();
  ASSERT_EQ(document["comparisons"].size(), 3u);
  EXPECT_EQ(document["comparisons"][0]["curves"].size(), 3u);
  EXPECT_EQ(document["comparisons"][1]["status"], "wrong_input");
  EXPECT_THAT(document["comparisons"][1]["message"].get<std::string>(), HasSubstr("has no values"));
  EXPECT_EQ(document["message"], "2 of 3 fits did not succeed");
  // Where none is of use, the input is wrong.
  EXPECT_EQ(folder.run({"compare", "three.csv", "--run", "2"}).status, 2);
  EXPECT_EQ(folder.run({"compare", "three.csv", "--run", "3"}).status, 2);
}

TEST(FitMany, AFileIsNamedOnceAndAColumnThatWasNotReadNot) {
  Folder folder;
  folder.write("good.csv", recording(500));
  folder.write("bad.csv", "Time (s),Position (m)\n0,1\n0.1,abc\n0.2,3\n");
  std::filesystem::create_directory(folder.path("nothing"));
  const Finished end = folder.run({"fit", "good.csv", "bad.csv", "/dev/null", "--json"});
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.err,
              HasSubstr("cromer: bad.csv: run 1: line 3: column \"Position (m)\": \"abc\""));
  EXPECT_THAT(end.err, HasSubstr("cromer: /dev/null: run 1: is a device"));
  const auto fits = end.json()["fits"];
  EXPECT_EQ(fits[0]["recording"]["column"], "Position (m)");
  for (const int i : {1, 2}) {
    EXPECT_FALSE(fits[i]["recording"].contains("column"));
    EXPECT_EQ(fits[i]["message"].get<std::string>().find(fits[i]["recording"]["file"]), std::string::npos);
  }
}

TEST(FitMany, AWrongTableOfMassesIsWrongInputWhateverElseFailed) {
  Folder folder;
  folder.write("runs.csv", runs_with_one_at_rest());
  const auto run = [&](const char* masses) {
    return folder.run({"fit", "runs.csv", "--mass-line", "--masses", masses, "-o", "line.csv"});
  };
  for (const char* wrong : {"2 kg, 1 kg", "2 kg, 1 kg, 1 kg, 3 kg", "1 kg, 1 kg, 1 kg", "1 kg, 3 kg, 2 kg"}) {
    const Finished end = run(wrong);
    EXPECT_EQ(end.status, 2) << wrong;
    EXPECT_EQ(end.out, "") << wrong;
    EXPECT_FALSE(folder.has("line.csv")) << wrong;
  }
  EXPECT_THAT(run("2 kg, 1 kg").err, HasSubstr("2 masses are given for 3 recordings"));
  const Finished good = run("2 kg, 3 kg, 1 kg");  // run 2 is missing in the line
  EXPECT_EQ(good.status, 1);
  EXPECT_TRUE(folder.has("line.csv"));
  const Finished lacking =
      run("1 kg, 2 kg, 1 kg");  // the run of the other mass failed: no fault of the masses
  EXPECT_EQ(lacking.status, 1);
  EXPECT_THAT(lacking.err, HasSubstr("there is no line of T² against mass: --mass-line needs at least two"));
  EXPECT_THAT(lacking.out, HasSubstr("run 3: converged"));
}

TEST(FitMany, OneRunThatCannotBeReadLeavesTheOthers) {
  Folder folder;
  std::string text = "Time (s) Run #1,Position (m) Run #1,Time (s) Run #2,Position (m) Run #2\n";
  const std::string rows = recording(1000);
  std::size_t at = rows.find('\n') + 1;
  for (int i = 0; i < 1000; ++i) {
    const std::size_t end = rows.find('\n', at);
    text += rows.substr(at, end - at) + ",,\n";
    at = end + 1;
  }
  folder.write("two.csv", text);
  const Finished end = folder.run({"fit", "two.csv", "--law", "viscous", "--json"});
  EXPECT_EQ(end.status, 1) << end.out << end.err;
  const auto document = end.json();
  ASSERT_EQ(document["fits"].size(), 2u);
  EXPECT_EQ(document["fits"][0]["status"], "converged");
  EXPECT_EQ(document["fits"][1]["status"], "wrong_input");
  EXPECT_EQ(document["fits"][1]["recording"]["run"], 2);
  EXPECT_THAT(folder.run({"fit", "two.csv", "--law", "viscous"}).out, HasSubstr("run 2: column"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
