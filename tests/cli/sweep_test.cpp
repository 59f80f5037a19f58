// cromer sweep: its options, what it prints, its exit status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <signal.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::vector<std::string> curve{"sweep", "--damping-ratio",  "0.1", "--drive-amplitude",
                                     "1",     "--drive-frequency"};

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// T = sqrt((1 + (2 z r)^2)/((1 - r^2)^2 + (2 z r)^2)): in closed form, and stepped until it has settled.
TEST(SweepCommand, TransmissibilityIsTheClosedForm) {
  const Folder folder;
  const auto rows_of = [&](std::vector<std::string> more) {
    more.insert(more.begin(),
                {"sweep", "--natural-frequency", "3 Hz", "--damping-ratio", "0.02,0.1,0.7", "--drive", "base",
                 "--base-displacement", "2 mm", "--drive-frequency", "0.3,2,2.9,3,4,4.5,30 Hz", "--measure",
                 "transmissibility,amplitude", "-o", "-"});
    const Finished end = folder.run(more);
    EXPECT_EQ(end.status, 0) << end.err;
    std::vector<std::array<double, 4>> rows;
    std::istringstream lines(end.out);
    for (std::string line; std::getline(lines, line);) {
      std::array<double, 4> row{};
      if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &row[0], &row[1], &row[2], &row[3]) == 4)
        rows.push_back(row);
    }
    EXPECT_THAT(end.out, HasSubstr("transmissibility,amplitude (m)"));
    return rows;
  };
  const auto truth = [](double zeta, double w) {
    const double r = w / (6 * M_PI), damped = 4 * zeta * zeta * r * r;
    return std::sqrt((1 + damped) / ((1 - r * r) * (1 - r * r) + damped));
  };
  const auto exact = rows_of({"--method", "exact"});
  ASSERT_EQ(exact.size(), 21u);
  for (const auto& [zeta, w, found, relative] : exact)
    EXPECT_NEAR(found / truth(zeta, w), 1, 1e-11) << zeta << " " << w;
  for (const auto& [zeta, w, found, relative] :
       rows_of({"--method", "rk4", "--step", "1 ms", "--settle", "200"}))
    EXPECT_NEAR(found / truth(zeta, w), 1, 2e-3) << zeta << " " << w;
  const Finished forced = folder.run({"sweep", "--natural-frequency", "3 Hz", "--drive-amplitude", "1",
                                      "--drive-frequency", "1:5:10", "--measure", "transmissibility"});
  EXPECT_EQ(forced.status, 2);
  EXPECT_THAT(forced.err, HasSubstr("--measure transmissibility compares the mass with the base"));
}

TEST(SweepCommand, WritesTheColumnsOfTheContract) {
  const Folder folder;
  const Finished end =
      folder.run(with(curve, {"0.5:2:4", "--method", "exact", "-o", "curve.csv", "--plot", "curve.svg"}));
  ASSERT_EQ(end.status, 0) << end.err;
  const std::string csv = folder.read("curve.csv");
  EXPECT_THAT(csv, StartsWith("drive_frequency (rad/s),amplitude (m),phase (rad)\n0.5,1.3216"));
  EXPECT_THAT(folder.read("curve.svg"), HasSubstr("amplitude (m)"));
}

TEST(SweepCommand, TellsItsRowsInJson) {
  const auto json =
      Folder()
          .run(with(curve, {"0.5,1", "--measure", "phase,amplitude", "--method", "exact", "--json"}))
          .json();
  EXPECT_EQ(json["columns"][1], "phase (rad)");
  EXPECT_NEAR(json["rows"][1][1].get<double>(), std::acos(-1.0) / 2, 1e-12);
  EXPECT_NEAR(json["rows"][1][2].get<double>(), 5, 1e-12);
  EXPECT_EQ(json["way"], "closed form");
  EXPECT_EQ(json["steps"], "");
  EXPECT_EQ(json["swept"][0]["name"], "drive-frequency");
}

