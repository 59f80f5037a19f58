// cromer simulate: its options, what it prints, its exit status, early ends included.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The rows of a CSV, comments and header left out.
std::vector<std::vector<double>> rows(const std::string& csv) {
  std::vector<std::vector<double>> table;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || (line[0] != '-' && (line[0] < '0' || line[0] > '9'))) continue;
    auto& row = table.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::strtod(cell.c_str(), nullptr));
  }
  return table;
}

/// The first line that is no comment.
std::string header(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  while (std::getline(lines, line) && line.rfind("#", 0) == 0) {
  }
  return line;
}

TEST(Simulate, AnswersAsTheContractSays) {
  const Folder folder;
  const Finished end = folder.run({"simulate",
                                   "--mass",
                                   "1",
                                   "--stiffness",
                                   "9",
                                   "--damping",
                                   "0.2",
                                   "--drive-amplitude",
                                   "1",
                                   "--drive-frequency",
                                   "3",
                                   "--method",
                                   "euler-cromer",
                                   "--step",
                                   "0.01",
                                   "--until",
                                   "50",
                                   "--json",
                                   "-o",
                                   "run.csv"});
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_EQ(end.err, "");
  const auto run = end.json()["runs"].at(0);
  EXPECT_EQ(run["method"], "euler-cromer");
  EXPECT_EQ(run["status"], "reached_end");
  EXPECT_EQ(run["step"], 0.01);
  EXPECT_EQ(run["counts"]["accepted"], 5000);
  for (const char* name : {"mass", "stiffness", "damping", "drag", "friction", "cubic", "drive_amplitude",
                           "drive_frequency", "drive_phase", "position", "velocity"})
    EXPECT_TRUE(run["parameters"].contains(name)) << name;
  EXPECT_THAT(folder.names(), ElementsAre("run.csv"));
  const std::string csv = folder.read("run.csv");
  EXPECT_EQ(header(csv), "run,t (s),x (m),v (m/s),energy (J)");
  const auto table = rows(csv);
  ASSERT_EQ(table.size(), 5001u);
  // Reading back gives the same double as the document has.
  EXPECT_EQ(table.back()[1], run["final"]["t"].get<double>());
  EXPECT_EQ(table.back()[2], run["final"]["x"].get<double>());
  EXPECT_EQ(table.back()[3], run["final"]["v"].get<double>());
  EXPECT_EQ(table.back()[4], run["final"]["energy"].get<double>());
  // Two steps by hand: x = 0, v = 0; a = 1: v = 0.01, x = 1e-4; then a = cos(0.03) - 9e-4 - 2e-3.
  EXPECT_DOUBLE_EQ(table[1][2], 1e-4);
  EXPECT_DOUBLE_EQ(table[2][3], 0.01 + 0.01 * (std::cos(0.03) - 9e-4 - 2e-3));
}

