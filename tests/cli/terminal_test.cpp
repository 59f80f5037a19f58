// Names from files and from the command line drive no terminal, and what is printed is UTF-8. Notices are
// broken into lines of a terminal, and the worst of many are shown.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "cromer/base/utf8.h"
#include "program.h"
#include "tests/support/bytes_of.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::HasSubstr;

const std::string hostile =
    "x\x1b]0;owned\a\xC2\x9B"
    "31m\xE2\x80\xAE";

void expect_harmless(const std::string& text) {
  EXPECT_TRUE(is_utf8(text)) << text;
  EXPECT_EQ(text, printable(text));
}

void expect_harmless(const Finished& end) {
  expect_harmless(end.out);
  expect_harmless(end.err);
}

TEST(Terminal, IsNotDrivenByTheNameOfAColumn) {
  const Folder folder;
  std::string text = recording(2000);
  text.replace(text.find("Position"), 8, hostile);
  folder.write("lab.csv", text);
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"inspect", "lab.csv"},
                                             {"inspect", "lab.csv", "--json"},
                                             {"inspect", "lab.csv", "-o", "-"},
                                             {"fit", "lab.csv"},
                                             {"fit", "lab.csv", "--json"},
                                             {"fit", "lab.csv", "-o", "-"},
                                             {"fit", "lab.csv", "--column", "absent"},
                                             {"fit", "lab.csv", "--plot", "fit.svg"},
                                             {"compare", "lab.csv"}}) {
    const Finished end = folder.run(command);
    expect_harmless(end);
  }
  const Finished shown = folder.run({"inspect", "lab.csv"});
  EXPECT_THAT(shown.out, HasSubstr("x\\x1b]0;owned\\x07\\x9b31m\\u202e"));
  const auto json = folder.run({"fit", "lab.csv", "--json"}).json();
  EXPECT_THAT(json["recording"]["column"].get<std::string>(), HasSubstr("\xC2\x9B"
                                                                        "31m"))
      << "JSON keeps the name";
}

TEST(Terminal, IsNotDrivenByWhatIsTyped) {
  const Folder folder;
  folder.write(hostile + ".csv", recording(300));
  folder.write("broken \xff.csv", recording(300));
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{hostile},
                                             {"\xff\xfe"},
                                             {"fit", "--" + hostile},
                                             {"fit", hostile},
                                             {"fit", hostile + ".csv", "--law", hostile},
                                             {"fit", "broken \xff.csv"},
                                             {"fit", "broken \xff.csv", "--json"},
                                             {"fit", "broken \xff.csv", "-o", "-"},
                                             {"inspect", "broken \xff.csv"},
                                             {"simulate", "--method", hostile},
                                             {"simulate", "--mass", "\xff"},
                                             {"simulate", "-o", hostile + "/x.csv"},
                                             {"report", "absent \xff.toml", "-o", "out"},
                                             {"serve", "--from", hostile},
                                             {"spectrum", hostile}}) {
    const Finished end = folder.run(command);
    expect_harmless(end);
  }
}

/// What is left to see of the notices: a slow machine shows in between how far it is.
std::string seen_at_terminal(const Folder& folder, const std::vector<std::string>& arguments,
                             unsigned short columns) {
  const Finished end = folder.run_at_terminal(arguments, columns);
  EXPECT_EQ(end.status, 0) << end.err;
  return std::regex_replace(end.err, std::regex("\r[^\n]*\r"), "");
}

/// Of this one there are three notices, with drag.csv two more, with a second file that has one, four.
void put_noted_recordings(const Folder& folder) {
  const std::string files = CROMER_SOURCE_DIR "/tests/cli/transcripts/files/";
  folder.write("two_runs.csv", bytes_of(files + "two_runs.csv"));
  folder.write("drag.csv", bytes_of(files + "drag.csv"));
  folder.write("größer.csv", bytes_of(files + "spikes.csv"));
}

