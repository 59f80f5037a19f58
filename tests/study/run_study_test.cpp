#include "cromer/study/run_study.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/network/network_file.h"
#include "cromer/tasks/network_run/network_run.h"
#include "tests/study/collected.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string files = std::string(CROMER_SOURCE_DIR) + "/tests/cli/transcripts/files/";

Study study_of(const std::string& toml) {
  const auto study = read_study(toml, files + "lab.toml");
  EXPECT_TRUE(study) << (study ? "" : in_words(study.error()));
  return study ? *study : Study{};
}

StudyRun done(const std::string& toml, const Watch& watch = {}) {
  const auto run = run_study(study_of(toml), watch);
  EXPECT_TRUE(run) << (run ? "" : in_words(run.error()));
  return run ? *run : StudyRun{};
}

/// The Error without the name of the file before it; "" if there is none.
std::string refusal(const std::string& toml) {
  const auto run = run_study(study_of(toml));
  return run ? "" : in_words(run.error()).substr(files.size());
}

/// The failure without the name of the file before it.
std::string failure(const std::string& toml) {
  const std::string said = in_words(done(toml).failure);
  return said.empty() ? "" : said.substr(files.size());
}

TEST(RunStudy, SaysWhichTaskItIsAtAndHowFar) {
  std::vector<std::string> said;
  const Study study = study_of(
      "[[task]]\nsimulate = \"a\"\nuntil = 1\n[[task]]\nsimulate = \"b\"\nuntil = 1\n"
      "[[task]]\ndifference = \"d\"\nof = \"a.1\"\nminus = \"b.1\"\n");
  const auto run = run_study(study, {}, [&](const std::string& what, double share) {
    said.push_back(what + " " + shortest(share));
  });
  ASSERT_TRUE(run);
  EXPECT_THAT(
      said, ElementsAre("simulate a 0", "simulate b 0.3333333333333333", "difference d 0.6666666666666666"));
  EXPECT_TRUE(run->failure.empty());
  EXPECT_THAT(in_words(run->notices), IsEmpty());
  EXPECT_THAT(in_words(run->shown), IsEmpty());
  EXPECT_EQ(fact(run->results, "d.peak"), "0 m");
}

TEST(RunStudy, TheLargestDifferenceIsLookedForInAllRows) {
  const std::string two =
      "[[task]]\nsimulate = \"a\"\nmethod = \"exact\"\nstep = 0.5\nuntil = 1\n"
      "[[task]]\nsimulate = \"b\"\nmethod = \"exact\"\nstep = 0.5\nuntil = 1\nposition = 3\n"
      "[[task]]\nsimulate = \"c\"\nuntil = 3\n";
  const auto difference = [&](const std::string& of, const std::string& minus) {
    return two + "[[task]]\ndifference = \"d\"\nof = \"" + of + "\"\nminus = \"" + minus + "\"\n";
  };
  EXPECT_EQ(fact(done(difference("a.1", "b.1")).results, "d.peak"), "2 m");
  EXPECT_EQ(fact(done(difference("b.1", "a.1")).results, "d.peak"), "2 m");
  EXPECT_EQ(refusal(difference("a.1", "c.1")),
            "lab.toml:15:1: \"a.1\" and \"c.1\" do not have the same number of rows");
  EXPECT_EQ(refusal(difference("a.2", "b.1")),
            "lab.toml:15:1: \"a.2.x\" is no column of this study; did you mean \"a.1.x\"?");
  EXPECT_EQ(refusal(difference("a.1", "e.1")).substr(0, 23), "lab.toml:15:1: \"e.1.x\" ");
}

TEST(RunStudy, NoticesAreNamedAndThoseToBeShownAreNoNotices) {
  const std::string grows = "[[task]]\nsimulate = \"grows\"\nmethod = \"rk4\"\nuntil = 1\ntolerance = 1e-9\n";
  EXPECT_THAT(in_words(done(grows).notices), ElementsAre("grows: --tolerance has no effect on rk4"));
  const StudyRun shows = done(grows + "shows = \"no effect on rk4\"\n");
  EXPECT_THAT(in_words(shows.notices), IsEmpty());
  EXPECT_THAT(in_words(shows.shown), ElementsAre("grows: --tolerance has no effect on rk4"));
  const StudyRun other = done(grows + "shows = \"unstable\"\n");
  EXPECT_THAT(in_words(other.notices),
              ElementsAre("grows: --tolerance has no effect on rk4",
                          files + "lab.toml:1:1: simulate grows should show \"unstable\", but does not"));
  EXPECT_THAT(in_words(other.shown), IsEmpty());
}