TEST(Simulate, MethodIsOutermostOfSeveralRuns) {
  const Folder folder;
  const Finished end =
      folder.run({"simulate", "--drive-amplitude", "1", "--drive-frequency", "3", "--drive-frequency", "1 Hz",
                  "--method", "exact", "--method", "rk4", "--until", "1", "--step", "0.01", "--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto runs = end.json()["runs"];
  ASSERT_EQ(runs.size(), 4u);
  EXPECT_EQ(runs[1]["method"], "exact");
  EXPECT_EQ(runs[2]["method"], "rk4");
  EXPECT_EQ(runs[2]["parameters"]["drive_frequency"], 3.0);
  EXPECT_NEAR(runs[3]["parameters"]["drive_frequency"].get<double>(), 6.283185307179586, 1e-15);
}

TEST(Simulate, ADivergingRunSaysWhenAndKeepsFiniteStates) {
  const Folder folder;
  const Finished end = folder.run(
      {"simulate", "--method", "forward-euler", "--step", "1", "--until", "1e5", "--json", "-o", "run.csv"});
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.err, HasSubstr("diverged: not finite after t = "));
  const auto document = end.json();
  EXPECT_EQ(document["runs"][0]["status"], "not_finite");
  EXPECT_THAT(document["message"].get<std::string>(), HasSubstr("diverged"));
  const auto table = rows(folder.read("run.csv"));
  ASSERT_GT(table.size(), 100u);
  for (const auto& row : table)
    for (const double value : row) ASSERT_TRUE(std::isfinite(value));
  EXPECT_EQ(table.back()[1], document["runs"][0]["final"]["t"].get<double>());
}

TEST(Simulate, CtrlCKeepsWhatIsThere) {
  const Folder folder;
  const pid_t process = folder.start(
      {"simulate", "--step", "0.01", "--until", "1e9", "--every", "100000", "--json", "-o", "run.csv"});
  ASSERT_TRUE(wait_for_handler(process, SIGINT));
  usleep(100000);
  kill(process, SIGINT);
  const Finished end = folder.wait(process);
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.err, HasSubstr("interrupted after t = "));
  const auto run = end.json()["runs"].at(0);
  EXPECT_EQ(run["status"], "stopped_by_event");
  EXPECT_EQ(run["interrupted"], true);
  EXPECT_LT(run["final"]["t"].get<double>(), 1e9);
  EXPECT_THAT(folder.names(), ElementsAre("run.csv"));
  const auto table = rows(folder.read("run.csv"));
  ASSERT_GE(table.size(), 1u);
  EXPECT_LE(table.back()[1], run["final"]["t"].get<double>());
}

TEST(Simulate, AShorterLastStepIsSaid) {
  const Folder folder;
  const Finished end = folder.run({"simulate", "--step", "0.01", "--until", "0.105", "--json"});
  EXPECT_EQ(end.status, 0);
  EXPECT_THAT(end.err, HasSubstr("the last step is 0.005 s"));
  EXPECT_EQ(end.json()["runs"][0]["final"]["t"], 0.105);
  EXPECT_EQ(folder.run({"simulate", "--step", "0.01", "--until", "0.105", "--quiet"}).err, "");
}

TEST(Simulate, ASensorWritesWhatALoggerWould) {
  const Folder folder;
  const std::vector<std::string> arguments{"simulate", "--step",          "0.01",   "--until",
                                           "1",        "--sensor-noise",  "0.3 mm", "--sensor-resolution",
                                           "0.1 mm",   "--sensor-offset", "0.2 m",  "--seed",
                                           "7"};
  auto first = arguments, second = arguments;
  first.insert(first.end(), {"-o", "a.csv"});
  second.insert(second.end(), {"-o", "b.csv"});
  auto third = arguments;
  third.insert(third.end(), {"-o", "c.csv", "--provenance"});
  ASSERT_EQ(folder.run(first).status, 0);
  ASSERT_EQ(folder.run(second).status, 0);
  const std::string csv = folder.read("a.csv");
  EXPECT_EQ(header(csv), "Time (s),Position (m)");
  EXPECT_EQ(csv, folder.read("b.csv"));
  ASSERT_EQ(folder.run(third).status, 0);
  EXPECT_THAT(folder.read("c.csv"), HasSubstr("\n# synthetic: a simulated motion sensor"));
  EXPECT_THAT(csv, HasSubstr("\n0.57,"));  // 57 x 0.01 is 0.5700000000000001
  for (const auto& row : rows(csv)) {
    EXPECT_NEAR(row[1], 0.2 + std::cos(row[0]), 0.01);
    char text[32];
    std::snprintf(text, sizeof text, "%.4f", row[1]);
    EXPECT_EQ(std::strtod(text, nullptr), row[1]);
  }
}