TEST(SweepCommand, ShowsGridsInTheirUnit) {
  const Folder folder;
  const std::vector<std::string> asked{"sweep",
                                       "--damping-ratio",
                                       "2,5 %",
                                       "--drive-amplitude",
                                       "1",
                                       "--drive-frequency",
                                       "0.1:0.2:3 Hz",
                                       "--method",
                                       "exact",
                                       "--plot",
                                       "hz.svg"};
  const Finished end = folder.run(asked);
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("damping_ratio (%)  drive_frequency (Hz)  amplitude (m)"));
  EXPECT_THAT(end.out, HasSubstr("\n                2                  0.15"));
  EXPECT_THAT(folder.read("hz.svg"), HasSubstr("drive frequency (Hz)"));
  EXPECT_THAT(folder.read("hz.svg"), HasSubstr("damping ratio (%)"));
  EXPECT_THAT(folder.run(with(asked, {"-o", "-"})).out,
              StartsWith("damping_ratio,drive_frequency (rad/s),amplitude (m),phase (rad)\n0.02,0.628"));
  const auto json = folder.run(with(asked, {"--json"})).json();
  EXPECT_EQ(json["columns"][1], "drive_frequency (rad/s)");
  const Finished map = folder.run({"sweep", "--damping-ratio", "2:5:20 %", "--drive-amplitude", "1",
                                   "--drive-frequency", "12:6:20:log rpm", "--plot", "map.svg"});
  ASSERT_EQ(map.status, 0) << map.err;
  EXPECT_THAT(folder.read("map.svg"), HasSubstr("drive frequency (rpm)"));
}

