// Version, help, methods, inspect, fit and compare from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Program, SaysItsVersion) {
  const Finished end = Folder().run({"--version"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.out, "cromer 0.1.0\n");
}

TEST(Program, EveryCommandHasHelpWithAnExample) {
  for (const char* command :
       {"simulate", "methods", "inspect", "fit", "compare", "record", "serve", "report"}) {
    const Finished end = Folder().run({command, "--help"});
    EXPECT_EQ(end.status, 0) << command;
    EXPECT_THAT(end.out, HasSubstr("Example:\n  cromer " + std::string(command)));
  }
}

TEST(Program, HelpOfSimulateStatesTheDefaults) {
  const Finished end = Folder().run({"simulate", "--help"});
  for (const char* text :
       {"[1 kg]", "[1 N/m]", "[euler-cromer]", "1/200", "20 natural periods", "1 m when nothing else"})
    EXPECT_THAT(end.out, HasSubstr(text));
}

TEST(Program, HelpOfFitSaysWhatAFolderStandsFor) {
  EXPECT_THAT(Folder().run({"fit", "--help"}).out, HasSubstr("folders in it are not searched"));
  EXPECT_EQ(Folder().run({"help", "fit"}).out, Folder().run({"fit", "--help"}).out);
}

TEST(Program, HelpInShortHasALineForEachOption) {
  const Finished end = Folder().run({"fit", "-h"});
  ASSERT_EQ(end.status, 0);
  EXPECT_THAT(end.out, ContainsRegex("\n  --mass <kg> +oscillating mass, for the spring constant\n"));
  EXPECT_THAT(end.out, HasSubstr("cromer fit --help says more"));
  EXPECT_LT(std::count(end.out.begin(), end.out.end(), '\n'), 70);
}

TEST(Completions, NameEveryCommandAndEveryOption) {
  const std::string commands = Folder().run({"completions", "commands"}).out;
  EXPECT_THAT(commands, HasSubstr("simulate\trun the oscillator"));
  std::istringstream lines(commands);
  for (std::string line; std::getline(lines, line);) {
    const std::string command = line.substr(0, line.find('\t'));
    const std::string help = Folder().run({command, "--help"}).out;
    std::istringstream options(Folder().run({"completions", command}).out);
    int count = 0;
    for (std::string option; std::getline(options, option); ++count)
      EXPECT_THAT(help, HasSubstr(option.substr(0, option.find('\t')))) << command;
    EXPECT_GT(count, 2) << command;
  }
}

TEST(Completions, CompleteInBash) {
  const Folder folder;
  folder.write("try.sh",
               "cromer() { \"" CROMER_PROGRAM "\" \"$@\"; }\n" + folder.run({"completions", "bash"}).out +
                   "COMP_WORDS=(cromer fit --disc); COMP_CWORD=2; _cromer; echo \"${COMPREPLY[@]}\"\n"
                   "COMP_WORDS=(cromer sw); COMP_CWORD=1; _cromer; echo \"${COMPREPLY[@]}\"\n");
  ASSERT_EQ(std::system(("bash " + folder.path("try.sh") + " > " + folder.path("said")).c_str()), 0);
  EXPECT_EQ(folder.read("said"), "--disc-diameter\nsweep\n");
}

TEST(Completions, AnUnknownShellIsRefused) {
  const Finished end = Folder().run({"completions", "csh"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("bash, zsh or fish"));
}

TEST(Manual, HasEveryOptionOfEveryCommand) {
  const std::string man = Folder().run({"help", "--man"}).out;
  const std::string markdown = Folder().run({"help", "--markdown"}).out;
  EXPECT_THAT(man, HasSubstr(".SH EXIT STATUS"));
  std::istringstream commands(Folder().run({"completions", "commands"}).out);
  for (std::string line; std::getline(commands, line);) {
    const std::string command = line.substr(0, line.find('\t'));
    const std::size_t in_man = man.find("\\fB\\-\\-json\\fR", man.find(".B cromer " + command + ' '));
    EXPECT_NE(in_man, std::string::npos) << command;
    const std::size_t section = markdown.find("\n# cromer " + command + '\n');
    ASSERT_NE(section, std::string::npos) << command;
    const std::string here = markdown.substr(section, markdown.find("\n# cromer ", section + 1) - section);
    std::istringstream options(Folder().run({"completions", command}).out);
    for (std::string option; std::getline(options, option);) {
      const std::string name = option.substr(0, option.find('\t'));
      if (name != "--help") {
        EXPECT_THAT(here, HasSubstr(name)) << command;
      }
    }
  }
}

TEST(Manual, HoldsNoRequestThatNobodyWrote) {
  std::istringstream lines(Folder().run({"help", "--man"}).out);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with('.') || line.starts_with('\'')) {
      EXPECT_THAT(line, ContainsRegex("^\\.(TH|SH|SS|B|I|TP|PP|EX|EE)( |$)"));
    }
}