TEST(RunStudy, AQuietTaskHasNoNotices) {
  const std::string grows = "[[task]]\nsimulate = \"grows\"\nmethod = \"rk4\"\nuntil = 1\ntolerance = 1e-9\n";
  EXPECT_THAT(in_words(done(grows + "quiet = true\n").notices), IsEmpty());
  EXPECT_EQ(done(grows + "quiet = false\n").notices.size(), 1u);
  const StudyRun shows = done(grows + "quiet = true\nshows = \"no effect on rk4\"\n");
  EXPECT_THAT(in_words(shows.shown), ElementsAre("grows: --tolerance has no effect on rk4"));
  EXPECT_EQ(done(grows + "quiet = true\nshows = \"unstable\"\n").notices.size(), 1u);
}

TEST(RunStudy, NoticesStayAsGraveAsTheyWere) {
  const auto how = [](const std::string& toml) { return severity(done(toml).notices.at(0)); };
  EXPECT_EQ(how("[[task]]\nsweep = \"a\"\nstep = 0.1\nmethod = \"rk4\"\ndrive_amplitude = 1\n"
                "damping = 1\ndrive_frequency = [1, 20]\n"),
            Severity::wrong_if_ignored);
}

TEST(RunStudy, EndsWhereATaskFails) {
  const std::string away =
      "[[task]]\nsimulate = \"away\"\nmethod = [\"exact\", \"forward-euler\"]\nstep = 1\nuntil = 2000\n"
      "[[task]]\nsimulate = \"b\"\nuntil = 1\n";
  const StudyRun ended = done(away);
  EXPECT_THAT(in_words(ended.failure),
              testing::StartsWith(files + "lab.toml:1:1: simulate away: forward-euler: diverged"));
  EXPECT_EQ(fact(ended.results, "away.1.label"), "none");
  EXPECT_EQ(fact(ended.results, "b.1.label"), "none");
  const std::atomic<bool> stop{true};
  const StudyRun stopped = done("[[task]]\nmethod_map = \"m\"\n[[task]]\nmethod_map = \"n\"\n", {&stop, {}});
  EXPECT_EQ(in_words(stopped.failure), files + "lab.toml:1:1: method-map m: interrupted");
  EXPECT_EQ(fact(stopped.results, "n.natural_frequency"), "none");
}

TEST(RunStudy, RefusalsOfATaskNameItsPlace) {
  EXPECT_EQ(refusal("[[task]]\nsimulate = \"a\"\nmas = 1\n"),
            "lab.toml:3:7: \"mas\" is no option of simulate; did you mean \"mass\"?");
  EXPECT_EQ(refusal("[[task]]\nsimulate = \"a\"\nmass = [1, 2]\n"),
            "lab.toml:3:8: \"mass\" takes one value, not a list");
  EXPECT_EQ(refusal("[[task]]\nsimulate = \"a\"\nmass = -1\n"),
            "lab.toml:3:8: --mass: it must be positive, not -1 kg");
  EXPECT_EQ(refusal("[[task]]\nsimulate = \"a\"\nmass = \"{b.mass}\"\n"),
            "lab.toml:3:8: \"b.mass\" is no result of this study");
  EXPECT_EQ(refusal("[[task]]\nsimulate = \"a\"\ndisc_diameter = 1\n"),
            "lab.toml:3:17: \"disc_diameter\" is no option of simulate; it is one of fit");
  EXPECT_EQ(refusal("[[task]]\nsimulate = \"a\"\nstiffness = 0\n").substr(0, 14), "lab.toml:1:1: ");
  EXPECT_EQ(refusal("[[task]]\nsimulate = \"a\"\nzzzzzzzzz = 0\n"),
            "lab.toml:3:13: \"zzzzzzzzz\" is no option of simulate");
  EXPECT_EQ(refusal("[[task]]\nfit = \"a\"\nmethod = \"rk4\"\nfile = \"swing.csv\"\n"),
            "lab.toml:3:10: \"method\" is no option of fit; it is one of simulate");
  EXPECT_EQ(refusal("[[task]]\nfit = \"a\"\n"), "lab.toml:1:1: \"fit\" needs file = \"a recording\"");
  EXPECT_THAT(refusal("[[task]]\nfit = \"a\"\nfile = \"none.csv\"\n"), HasSubstr("none.csv"));
  EXPECT_EQ(refusal("[[task]]\nspectrum = \"a\"\n"),
            "lab.toml:1:1: \"spectrum\" needs file = \"a recording\"");
  EXPECT_EQ(refusal("[[task]]\nresonance = \"a\"\ndrive_amplitude = 1\ndamping = 1\nfrequency_from = 0\n"),
            "lab.toml:5:18: --frequency-from: it must be positive, not 0 rad/s");
  EXPECT_EQ(refusal("[[task]]\nresonance = \"a\"\npoints = 0\n"),
            "lab.toml:3:10: --points: it must be positive, not 0");
  EXPECT_THAT(refusal("[[task]]\nsimulate = \"a\"\ndrive_file = \"none.csv\"\n"),
              HasSubstr("lab.toml:1:1: --drive-file: "));
  EXPECT_THAT(refusal("[[task]]\nsimulate = \"a\"\nbase_motion = \"none.csv\"\n"),
              HasSubstr("lab.toml:1:1: --base-motion: "));
  EXPECT_EQ(refusal("[[task]]\nsweep = \"a\"\nevent = \"turning-point\"\n"),
            "lab.toml:3:9: --event: a sweep measures whole runs; look for events with simulate");
}