TEST(Simulate, SaysWhatEulerCromerConserves) {
  const Folder folder;
  const std::vector<std::string> arguments{"simulate", "--stiffness", "36",      "--step", "0.01",
                                           "--until",  "1e3",         "--every", "100",    "--compensated"};
  const Finished words = folder.run(arguments);
  ASSERT_EQ(words.status, 0) << words.err;
  EXPECT_THAT(words.out, HasSubstr("conserves a modified energy"));
  EXPECT_THAT(words.out, HasSubstr("(compensated sums)"));
  auto with_json = arguments;
  with_json.emplace_back("--json");
  const auto run = folder.run(with_json).json()["runs"].at(0);
  EXPECT_EQ(run["compensated"], true);
  EXPECT_EQ(run["modified_energy"]["start"], 18.0);
  EXPECT_EQ(run["modified_energy"]["states"], 1001);
  EXPECT_LT(run["modified_energy"]["drift"].get<double>(), 1e-13);
  EXPECT_NEAR(run["modified_energy"]["energy_swing"].get<double>(), 0.03, 1e-4);
  // A study may ask for it too.
  folder.write("long.toml",
               "summary = \"{long.1.modified_energy.drift}\"\n[[task]]\nsimulate = \"long\"\nstiffness = 36\n"
               "step = 0.01\nuntil = 100\ncompensated = true\n");
  const Finished report = folder.run({"report", "long.toml", "-o", "out"});
  ASSERT_EQ(report.status, 0) << report.err;
  const auto results = nlohmann::json::parse(folder.read("out/results.json"), nullptr, false);
  EXPECT_EQ(results["long.1.modified_energy.start"]["value"], 18.0);
}

TEST(Simulate, TheCommandInAFileIsReadBackByAShell) {
  const Folder folder;
  const Finished end = folder.run({"simulate", "--mass", "0.2 kg", "--stiffness", "9", "--until", "1",
                                   "--step", "0.1", "--quiet", "--provenance", "-o", "run.csv"});
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_THAT(
      folder.read("run.csv"),
      StartsWith(
          "# cromer simulate --mass '0.2 kg' --stiffness 9 --until 1 --step 0.1 --quiet --provenance -o "
          "run.csv\n"));
}

TEST(Simulate, StandardOutputTakesCsv) {
  const Folder folder;
  const Finished end = folder.run({"simulate", "--step", "0.1", "--until", "1", "-o", "-"});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(rows(end.out).size(), 11u);
}

TEST(Simulate, JsonFileHasTheStates) {
  const Folder folder;
  ASSERT_EQ(folder.run({"simulate", "--step", "0.1", "--until", "1", "-o", "run.json"}).status, 0);
  const auto document = nlohmann::json::parse(folder.read("run.json"), nullptr, false);
  EXPECT_EQ(document["runs"][0]["states"]["x"].size(), 11u);
}