TEST(SweepCommand, IsATaskOfAStudy) {
  const Folder folder;
  folder.write(
      "s.toml",
      "[[task]]\nsweep = \"family\"\nmethod = \"exact\"\ndrive_amplitude = 1\n"
      "drive_frequency = \"0.1:0.2:11 Hz\"\ndamping_ratio = [\"0.02\", \"0.05\"]\n"
      "[[figure]]\nid = \"curves\"\nx = \"drive_frequency\"\ny = \"amplitude\"\nx_unit = \"Hz\"\n"
      "[[figure.curve]]\nof = \"family.1\"\nname = \"{family.1.damping_ratio, %}\"\n"
      "[[figure.curve]]\nof = \"family.2\"\nname = \"{family.2.damping_ratio, %}\"\n"
      "[[block]]\nfigure = \"curves\"\n"
      "[[block]]\ntable = \"Peaks\"\nheader = [\"curve\", \"largest\", \"at\"]\neach = [\"family\"]\n"
      "row = [\"{.label}\", \"{.amplitude.largest, 4}\", \"{.amplitude.largest_at, Hz, 3}\"]\n"
      "[[block]]\ntable = \"All\"\nheader = [\"point\", \"phase\"]\neach = [\"family.point\"]\n"
      "row = [\"{.label}\", \"{.phase, 3}\"]\n"
      "[[block]]\ntext = \"{family.points} points, {family.way}.\"\n");
  const Finished end = folder.run({"report", "s.toml", "-o", "out"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto results = nlohmann::json::parse(folder.read("out/results.json"), nullptr, false);
  const auto rows = folder
                        .run({"sweep", "--damping-ratio", "0.02,0.05", "--drive-amplitude", "1", "--method",
                              "exact", "--drive-frequency", "0.1:0.2:11 Hz", "--json"})
                        .json()["rows"];
  double largest = 0, where = 0;
  for (std::size_t i = 11; i < 22; ++i)
    if (rows[i][2].get<double>() > largest) largest = rows[i][2], where = rows[i][1];
  EXPECT_EQ(results["family.2.amplitude.largest"]["value"].get<double>(), largest);
  EXPECT_EQ(results["family.2.amplitude.largest_at"]["value"].get<double>(), where);
  EXPECT_EQ(results["family.point.22.phase"]["value"].get<double>(), rows[21][3].get<double>());
  const std::string page = folder.read("out/index.html");
  EXPECT_THAT(page, HasSubstr("22 points, closed form."));
  EXPECT_THAT(page, HasSubstr("damping ratio 0.05, drive frequency 0.2 Hz"));
  EXPECT_TRUE(folder.has("out/curves.svg"));
  const auto refused = [&](const std::string& keys) {
    folder.write("s.toml", "[[task]]\nsweep = \"a\"\n" + keys);
    const Finished bad = folder.run({"report", "s.toml", "-o", "bad"});
    EXPECT_NE(bad.status, 0);
    EXPECT_FALSE(folder.has("bad"));
    return bad.err;
  };
  EXPECT_THAT(refused("position = \"1:2:0\"\n"), HasSubstr("no points"));
  EXPECT_THAT(refused("every = 2\n"), HasSubstr("s.toml:3:9: --every: a sweep keeps measures"));
  EXPECT_THAT(refused("positon = 2\n"), HasSubstr("did you mean \"position\""));
  EXPECT_THAT(refused("drive_amplitude = 1\ndrive_frequency = [1, 2]\n"), HasSubstr("no point settled"));
}

TEST(SweepCommand, ObeysTheInstructionSetAskedFor) {
  std::set<std::string> rows;
  int sets = 0;
  for (const char* simd : {"baseline", "avx2", "avx512"}) {
    setenv("CROMER_SIMD", simd, 1);
    const Finished end = Folder().run(with(curve, {"0.5:1.5:40", "--cubic", "0.2", "--json"}));
    unsetenv("CROMER_SIMD");
    if (end.status == 2) {
      EXPECT_THAT(end.err, HasSubstr("no such instructions"));
      continue;
    }
    EXPECT_EQ(end.json()["simd"], simd);
    ++sets;
    rows.insert(end.json()["rows"].dump());
  }
  // Fused multiplications leave other last digits than separate ones.
  if (sets > 1) {
    EXPECT_GT(rows.size(), 1u);
  }
  setenv("CROMER_SIMD", "sse9", 1);
  const Finished refused = Folder().run(with(curve, {"0.5:1.5:4"}));
  unsetenv("CROMER_SIMD");
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("CROMER_SIMD=sse9"));
}

TEST(SweepCommand, SaysWhatBecameOfEveryPoint) {
  // Forward Euler's limit is h = 2 b/w0^2.
  const std::vector<std::string> steps{
      "sweep",    "--damping",     "0.2",    "--drive-amplitude", "1", "--drive-frequency", "0.5,40",
      "--method", "forward-euler", "--step", "0.02,0.3"};
  const Folder folder;
  const Finished end = folder.run(with(steps, {"--json", "--provenance", "-o", "steps.csv"}));
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.err,
              HasSubstr("2 of 4 points are unstable: the free motion of the law, as forward-euler has it, "
                        "grows without end"));
  EXPECT_THAT(end.err, HasSubstr("warning: the lag of 1 of 4 points lies outside 0 to pi"));
  const auto json = end.json();
  EXPECT_EQ(json["statuses"], (std::vector<std::string>{"settled", "settled", "unstable", "unstable"}));
  EXPECT_EQ(json["unstable"], 2);
  EXPECT_EQ(json["not_settled"], 0);
  EXPECT_EQ(json["phase_outside"], 1);
  EXPECT_THAT(json["warnings"].dump(), HasSubstr("outside 0 to pi"));
  const std::string csv = folder.read("steps.csv");
  EXPECT_THAT(csv, StartsWith("# cromer sweep "));
  EXPECT_THAT(csv, HasSubstr("\n# by forward-euler, closed form\n# 4 points: 2 settled, 2 unstable\nstep "
                             "(s),drive_frequency (rad/s),amplitude"));
  EXPECT_THAT(csv, HasSubstr("\n0.3,40,,\n"));
}