TEST(RunStudy, FitsEachRunOfARecording) {
  const Results one =
      done("[[task]]\nfit = \"lab\"\nfile = \"swing.csv\"\nlaw = \"viscous\"\nmass = 2\n").results;
  EXPECT_EQ(fact(one, "lab.file"), "swing.csv");
  EXPECT_EQ(fact(one, "lab.mass"), "2 kg");
  EXPECT_EQ(fact(one, "lab.1.file"), "none");
  EXPECT_THAT(failure("[[task]]\nfit = \"lab\"\nfile = \"noise.csv\"\nlaw = \"viscous\"\n"),
              testing::StartsWith("lab.toml:1:1: fit lab: noise.csv: "));
  const Results two = done("[[task]]\nfit = \"lab\"\nfile = \"two_runs.csv\"\nlaw = \"viscous\"\n").results;
  EXPECT_EQ(fact(two, "lab.file"), "none");
  EXPECT_EQ(fact(two, "lab.1.file"), "two_runs.csv");
  EXPECT_EQ(fact(two, "lab.2.file"), "two_runs.csv");
}

TEST(RunStudy, SweepsTakeListsAsGrids) {
  const std::string sweep = "[[task]]\nsweep = \"grid\"\ndrive_amplitude = 1\n";
  const StudyRun run = done(sweep + "damping_ratio = [0.25, 0.5]\ndrive_frequency = [1, 2, 3]\n");
  EXPECT_EQ(fact(run.results, "grid.points"), "6");
  EXPECT_EQ(fact(run.results, "grid.2.label"), "damping ratio 0.5");
  EXPECT_THAT(column(run.results, "grid.1.drive_frequency").values, ElementsAre(1, 2, 3));
  EXPECT_THAT(in_words(run.notices), IsEmpty());
  EXPECT_EQ(failure(sweep + "drive_frequency = [0.5, 2]\n"), "lab.toml:1:1: sweep grid: no point settled");
  EXPECT_THAT(in_words(done(sweep + "drive_frequency = [0.5, 2]\n").notices),
              testing::Contains("grid: 2 of 2 points never settled: the law has no damping, so the free "
                                "motion stays; give --damping"));
  const StudyRun half = done(sweep + "damping = [0, 1]\ndrive_frequency = [0.5, 2]\n");
  EXPECT_TRUE(half.failure.empty());
  EXPECT_THAT(in_words(half.notices),
              testing::Contains(
                  "grid: 2 of 4 points never settled; --settle N measures them as they are after N cycles"));
  EXPECT_EQ(fact(half.results, "grid.not_settled"), "2");
}

TEST(RunStudy, OptionsOfStudiesAloneReachTheirTasks) {
  const Results curve =
      done(
          "[[task]]\nresonance = \"r\"\nmethod = \"exact\"\ndrive_amplitude = 1\n"
          "damping_ratios = [0.25, 0.5]\nfrequency_from = 2\nfrequency_to = 4\npoints = 3\n")
          .results;
  EXPECT_THAT(column(curve, "r.2.frequency").values, ElementsAre(2, 3, 4));
  EXPECT_EQ(fact(curve, "r.1.damping_ratio"), "0.25");
  EXPECT_EQ(fact(curve, "r.2.damping_ratio"), "0.5");
  const Results map =
      done("[[task]]\nmethod_map = \"m\"\nmethod = \"rk4\"\nfrom = 0.5\nto = 2\npoints = 3\n").results;
  EXPECT_THAT(column(map, "m.1.wh").values, ElementsAre(0.5, 1, 2));
  const Results work = done(
                           "[[task]]\nwork_precision = \"w\"\nmethod = \"rk4\"\nuntil = 6\nlongest = 0.05\n"
                           "halvings = 2\n")
                           .results;
  EXPECT_EQ(column(work, "w.1.error").values.size(), 3u);
  const Results error = done("[[task]]\nlocal_error = \"e\"\nmethod = [\"rk4\", \"verlet\"]\n").results;
  EXPECT_EQ(fact(error, "e.2.label"), "verlet");
}