TEST(Simulate, PlotIsDrawn) {
  const Folder folder;
  const Finished end =
      folder.run({"simulate", "--method", "exact", "--method", "forward-euler", "--plot", "run.svg"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_THAT(folder.names(), ElementsAre("run.svg"));
  EXPECT_THAT(folder.read("run.svg"), HasSubstr("</svg>"));
}

// Each table stands where it was asked for or where there is something to say, and nowhere else.
TEST(Simulate, PrintsNoTableThatDoesNotApply) {
  const std::vector<std::string> tables = {"steady motion", "transmissibility", "no events", "event\n",
                                           "longest steps"};
  struct Asked {
    std::vector<std::string> options;
    std::vector<std::string> printed;
  };
  const std::vector<std::string> driven{"--drive-amplitude", "1", "--drive-frequency", "2"};
  const auto with = [](std::vector<std::string> all, const std::vector<std::string>& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const Asked all[] = {
      {{}, {}},
      {driven, {"steady motion", "transmissibility"}},
      {{"--drive-amplitude", "0", "--drive-frequency", "2"}, {}},
      {with(driven, {"--cubic", "3"}), {}},
      {{"--event", "position=-1"}, {"no events"}},
      {{"--event", "position=-0.01"}, {"event\n"}},
      {{"--accuracy", "1 %"}, {"longest steps"}},
  };
  const Folder folder;
  for (const auto& [options, printed] : all) {
    std::vector<std::string> arguments{"simulate", "--mass",   "1",   "--stiffness", "9", "--damping",
                                       "0.2",      "--method", "rk4", "--until",     "10"};
    if (options.empty() || options[0] != "--accuracy") arguments.insert(arguments.end(), {"--step", "0.01"});
    const Finished end = folder.run(with(arguments, options));
    EXPECT_EQ(end.status, 0) << end.err;
    for (const std::string& table : tables) {
      const bool wanted = std::find(printed.begin(), printed.end(), table) != printed.end();
      EXPECT_EQ(end.out.find(table) != std::string::npos, wanted)
          << table << " of " << (options.empty() ? "" : options[0]) << '\n'
          << end.out;
    }
  }
}

// Six periods and a bit: a tenth of the run is less than half a period.
TEST(Simulate, AFigureSaysHowFarTheLastSwingGoes) {
  const Folder folder;
  const auto drawn = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "simulate");
    arguments.insert(arguments.end(), {"--plot", "run.svg"});
    EXPECT_EQ(folder.run(arguments).status, 0);
    return folder.read("run.svg");
  };
  EXPECT_THAT(drawn({"--stiffness", "4e6", "--position", "2 mm", "--until", "0.02", "--method", "exact"}),
              HasSubstr("±2.00 mm at the end"));
  // Friction takes 2 f/k = 2.22 cm in each half swing: the last turns, of 37, are at 20 and 17.8 cm.
  EXPECT_THAT(drawn({"--stiffness", "36", "--friction", "0.4", "--until", "19.5", "--method", "exact"}),
              ::testing::AllOf(HasSubstr("from −0.178 to 0.200 m"), HasSubstr("in the last 1.0 s")));
}

TEST(Simulate, PanelsArePartOfAPlot) {
  const Folder folder;
  const Finished drawn = folder.run({"simulate", "--plot", "run.svg", "--panels", "energy,phase", "--quiet"});
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  const std::string picture = folder.read("run.svg");
  EXPECT_THAT(picture, HasSubstr("Energy against time and the phase portrait by Euler-Cromer"));
  EXPECT_THAT(picture, HasSubstr("Phase portrait"));
  const Finished without = folder.run({"simulate", "--panels", "energy"});
  EXPECT_EQ(without.status, 2);
  EXPECT_EQ(without.err, "cromer: --panels says what to draw; name the file with --plot\n");
  const Finished wrong = folder.run({"simulate", "--plot", "wrong.svg", "--panels", "energy,phas"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("no panel \"phas\"; did you mean phase?"));
  EXPECT_EQ(folder.read("wrong.svg"), "");
}

/// x = 3 mm + 5 cm cos(2 t) from t = 1 s on, in a file that needs its reading told: a semicolon between, a
/// decimal comma, a row with a word, and a second run at twice the amplitude.
std::string told_recording() {
  std::string text = "Zeit (s);Weg (mm);v (m/s);Zeit (s);Weg (mm);v (m/s)\n";
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.1 * i;
    char line[200];
    std::snprintf(line, sizeof line, "%.1f;%.6f;%.6f;%.1f;%.6f;%.6f\n", 1 + t, 3 + 50 * std::cos(2 * t),
                  -0.1 * std::sin(2 * t), 1 + t, 3 + 100 * std::cos(2 * t), -0.2 * std::sin(2 * t));
    text += line;
  }
  text += "15;lost;0;15;lost;0\n";
  std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

std::vector<std::string> over(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"simulate", "--stiffness", "4",    "--position", "5 cm", "--method",
                                     "exact",    "--step",      "0.01", "--until",    "10"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Simulate, SaysHowFarARecordingLiesFromTheRun) {
  const Folder folder;
  std::string plain = "t (s),x (mm)\n";
  for (int i = 0; i <= 100; ++i) {
    char line[80];
    std::snprintf(line, sizeof line, "%.1f,%.9f\n", 1 + 0.1 * i, 3 + 50 * std::cos(0.2 * i));
    plain += line;
  }
  folder.write("swing.csv", plain);
  // 3 mm everywhere where the equilibrium is not told; the run is kept every 10 ms, and a line between two
  // kept states is off by at most 4 x 5 cm (10 ms)^2 / 8 = 2.5 um.
  const Finished off = folder.run(over({"--over", "swing.csv"}));
  EXPECT_EQ(off.status, 0);
  EXPECT_EQ(off.err,
            "cromer: note: exact: the recording lies 3.00 mm (rms) from it, over 101 samples of x (mm)\n");
  // From 2 s on: the samples are a second late, x_run(t) - x(t + 1 s) = 5 cm (cos 2 t - cos(2 t + 2)), on
  // average over a period 5 cm 2 sin 1 / sqrt 2 = 59.5 mm.
  const Finished late =
      folder.run(over({"--over", "swing.csv", "--over-offset", "0.003", "--over-from", "2"}));
  EXPECT_EQ(late.status, 0);
  EXPECT_THAT(late.err, HasSubstr("over 91 samples"));
  EXPECT_THAT(late.err, HasSubstr("lies 5.9"));
  EXPECT_THAT(folder.names(), ElementsAre("swing.csv"));
  const Finished drawn =
      folder.run(over({"--over", "swing.csv", "--over-offset", "0.003", "--plot", "run.svg"}));
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_THAT(drawn.err, HasSubstr("µm (rms) from it, over 101 samples"));
  EXPECT_THAT(folder.read("run.svg"), HasSubstr("101 samples"));
}

TEST(Simulate, RefusesWhatCannotLieUnderARun) {
  const Folder folder;
  folder.write("swing.csv", "t (s),x (mm),v (m/s)\n0,1,0\n1,2,0\n2,3,0\n3,1,1\n");
  const auto refused = [&](const std::vector<std::string>& more) {
    auto arguments = over(more);
    arguments.insert(arguments.end(), {"-o", "run.csv", "--plot", "run.svg"});
    const Finished end = folder.run(arguments);
    EXPECT_EQ(end.status, 2) << end.err;
    EXPECT_THAT(folder.names(), ElementsAre("swing.csv"));
    return end.err;
  };
  EXPECT_THAT(refused({"--over", "nowhere.csv"}), HasSubstr("nowhere.csv"));
  EXPECT_THAT(refused({"--over", "swing.csv", "--over-column", "y"}), HasSubstr("\"y\""));
  EXPECT_THAT(refused({"--over", "swing.csv", "--over-run", "2"}), HasSubstr("run 2"));
  EXPECT_THAT(refused({"--over", "swing.csv", "--over-column", "v"}),
              HasSubstr("--over: a run is laid over positions or angles, and column \"v (m/s)\" holds"));
  EXPECT_THAT(refused({"--over", "swing.csv", "--over-from", "4"}),
              HasSubstr("has no sample from 4 to 14 s, where the runs are"));
  EXPECT_EQ(refused({"--over-run", "2"}),
            "cromer: --over-run is about the recording of --over; name the file with that\n");
  EXPECT_EQ(refused({"--over-offset", "2"}),
            "cromer: --over-offset is about the recording of --over; name the file with that\n");
  const Finished onto = folder.run(over({"--over", "swing.csv", "-o", "swing.csv"}));
  EXPECT_EQ(onto.status, 2) << "the recording itself would be overwritten";
}

// The command that fit prints is run as it stands.
TEST(Simulate, LaysTheFittedMotionOverItsRecording) {
  const Folder folder;
  folder.write("a swing.csv", told_recording());
  const Finished fit = folder.run({"fit", "a swing.csv", "--delimiter", ";", "--decimal", ",", "--run", "2",
                                   "--column", "Weg", "--skip-bad-rows", "--from", "3", "--json"});
  ASSERT_EQ(fit.status, 0) << fit.err << fit.out;
  const std::string command = fit.json()["simulate"];
  for (const char* part : {" --over 'a swing.csv' --over-column 'Weg (mm)' --over-run 2 --over-from 3 "
                           "--over-offset 0.003",
                           " --delimiter ';' --decimal ,", " --skip-bad-rows"})
    EXPECT_THAT(command, HasSubstr(part));
  auto words = words_of(command);
  words.erase(words.begin());
  const Finished run = folder.run(words);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("µm (rms) from it, over 81 samples of Weg (mm)"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