TEST(Methods, AreListedWithTheirOrders) {
  const Finished end = Folder().run({"methods", "--json"});
  ASSERT_EQ(end.status, 0);
  std::vector<std::string> names;
  const auto document = end.json();
  for (const auto& method : document["methods"]) {
    names.push_back(method["name"]);
    EXPECT_TRUE(method["implicit"].is_boolean() && method["symplectic"].is_boolean() &&
                method["adaptive"].is_boolean());
    EXPECT_FALSE(method["source"].get<std::string>().empty());
    EXPECT_EQ(method["order"].is_null(), method["name"] == "exact");
  }
  EXPECT_THAT(names, ::testing::IsSupersetOf(
                         {"forward-euler", "euler-cromer", "implicit-euler", "verlet", "rk4", "exact"}));
}

TEST(Methods, RecogniseTheRunOfAFile) {
  const Folder folder;
  folder.run({"simulate", "--mass", "0.2 kg", "--stiffness", "16", "--method", "implicit-midpoint", "--step",
              "0.01", "--every", "2", "--until", "5", "-o", "run.csv"});
  const std::vector<std::string> ask{"methods", "--recognise", "run.csv", "--mass", "0.2 kg", "--json"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), ask.begin(), ask.end());
    return folder.run(more);
  };
  const Finished made = with({"--stiffness", "16"});
  ASSERT_EQ(made.status, 0) << made.err;
  const auto best = made.json()["recognised"][0];
  EXPECT_EQ(best["method"], "newmark");
  EXPECT_EQ(best["same_map"], std::vector<std::string>{"implicit-midpoint"});
  EXPECT_NEAR(best["step"].get<double>(), 0.01, 1e-12);
  EXPECT_LT(best["distance"].get<double>(), 1e-12);
  EXPECT_LT(best["frequency_shift"].get<double>(), 0);
  EXPECT_NEAR(best["decay_rate_added"].get<double>(), 0, 1e-11);

  const Finished other = with({"--stiffness", "16.5"});
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.json()["message"].get<std::string>(), HasSubstr("check the law"));

  EXPECT_EQ(folder.run({"methods", "--recognise", "none.csv"}).status, 2);
  EXPECT_EQ(with({"--step", "0.007"}).status, 2);
  const Finished alone = folder.run({"methods", "--stiffness", "16"});
  EXPECT_EQ(alone.status, 2);
  EXPECT_THAT(alone.err, HasSubstr("--recognise"));
}

