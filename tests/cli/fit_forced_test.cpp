// Driven motions on the command line: what is printed, and with which exit status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "program.h"

namespace cromer::core::test {
namespace CROMER_FILE {

using ::testing::HasSubstr;
using ::testing::Not;

// Cromer's own motion under a force of three lines, as `simulate --drive-file` gives it.
std::string rig(const Folder& folder) {
  std::ostringstream force;
  force << "Time (s),Force (N)\n";
  for (int i = 0; i <= 2000; ++i) {
    const double t = 0.02 * i;
    force << t << ',' << std::sin(3 * t) + std::cos(7.3 * t) + std::sin(11 * t + 1) << '\n';
  }
  folder.write("force.csv", force.str());
  const Finished end = folder.run({"simulate",
                                   "--mass",
                                   "0.5",
                                   "--stiffness",
                                   "40",
                                   "--damping",
                                   "0.3",
                                   "--drive-file",
                                   "force.csv",
                                   "--between-samples",
                                   "linear",
                                   "--position",
                                   "0",
                                   "--method",
                                   "dormand-prince",
                                   "--step",
                                   "0.02",
                                   "--until",
                                   "40",
                                   "--sensor-noise",
                                   "1e-4",
                                   "--seed",
                                   "3",
                                   "-o",
                                   "motion.csv"});
  EXPECT_EQ(end.status, 0) << end.err;
  std::istringstream motion(folder.read("motion.csv")), forces(force.str());
  std::string both, a, b;
  while (std::getline(motion, a) && a.starts_with('#')) {
  }
  std::getline(forces, b);
  both = a + ",Force (N)\n";
  while (std::getline(motion, a) && std::getline(forces, b)) both += a + b.substr(b.find(',')) + '\n';
  return both;
}

// A body that a recorded force shakes swings in no way of its own: the column that may hold it is named.
TEST(FitForced, NamesTheColumnOfAForceWhereNoFreeLawAccountsForTheMotion) {
  const Folder folder;
  folder.write("rig.csv", rig(folder));
  const Finished free = folder.run({"fit", "rig.csv"});
  EXPECT_THAT(free.err, HasSubstr("drives the motion, give fit --force-column \"Force\""));
  const Finished forced = folder.run({"fit", "rig.csv", "--force-column", "Force"});
  EXPECT_THAT(forced.err, Not(HasSubstr("say --force-column")));
}

TEST(FitForced, FindsTheSimulatedLaw) {
  const Folder folder;
  folder.write("rig.csv", rig(folder));
  const Finished end = folder.run({"fit", "rig.csv", "--force-column", "Force", "--mass", "0.5 kg",
                                   "--hold-out", "20 %", "--json", "--plot", "fit.svg"});
  ASSERT_EQ(end.status, 0) << end.err;
  const auto json = end.json();
  EXPECT_EQ(json["status"], "converged");
  EXPECT_EQ(json["between_samples"], "linear");
  EXPECT_EQ(json["law"], "viscous");
  const auto near = [&](const char* name, double truth) {
    const auto& parameter = json["parameters"][name];
    EXPECT_NEAR(parameter["value"].get<double>(), truth, 4 * parameter["standard_error"].get<double>())
        << name;
  };
  near("stiffness", 40);
  near("damping", 0.3);
  near("force_gain", 2);
  EXPECT_NEAR(json["residual"]["rms"].get<double>(), 1e-4, 7e-6);    // four standard errors of 1600 samples
  EXPECT_NEAR(json["held_out"]["rms"].get<double>(), 1e-4, 1.4e-5);  // of 400
  EXPECT_EQ(json["held_out"]["samples"], 400);
  EXPECT_EQ(json["candidates"].size(), 17u);
  EXPECT_TRUE(folder.has("fit.svg"));
}

TEST(FitForced, BadInputIsRefusedAndWritesNothing) {
  const Folder folder;
  folder.write("free.csv", recording(500));
  std::istringstream lines(recording(500));
  std::string still, line;
  std::getline(lines, line);
  still = line + ",Force (N)\n";
  while (std::getline(lines, line)) still += line + ",0\n";
  folder.write("still.csv", still);
  const struct {
    std::vector<std::string> arguments;
    const char* said;
  } cases[] = {{{"free.csv", "--force-column", "Force"}, "no column is called"},
               {{"still.csv", "--force-column", "Force"}, "drives nothing"},
               {{"free.csv", "--between-samples", "hold"}, "--between-samples needs --force-column"},
               {{"free.csv", "--drive-frequency", "fast"}, "--drive-frequency"},
               {{"free.csv", "--hold-out", "150 %"}, "--hold-out"}};
  for (const auto& [arguments, said] : cases) {
    std::vector<std::string> all{"fit"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.insert(all.end(), {"-o", "result.json"});
    const Finished end = folder.run(all);
    EXPECT_EQ(end.status, 2) << said;
    EXPECT_THAT(end.err, HasSubstr(said));
    EXPECT_FALSE(folder.has("result.json"));
  }
  const Finished compared = folder.run({"compare", "still.csv", "--force-column", "Force"});
  EXPECT_EQ(compared.status, 2);
  EXPECT_THAT(compared.err, HasSubstr("option of cromer fit"));
}

TEST(FitForced, AFailedFitHasAStatus) {
  const Folder folder;
  std::ostringstream file;
  file << "Time (s),Force (N),Position (m)\n";
  for (int i = 0; i < 20; ++i) file << 0.01 * i << ',' << i % 3 << ',' << 0.01 * (i % 7) << '\n';
  folder.write("short.csv", file.str());
  const Finished end = folder.run({"fit", "short.csv", "--force-column", "Force", "--json"});
  EXPECT_EQ(end.status, 1);
  EXPECT_EQ(end.json()["status"], "too_short");
  EXPECT_THAT(end.json()["message"].get<std::string>(), HasSubstr("too few"));
}

// A body without a spring has no period: the figure shows all of its motion.
TEST(FitForced, WithoutASpringTheFigureShowsTheWholeMotion) {
  std::ostringstream rows;
  rows << "Time (s),Position (m),Force (N)\n";
  double x = 0, v = 0;
  for (int i = 0; i < 800; ++i) {
    const auto force = [&](double t) { return std::sin(2 * t) + 0.5 * std::cos(5 * t); };
    const double t = 0.01 * i;
    rows << t << ',' << std::round(1e6 * x) / 1e6 << ',' << force(t) << '\n';
    for (int k = 0; k < 100; ++k) {
      v += 1e-4 * (force(t + 1e-4 * (k + 0.5)) - 0.8 * v) / 2;
      x += 1e-4 * v;
    }
  }
  const Folder folder;
  folder.write("cart.csv", rows.str());
  const Finished end = folder.run({"fit", "cart.csv", "--column", "Position (m)", "--force-column", "Force",
                                   "--no-spring", "--law", "viscous", "--plot", "cart.svg"});
  ASSERT_EQ(end.status, 0) << end.err;
  const std::string figure = folder.read("cart.svg");
  EXPECT_THAT(figure, HasSubstr("800 samples"));
  EXPECT_THAT(figure, Not(HasSubstr("largest swing")));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::test