TEST(SweepCommand, SaysWhatAnUndampedLawSettlesBy) {
  const std::vector<std::string> undamped{"sweep", "--drive-amplitude", "1", "--drive-frequency", "0.5,2"};
  const Finished rk4 = Folder().run(with(undamped, {"--method", "rk4", "--json"}));
  EXPECT_EQ(rk4.status, 0) << rk4.err;
  EXPECT_THAT(rk4.err,
              HasSubstr("warning: 2 of 2 points have no damping in the law: what settles there settles by "
                        "rk4's own damping alone: decay rate "));
  EXPECT_EQ(rk4.json()["statuses"][0], "settled_by_own_damping");
  const Finished verlet = Folder().run(with(undamped, {"--method", "verlet"}));
  EXPECT_EQ(verlet.status, 1);
  EXPECT_THAT(verlet.err, HasSubstr("2 of 2 points never settled: the law has no damping"));
}

TEST(SweepCommand, DrawsBothDirections) {
  const Folder folder;
  const Finished end = folder.run({"sweep", "--cubic", "0.3", "--damping", "0.1", "--drive-amplitude", "0.3",
                                   "--drive-frequency", "0.8:2:60", "--direction", "both", "-o", "both.csv",
                                   "--plot", "both.svg", "--json"});
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_THAT(folder.read("both.csv"),
              StartsWith("direction,drive_frequency (rad/s),amplitude (m),phase (rad)\n1,0.8,"));
  EXPECT_THAT(folder.read("both.csv"), HasSubstr("\n-1,2,"));
  EXPECT_EQ(end.json()["rows"].size(), 120u);
  EXPECT_EQ(end.json()["swept"][0]["name"], "direction");
  const std::string figure = folder.read("both.svg");
  EXPECT_THAT(figure, HasSubstr(">up<"));
  EXPECT_THAT(figure, HasSubstr(">down<"));
  EXPECT_THAT(figure, HasSubstr("stroke-dasharray"));
}

TEST(SweepCommand, NamesNoCurveThatHasNoNumbers) {
  const Folder folder;
  const Finished end = folder.run({"sweep", "--damping-ratio", "0.1", "--drive-amplitude", "1",
                                   "--drive-frequency", "0.5:2:20", "--step", "0.05,0.3,0.5", "--method",
                                   "forward-euler", "--measure", "amplitude", "--plot", "steps.svg"});
  ASSERT_EQ(end.status, 1) << end.err;
  const std::string figure = folder.read("steps.svg");
  EXPECT_THAT(figure, HasSubstr(">0.05<"));
  EXPECT_THAT(figure, Not(HasSubstr(">0.3<")));
  EXPECT_THAT(figure, HasSubstr("no numbers: 0.3, 0.5"));
}

TEST(SweepCommand, InterruptedSaysSoOnBothStreams) {
  const Folder folder;
  const pid_t process = folder.start({"sweep", "--cubic", "0.1", "--position", "0:1:400", "--velocity",
                                      "0:1:400", "--until", "10000", "-o", "part.json", "--threads", "1"});
  ASSERT_TRUE(wait_for_handler(process, SIGINT));
  usleep(100000);
  kill(process, SIGINT);
  const Finished end = folder.wait(process);
  EXPECT_EQ(end.status, 1);
  EXPECT_THAT(end.err, HasSubstr("interrupted after "));
  EXPECT_THAT(end.out, ::testing::ContainsRegex("\ninterrupted: [0-9]+ of 160000 points\n"));
  const auto json = nlohmann::json::parse(folder.read("part.json"), nullptr, false);
  EXPECT_EQ(json["statuses"].size(), 160000u);
  EXPECT_EQ(json["statuses"].back(), "not_reached");
}