TEST(Inspect, SaysWhatIsInAFileAndConvertsIt) {
  const Folder folder;
  folder.write("lab.csv", "Time (s);Position (mm)\n0,00;1,5\n0,01;1,75\n0,02;2,0\n0,03;2,5\n");
  const Finished end = folder.run({"inspect", "lab.csv", "--json", "-o", "clean.csv"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto document = end.json();
  EXPECT_EQ(document["separator"], "semicolon");
  EXPECT_EQ(document["samples"], 4);
  EXPECT_NEAR(document["rate"].get<double>(), 100, 1e-9);
  EXPECT_EQ(document["columns"][0]["name"], document["time_column"]);
  EXPECT_EQ(document["columns"][1]["samples"], 4);
  EXPECT_EQ(document["columns"][1]["time_column"], document["time_column"]);
  EXPECT_EQ(document["columns"][1]["unit"], "mm");
  EXPECT_EQ(document["columns"][1]["quantity"], "position");
  EXPECT_EQ(folder.read("clean.csv"), "Time (s),Position (mm)\n0,1.5\n0.01,1.75\n0.02,2\n0.03,2.5\n");
  const Finished again = folder.run({"inspect", "clean.csv", "--json"});
  EXPECT_EQ(again.json()["columns"], document["columns"]);
}

TEST(Fit, FindsTheLawThatMadeTheRecording) {
  const Folder folder;
  folder.write("lab.csv", recording(3000));
  const Finished end = folder.run(
      {"fit", "lab.csv", "--law", "viscous", "--mass", "217.6 ± 0.3 g", "--json", "-o", "fit.csv"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto document = end.json();
  EXPECT_EQ(document["status"], "converged");
  EXPECT_EQ(document["law"], "viscous");
  // The motion is exp(-0.05 t) cos(6 t): w0^2 = 36 + 0.05^2.
  EXPECT_NEAR(document["parameters"]["decay_rate"]["value"].get<double>(), 0.05, 1e-5);
  EXPECT_NEAR(document["parameters"]["stiffness"]["value"].get<double>(), 0.2176 * 36.0025, 1e-4);
  EXPECT_NEAR(document["parameters"]["stiffness"]["standard_error"].get<double>(), 0.0003 * 36.0025, 1e-4);
  EXPECT_THAT(folder.read("fit.csv"), HasSubstr("decay_rate"));
}

TEST(Fit, SeveralFilesMakeAList) {
  const Folder folder;
  folder.write("a.csv", recording(3000));
  folder.write("b.csv", recording(3000, 0.1));
  const Finished end = folder.run({"fit", "a.csv", "b.csv", "--law", "viscous", "--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto fits = end.json()["fits"];
  ASSERT_EQ(fits.size(), 2u);
  EXPECT_NEAR(fits[1]["parameters"]["decay_rate"]["value"].get<double>(), 0.1, 1e-4);
}

TEST(Fit, OneOfSeveralThatFailsExitsOne) {
  const Folder folder;
  folder.write("a.csv", recording(3000));
  std::string rest = "Time (s),Position (m)\n";
  for (int i = 0; i < 2000; ++i) rest += std::to_string(i / 100.0) + ",0.2\n";
  folder.write("rest.csv", rest);
  const Finished end = folder.run({"fit", "a.csv", "rest.csv", "--law", "viscous", "--json"});
  EXPECT_EQ(end.status, 1);
  const auto document = end.json();
  EXPECT_EQ(document["fits"][0]["status"], "converged");
  EXPECT_NE(document["fits"][1]["status"], "converged");
  EXPECT_FALSE(document["fits"][1]["message"].get<std::string>().empty());
  EXPECT_FALSE(document["message"].get<std::string>().empty());
}

TEST(Compare, LaysSimulationsBesideTheRecording) {
  const Folder folder;
  folder.write("lab.csv", recording(3000));
  const Finished end = folder.run({"compare", "lab.csv", "--law", "viscous", "--method", "rk4", "--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto document = end.json();
  ASSERT_EQ(document["curves"].size(), 3u);
  EXPECT_EQ(document["curves"][1]["method"], "exact");
  EXPECT_TRUE(document["curves"][1]["step"].is_null());
  EXPECT_EQ(document["curves"][2]["method"], "rk4");
  EXPECT_EQ(document["curves"][2]["label"], "viscous by rk4");
  for (const auto& curve : document["curves"]) {
    EXPECT_GT(curve["r_squared"].get<double>(), 0.9999);
    EXPECT_NEAR(curve["amplitude_ratio_end"].get<double>(), 1, 1e-3);
  }
}

TEST(Compare, DrawsEachMethodInThePanelsAsked) {
  const Folder folder;
  folder.write("lab.csv", recording(3000));
  const Finished end =
      folder.run({"compare", "lab.csv", "--law", "viscous", "--method", "forward-euler", "--method", "rk4",
                  "--plot", "lab.svg", "--panels", "energy,phase", "-o", "lab.csv.csv"});
  ASSERT_EQ(end.status, 0) << end.err;
  const std::string picture = folder.read("lab.svg");
  for (const char* word : {"Energy against time and the phase portrait, measured and simulated",
                           "one constant rate", "forward Euler", "RK4"})
    EXPECT_THAT(picture, HasSubstr(word));
  EXPECT_THAT(end.out, HasSubstr("viscous by forward-euler"));
  for (const char* row : {"\n1,one constant decay rate,0,", "\n1,viscous,0,", "\n1,viscous by rk4,0,"})
    EXPECT_THAT(folder.read("lab.csv.csv"), HasSubstr(row));
  const Finished wrong = folder.run({"compare", "lab.csv", "--panels", "speed", "--plot", "no.svg"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--panels: there is no panel \"speed\""));
  EXPECT_EQ(folder.read("no.svg"), "");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