TEST(RunStudy, ModesOfARecordingStandBesideANetwork) {
  const std::string networks = "../../../../data/networks/";
  const StudyRun run = done("[[task]]\nmodes = \"wind\"\nfile = \"" + networks +
                            "floors_in_wind.csv\"\nnetwork = \"" + networks + "frame.toml\"\n");
  EXPECT_TRUE(run.failure.empty());
  EXPECT_EQ(value(run.results, "wind.2.of_network.mode"), 2);
  EXPECT_GT(value(run.results, "wind.2.of_network.mac"), 0.99);
  EXPECT_NEAR(value(run.results, "wind.2.of_network.frequency") / value(run.results, "wind.2.frequency") - 1,
              value(run.results, "wind.2.of_network.frequency_error"), 1e-12);
}

TEST(RunStudy, FitsANetworkToARecording) {
  const std::string networks = std::string(CROMER_SOURCE_DIR) + "/data/networks/";
  const auto network = open_network(networks + "pendulums.toml");
  ASSERT_TRUE(network);
  const auto run = run_network(*network, "", {.method = {"rk4"}, .step = 0.01, .until = 40});
  ASSERT_TRUE(run);
  const std::string file = testing::TempDir() + "cromer_study_pendulums.csv";
  std::ofstream rows(file);
  rows << "t (s),left (rad),right (rad)\n";
  const NetworkStates& states = run->states;
  for (std::size_t n = 0; n < states.t.size(); n += 5)
    rows << fmt::format("{},{},{}\n", states.t[n], states.x[0][n], states.x[1][n]);
  rows.close();
  const StudyRun study = done("[[task]]\nfit = \"lab\"\nfile = \"" + file + "\"\nnetwork = \"" + networks +
                              "pendulums_open.toml\"\n");
  std::remove(file.c_str());
  EXPECT_TRUE(study.failure.empty()) << in_words(study.failure);
  for (std::size_t l = 0; l < 2; ++l)
    EXPECT_NEAR(value(study.results, fmt::format("lab.links.{}.pendulum", l + 1)), 1.57, 1e-6);
  EXPECT_NEAR(value(study.results, "lab.links.3.stiffness"), 0.05, 1e-6);
  EXPECT_EQ(column(study.results, "lab.left.residual").values.size(), 801u);
}

TEST(RunStudy, FitsOfNetworksSayWhatIsMissing) {
  const std::string fit = "[[task]]\nfit = \"a\"\nnetwork = \"../../../../data/networks/";
  EXPECT_THAT(refusal(fit + "pendulums_open.toml\"\n"), HasSubstr("file"));
  EXPECT_THAT(refusal(fit + "pendulums.toml\"\nfile = \"two_runs.csv\"\n"), HasSubstr("no value is open"));
  EXPECT_THAT(refusal(fit + "pendulums_open.toml\"\nfile = \"two_runs.csv\"\nmass = 2\n"), HasSubstr("mass"));
}

TEST(RunStudy, TasksOfNetworksSayWhatIsWrong) {
  const std::string networks = "../../../../data/networks/";
  const std::string run = "[[task]]\nsimulate = \"a\"\nnetwork = \"";
  EXPECT_THAT(refusal(run + "none.toml\"\n"), HasSubstr("none.toml"));
  EXPECT_EQ(refusal(run + networks + "pendulums.toml\"\nmas = 1\n").substr(0, 14), "lab.toml:4:7: ");
  EXPECT_EQ(refusal(run + networks + "pendulums.toml\"\nuntil = -1\n").substr(0, 14), "lab.toml:4:9: ");
  EXPECT_THAT(failure(run + networks +
                      "pendulums.toml\"\nmethod = [\"rk4\", \"forward-euler\"]\nstep = 1\nuntil = 9000\n"),
              testing::StartsWith("lab.toml:1:1: simulate a: forward-euler: "));
  const std::string modes = "[[task]]\nmodes = \"m\"\n", wind = networks + "floors_in_wind.csv";
  EXPECT_EQ(refusal(modes), "lab.toml:1:1: \"modes\" needs file = \"a recording\"");
  EXPECT_EQ(refusal(modes + "mas = 1\n").substr(0, 14), "lab.toml:3:7: ");
  EXPECT_THAT(refusal(modes + "file = \"none.csv\"\n"), HasSubstr("none.csv"));
  EXPECT_THAT(refusal(modes + "file = \"" + wind + "\"\nnetwork = \"none.toml\"\n"), HasSubstr("none.toml"));
  EXPECT_THAT(failure(modes + "file = \"noise.csv\"\n"), testing::StartsWith("lab.toml:1:1: modes m: "));
}

