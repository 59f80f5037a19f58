// What goes wrong with a run, on the command line and in a study: the same words, the contract's exit status,
// and no more files than the contract says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// An option of `simulate` and its value.
struct Setting {
  std::string name, value;
};

struct BadRun {
  const char* name;
  std::vector<Setting> settings;
  int status;
  std::string said;  ///< on standard error
};

std::ostream& operator<<(std::ostream& out, const BadRun& run) { return out << run.name; }

/// Half a second of force, 100 samples a second; the times as asked.
template <class Time>
std::string force(const Time& time) {
  std::string bytes = "Time (s),Force (N)\n";
  for (int i = 0; i <= 50; ++i)
    if (const double t = time(i); t >= 0)
      bytes += std::to_string(t) + "," + std::to_string(std::sin(0.2 * i)) + "\n";
  return bytes;
}

void write_forces(const Folder& folder) {
  folder.write("short.csv", force([](int i) { return 0.01 * i; }));
  folder.write("gap.csv", force([](int i) { return i == 20 || i == 21 ? -1 : 0.01 * i; }));
  folder.write("jitter.csv", force([](int i) { return 0.01 * i + (i % 3 == 1 ? 0.0035 : 0); }));
  folder.write("chirped.csv", force([](int i) { return 0.01 * i * (1 + 0.002 * i); }));
}

const BadRun bad_runs[] = {
    {"step_beyond_the_limit",
     {{"stiffness", "36"}, {"method", "rk4"}, {"step", "0.48"}, {"until", "4.8"}},
     0,
     "--step: 0.48 s is beyond the stability limit of rk4 for this law, 0.471405 s: the motion will "
     "grow"},
    {"step_beyond_the_limit_under_a_drive",
     {{"stiffness", "36"},
      {"drive_amplitude", "1"},
      {"drive_frequency", "3"},
      {"method", "yoshida4"},
      {"step", "0.3"},
      {"until", "3"}},
     0,
     "--step: 0.3 s is beyond the stability limit of yoshida4 for this law, 0.262234 s"},
    {"step_beyond_the_limit_with_friction",
     {{"stiffness", "36"}, {"friction", "0.1"}, {"method", "verlet"}, {"step", "0.35"}, {"until", "3.5"}},
     0,
     "--step: 0.35 s is beyond the stability limit of verlet for small motions under this law, "
     "0.333333 s: the motion may grow"},
    {"no_convergence",
     {{"cubic", "-5"}, {"position", "3"}, {"method", "implicit-euler"}, {"step", "2"}, {"until", "20"}},
     1,
     "implicit-euler: no convergence in Newton's iteration after t = 6 s (step 3); take a shorter --step"},
    {"running_away",
     {{"stiffness", "-1"}, {"cubic", "-1"}, {"method", "dormand-prince"}, {"step", "0.1"}, {"until", "20"}},
     1,
     "dormand-prince: diverged: not finite after t = 1.5 s"},
    {"tolerance_below_rounding",
     {{"tolerance", "1e-16"}},
     2,
     "--tolerance: it must lie between 1e-15 and 1e-2"},
    {"drive_shorter_than_the_run",
     {{"drive_file", "short.csv"}, {"until", "0.6"}},
     2,
     "--drive-file: the recording ends at 0.5 s, before the run does (0.6 s); shorten --until"},
    {"drive_with_a_gap",
     {{"drive_file", "gap.csv"}},
     2,
     "gap.csv: the samples have a gap of 0.03 s after t = 0.19 s; a drive needs even samples without gaps"},
    {"drive_with_jitter",
     {{"drive_file", "jitter.csv"}},
     2,
     "jitter.csv: line 3: the times are not evenly spaced (0.0135 s where 0.01 s is expected"},
    {"drive_with_growing_spacing", {{"drive_file", "chirped.csv"}}, 2, "the times are not evenly spaced"},
    {"static_below_kinetic",
     {{"friction", "2"}, {"static_friction", "1.5"}},
     2,
     "--static-friction: it must be at least --friction (2 N), not 1.5 N"},
};

class BadRuns : public ::testing::TestWithParam<BadRun> {};

INSTANTIATE_TEST_SUITE_P(Runs, BadRuns, ::testing::ValuesIn(bad_runs),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(BadRuns, OnTheCommandLine) {
  const Folder folder;
  write_forces(folder);
  std::vector<std::string> arguments{"simulate", "-o", "run.csv", "--json"};
  for (const Setting& one : GetParam().settings) {
    std::string option = "--" + one.name;
    for (char& c : option) c = c == '_' ? '-' : c;
    arguments.insert(arguments.end(), {option, one.value});
  }
  const Finished end = folder.run(arguments);
  EXPECT_EQ(end.status, GetParam().status);
  EXPECT_THAT(end.err, HasSubstr(GetParam().said));
  if (GetParam().status == 2) {
    EXPECT_THAT(end.out, IsEmpty());
    EXPECT_FALSE(folder.has("run.csv"));
  } else {
    EXPECT_TRUE(folder.has("run.csv"));
    EXPECT_EQ(end.json()["runs"].size(), 1u);
  }
}

TEST_P(BadRuns, InAStudy) {
  const Folder folder;
  write_forces(folder);
  std::string study = "[[task]]\nsimulate = \"lab\"\n";
  for (const Setting& one : GetParam().settings) {
    const bool number = one.value.find_first_not_of("-.e0123456789") == std::string::npos;
    study += one.name + " = " + (number ? one.value : "\"" + one.value + "\"") + "\n";
  }
  folder.write("lab.toml", study + "[[block]]\ntext = \"{lab.1.steps} steps\"\n");
  const Finished end = folder.run({"report", "lab.toml", "-o", "out"});
  EXPECT_EQ(end.status, GetParam().status) << end.err;
  EXPECT_THAT(end.err, HasSubstr(GetParam().said));
  EXPECT_EQ(folder.has("out/index.html"), GetParam().status == 0);
  if (GetParam().status != 0) {
    EXPECT_THAT(end.err, HasSubstr("lab.toml:"));
  }
}

TEST(BadRuns, WithoutConvergenceTheStatesSoFarAreWritten) {
  const Folder folder;
  const Finished end =
      folder.run({"simulate", "--cubic", "-5", "--position", "3", "--method", "implicit-euler", "--step", "2",
                  "--until", "20", "--provenance", "-o", "run.csv", "--json"});
  EXPECT_EQ(end.status, 1);
  const auto only = end.json()["runs"][0];
  EXPECT_EQ(only["status"], "no_convergence");
  EXPECT_EQ(only["counts"]["accepted"], 3);
  EXPECT_EQ(only["final"]["t"], 6.0);
  EXPECT_THAT(end.json()["message"].get<std::string>(), HasSubstr("no convergence"));
  const std::string written = folder.read("run.csv");
  EXPECT_THAT(written, HasSubstr("# run 1: no convergence in Newton's iteration after t = 6 s (step 3)"));
  EXPECT_THAT(written, HasSubstr("\n1,0,3,0,"));
  EXPECT_THAT(written, HasSubstr("\n1,2,-0.68"));
  EXPECT_THAT(written, ::testing::Not(HasSubstr("\n1,8,")));
}

TEST(BadRuns, AStopThatWasAskedForIsNone) {
  const Folder folder;
  folder.write("lab.toml",
               "[[task]]\nsimulate = \"lab\"\nevent = \"turning-point:stop\"\nvelocity = 1\nuntil = 20\n"
               "[[block]]\ntext = \"{lab.1.steps} steps\"\n");
  const Finished end = folder.run({"report", "lab.toml", "-o", "out"});
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_TRUE(folder.has("out/index.html"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