TEST(Terminal, ShowsTheThreeWorstOfManyNotices) {
  const Folder folder;
  put_noted_recordings(folder);
  EXPECT_EQ(seen_at_terminal(folder, {"fit", "two_runs.csv", "drag.csv", "--law", "viscous"}, 200),
            "cromer: warning: drag.csv: the law viscous does not describe this recording: the residual is 14 "
            "times the noise from sample to sample, and the uncertainties cannot be trusted\n"
            "cromer: warning: two_runs.csv: run 1: 1 sample sticks out alone, the first in line 79\n"
            "cromer: warning: two_runs.csv: run 2: 1 sample sticks out alone, the first in line 329\n"
            "cromer: 2 more notices; --verbose shows them\n");
  EXPECT_THAT(
      seen_at_terminal(folder, {"fit", "two_runs.csv", "drag.csv", "--law", "viscous", "--verbose"}, 200),
      ::testing::EndsWith(
          "line 329\n"
          "cromer: note: two_runs.csv: the time starts again in line 252: the file is read as 2 runs\n"
          "cromer: note: drag.csv: the residuals are correlated (0.932 from sample to sample): the "
          "uncertainties are widened to those of 3 independent samples\n"));
  EXPECT_EQ(seen_at_terminal(folder, {"fit", "two_runs.csv", "größer.csv", "--law", "viscous"}, 200),
            "cromer: warning: two_runs.csv: run 1: 1 sample sticks out alone, the first in line 79\n"
            "cromer: warning: two_runs.csv: run 2: 1 sample sticks out alone, the first in line 329\n"
            "cromer: warning: größer.csv: 2 samples stick out alone, the first in line 79\n"
            "cromer: note: two_runs.csv: the time starts again in line 252: the file is read as 2 runs\n")
      << "four are not shortened to three and a line that says so";
  EXPECT_EQ(seen_at_terminal(folder, {"fit", "two_runs.csv", "drag.csv", "--law", "viscous", "--quiet"}, 200),
            "");
}

TEST(Terminal, NoticesAreBrokenAtBlanks) {
  const Folder folder;
  put_noted_recordings(folder);
  const std::vector<std::string> command{"fit", "größer.csv", "--law", "viscous"};
  // The longest line fills the terminal: a letter is one, whatever bytes it takes.
  EXPECT_EQ(seen_at_terminal(folder, {"fit", "größer.csv", "two_runs.csv", "--law", "viscous"}, 48),
            "cromer: warning: größer.csv: 2 samples stick out\n"
            "        alone, the first in line 79\n"
            "cromer: warning: two_runs.csv: run 1: 1 sample\n"
            "        sticks out alone, the first in line 79\n"
            "cromer: warning: two_runs.csv: run 2: 1 sample\n"
            "        sticks out alone, the first in line 329\n"
            "cromer: note: two_runs.csv: the time starts\n"
            "        again in line 252: the file is read as 2\n"
            "        runs\n");
  EXPECT_EQ(seen_at_terminal(folder, command, 35),
            "cromer: warning: 2 samples stick\n"
            "        out alone, the first in\n"
            "        line 79\n");
  EXPECT_EQ(seen_at_terminal(folder, command, 30),
            "cromer: warning: 2 samples\n"
            "        stick out alone, the\n"
            "        first in line 79\n");
  EXPECT_EQ(seen_at_terminal(folder, command, 29),
            "cromer: warning: 2 samples stick out alone, the first in line 79\n")
      << "one that is too narrow breaks lines itself";
}

TEST(Terminal, AReportSaysWhatItIsAt) {
  const Folder folder;
  folder.write("study.toml", R"(title = "A run"

[[task]]
simulate = "one"
natural_frequency = "1 Hz"
until = "1 s"

[[task]]
simulate = "two"
natural_frequency = "2 Hz"
until = "1 s"
)");
  const Finished told = folder.run_at_terminal({"report", "study.toml", "-o", "out"}, 80);
  EXPECT_EQ(told.status, 0);
  EXPECT_EQ(told.err, "\r\033[K  0 %  simulate one\r\033[K 50 %  simulate two\r\033[K100 %  figures\r\033[K");
  EXPECT_EQ(folder.run_at_terminal({"report", "study.toml", "-o", "out", "--quiet"}, 80).err, "");
}

TEST(Output, ThatCannotBeWrittenIsSaidOnce) {
  Folder folder;
  folder.write("lab.csv", recording(300));
  folder.write("study.toml", "title = \"A run\"\n[[task]]\nsimulate = \"one\"\nuntil = \"1 s\"\n");
  folder.standard_output = "/dev/full";
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"--version"},
                                             {"help"},
                                             {"help", "--man"},
                                             {"help", "--markdown"},
                                             {"fit", "-h"},
                                             {"completions", "bash"},
                                             {"methods"},
                                             {"inspect", "lab.csv", "-o", "out.csv"},
                                             {"report", "study.toml", "-o", "page"},
                                             {"report", "study.toml", "-o", "page", "--json"}}) {
    const Finished end = folder.run(command);
    EXPECT_EQ(end.status, 2) << command.front();
    EXPECT_EQ(end.err, "cromer: standard output cannot be written\n") << command.front();
  }
  EXPECT_TRUE(folder.has("out.csv"));
  EXPECT_TRUE(folder.has("page/index.html"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