TEST(RunStudy, AFitOfANetworkMayFail) {
  const std::string file = testing::TempDir() + "cromer_study_short.csv";
  std::ofstream rows(file);
  rows << "t (s),left (rad),right (rad)\n";
  for (int n = 0; n < 20; ++n)
    rows << fmt::format("{},{},{}\n", 0.01 * n, std::cos(0.05 * n), std::cos(0.06 * n));
  rows.close();
  const std::string fit = "[[task]]\nfit = \"lab\"\nfile = \"" + file +
                          "\"\nnetwork = \"../../../../data/networks/pendulums_open.toml\"\n";
  const StudyRun failed = done(fit), may = done(fit + "may_fail = true\n");
  std::remove(file.c_str());
  EXPECT_THAT(in_words(failed.failure), testing::StartsWith(files + "lab.toml:1:1: fit lab: " + file + ": "));
  EXPECT_FALSE(failed.results.column("lab.left.measured"));
  EXPECT_THAT(in_words(may.failure), "");
  EXPECT_EQ(column(may.results, "lab.left.measured").values.size(), 20u);
  EXPECT_FALSE(may.results.column("lab.left.residual"));
}

TEST(RunStudy, EndsWhereItIsInterrupted) {
  const std::atomic<bool> stop{true};
  const auto ended = [&](const std::string& toml) {
    const StudyRun run = done(toml + "[[task]]\nmethod_map = \"n\"\n", {&stop, {}});
    EXPECT_EQ(fact(run.results, "n.natural_frequency"), "none");
    EXPECT_EQ(fact(run.results, "s.1.label"), "none");
    return in_words(run.failure).substr(files.size());
  };
  EXPECT_EQ(ended("[[task]]\nsweep = \"s\"\ndamping = 1\ndrive_amplitude = 1\ndrive_frequency = [1, 2]\n"),
            "lab.toml:1:1: sweep s: interrupted");
  EXPECT_EQ(ended("[[task]]\nsimulate = \"s\"\nnetwork = \"../../../../data/networks/pendulums.toml\"\n"
                  "until = 1\n"),
            "lab.toml:1:1: simulate s: interrupted");
}

TEST(RunStudy, AFitSaysWhichRunFailed) {
  const std::string file = testing::TempDir() + "cromer_study_runs.csv";
  std::ofstream rows(file);
  rows << "Run 1: Time (s),Run 1: Position (m),Run 2: Time (s),Run 2: Position (m)\n";
  for (int n = 0; n < 200; ++n) rows << fmt::format("{0},{1},{0},2\n", 0.05 * n, std::cos(0.3 * n));
  rows.close();
  const std::string fit = "[[task]]\nfit = \"lab\"\nlaw = \"viscous\"\nfile = \"" + file + "\"\n";
  const std::string all = in_words(done(fit).failure), second = in_words(done(fit + "run = 2\n").failure);
  const StudyRun first = done(fit + "run = 1\n");
  std::remove(file.c_str());
  const std::string where = files + "lab.toml:1:1: fit lab: " + file;
  EXPECT_TRUE(first.failure.empty());
  EXPECT_NEAR(value(first.results, "lab.angular_frequency"), 6, 1e-9);
  EXPECT_EQ(all, where + ": run 2: all values are the same: nothing moves");
  EXPECT_EQ(second, where + ": all values are the same: nothing moves");
}

TEST(RunStudy, OptionsOfOtherTasksAreNone) {
  EXPECT_EQ(refusal("[[task]]\nspectrum = \"s\"\nfile = \"shaken.csv\"\nmas = 1\n").substr(0, 14),
            "lab.toml:4:7: ");
  EXPECT_EQ(refusal("[[task]]\ndifference = \"d\"\nof = \"a.1\"\nminus = \"b.1\"\nmas = 1\n").substr(0, 14),
            "lab.toml:5:7: ");
  EXPECT_EQ(refusal("[[task]]\nsweep = \"s\"\nmas = [1, 2]\n").substr(0, 14), "lab.toml:3:7: ");
  EXPECT_NE(refusal("[[task]]\nsweep = \"s\"\nmethod = [\"rk4\", \"verlet\"]\n"), "");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