TEST(SweepCommand, WritesThinnedTrajectoriesOfEveryPoint) {
  const Folder folder;
  const std::vector<std::string> law{"--damping", "0.1", "--cubic", "0.3", "--until", "5", "--step", "0.01"};
  const Finished end = folder.run(with(with({"sweep", "--position", "0.5,1", "--method", "rk4"}, law),
                                       {"--trajectories", "motion.csv", "--every", "25", "-o", "ends.csv"}));
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_THAT(end.err, HasSubstr("note: --trajectories: 2 points, about 42 states, at most some "));
  const std::string rows = folder.read("motion.csv");
  // As simulate has them, one after the other.
  std::string expected = "position (m),t (s),x (m),v (m/s)\n";
  for (const char* position : {"0.5", "1"}) {
    const Finished one = folder.run(with(with({"simulate", "--position", position, "--method", "rk4",
                                               "--json", "--every", "25", "-o", "one.csv"},
                                              law),
                                         {}));
    ASSERT_EQ(one.status, 0) << one.err;
    std::istringstream lines(folder.read("one.csv"));
    for (std::string line; std::getline(lines, line);) {
      // run, t, x, v, and what else there is
      const auto t = line.find(',') + 1;
      if (line.empty() || line.starts_with("run")) continue;
      const auto x = line.find(',', t) + 1, v = line.find(',', x) + 1;
      expected += position + ("," + line.substr(t, line.find(',', v) - t)) + "\n";
    }
  }
  EXPECT_EQ(rows, expected);

  const auto refused = [&](const std::vector<std::string>& more, const char* said) {
    const Finished wrong = folder.run(with({"sweep", "--position", "0.5,1"}, more));
    EXPECT_EQ(wrong.status, 2);
    EXPECT_THAT(wrong.err, HasSubstr(said));
    EXPECT_FALSE(folder.has("wrong.csv"));
  };
  refused({"--drive-amplitude", "1", "--drive-frequency", "2", "--trajectories", "wrong.csv"}, "--until");
  refused({"--until", "5", "--trajectories", "wrong.txt"}, "FILE.csv");
  refused({"--until", "5", "--every", "5"}, "--trajectories FILE.csv");
  refused({"--until", "8e12", "--step", "1e-3", "--trajectories", "wrong.csv"}, "free in");
}

TEST(SweepCommand, RefusesBadGridsAndLeavesNothing) {
  const Folder folder;
  const auto refused = [&](const std::vector<std::string>& more, const char* said) {
    const Finished end = folder.run(with(curve, with(more, {"-o", "out.csv"})));
    EXPECT_EQ(end.status, 2) << said;
    EXPECT_THAT(end.err, HasSubstr(said));
    EXPECT_FALSE(folder.has("out.csv"));
  };
  refused({"0.5:"}, "--drive-frequency");
  refused({"1:2:3:4"}, "--drive-frequency");
  refused({"1:2:0"}, "no points");
  refused({""}, "empty");
  refused({"1:2:1e15"}, "need 25 PB");
  refused({"1,x"}, "--drive-frequency");
  refused({"1:2:4 kg"}, "kg");
  refused({"1:2:4", "--measure", "ampltude"}, "did you mean amplitude");
  refused({"1:2:4", "--threads", "0"}, "--threads");
  refused({"1:2:4", "--settle", "-1"}, "--settle");
  refused({"1:2:4", "--mass", "0"}, "be positive");
  refused({"1:2:4", "--every", "1,2"}, "keeps measures and no states");
  refused({"1:2:4", "--seed", "1:5:5"}, "--seed: a sweep measures the motion itself");
  refused({"1:2:4", "--accuracy", "1e-3,1e-4"}, "--step 0.001:0.1:20:log");
  refused({"1:2:4", "--settle", "10,20"}, "one number for all points");
  refused({"1:2:4", "--threads", "1,2"}, "one number for all points");
  refused({"1:2:4", "--tolerance", "1e-6,x"}, "--tolerance");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
