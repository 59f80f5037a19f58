// What a figure of a recording beside simulations holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "cromer/figures/figures.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;

/// 8.849 rad/s about 0.2 m, 100 times a second.
std::string swing(double duration, int runs = 1) {
  std::string file = "Time (s)";
  for (int run = 1; run <= runs; ++run) file += ",Run " + std::to_string(run) + ": Position (m)";
  file += "\n";
  std::mt19937 noise(1);
  for (int i = 0; i < 100 * duration; ++i) {
    const double t = 0.01 * i;
    file += std::to_string(t);
    for (int run = 0; run < runs; ++run)
      file += "," + std::to_string(0.2 + 0.036 * std::exp(-0.02 * t) * std::cos(8.849 * t) +
                                   std::normal_distribution(0.0, 1e-4)(noise));
    file += "\n";
  }
  return file;
}

std::vector<CompareResult> compared(const std::string& file, CompareOptions options) {
  options.fit.law = "viscous";
  auto found = compare(file, "lab.csv", options);
  EXPECT_TRUE(found.ok());
  return *std::move(found);
}

Figure drawn(const std::vector<CompareResult>& found, const char* panels) {
  return compare_figure(found, *parse_panels(panels));
}

std::vector<std::string> names_of(const Panel& panel) {
  std::vector<std::string> names;
  for (const Curve& curve : panel.curves) names.push_back(curve.role + ": " + curve.name);
  return names;
}

TEST(CompareFigure, HasTheLawOneRateAndEachMethodInEveryPanel) {
  CompareOptions options;
  options.method = {"euler-cromer", "rk4"};
  const auto found = compared(swing(5), options);
  const Figure figure = drawn(found, "velocity,phase,energy,position");
  ASSERT_EQ(figure.panels.size(), 4u);
  for (const Panel& panel : figure.panels)
    EXPECT_THAT(names_of(panel),
                ElementsAre("measured: measured", "fitted: viscous", "constant-rate: one constant rate",
                            "euler-cromer: Euler-Cromer", "rk4: RK4"));
  EXPECT_EQ(figure.panels[0].y.name, "velocity {/:Italic v} (cm/s)");
  EXPECT_EQ(figure.panels[1].x.name, figure.panels[3].y.name);
  EXPECT_EQ(figure.panels[2].y.name, "energy {/:Italic E} (mJ/kg)");
  EXPECT_TRUE(figure.shared_x);
  // Of what was measured as of the law: its velocity and energy.
  const double v = 0.036 * 8.849;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const std::vector<double>& up = figure.panels[0].curves[i].y;
    EXPECT_NEAR(*std::max_element(up.begin(), up.end()), 100 * v, 4) << i;
    const std::vector<double>& energy = figure.panels[2].curves[i].y;
    EXPECT_NEAR(*std::max_element(energy.begin(), energy.end()), 500 * v * v, 3) << i;
  }
  CompareOptions with_mass = options;
  with_mass.fit.mass = {Quantity{0.2, 0}};
  EXPECT_EQ(drawn(compared(swing(5), with_mass), "energy").panels[0].y.name, "energy {/:Italic E} (mJ)");
}

TEST(CompareFigure, SaysWhatEachMethodMakesOfTheLaw) {
  CompareOptions options;
  options.method = {"forward-euler", "implicit-euler", "euler-cromer", "rk4"};
  const Panel panel = drawn(compared(swing(13), options), "position").panels[0];
  std::vector<std::string> remarks;
  bool wide = true;
  for (const Curve& curve : panel.curves) {
    if (curve.role == "forward-euler") {
      EXPECT_EQ(curve.sets_axes, false);
      wide = false;
    }
    if (!curve.name.empty()) remarks.push_back(curve.remark);
  }
  EXPECT_FALSE(wide);
  ASSERT_EQ(remarks.size(), 7u);
  EXPECT_EQ(remarks[1], "within 0.5 % at the end");
  EXPECT_THAT(remarks[3], ::testing::HasSubstr("% too large"));
  EXPECT_THAT(remarks[4], ::testing::HasSubstr("% too small"));
  EXPECT_THAT(remarks[5], ::testing::EndsWith("rad ahead of the law"));
  EXPECT_EQ(remarks[6], "as the law");
  EXPECT_TRUE(panel.names_listed);
}

TEST(CompareFigure, OfALongRecordThePortraitIsItsFirstAndLastPeriods) {
  const auto found = compared(swing(60), {});
  const Panel panel = drawn(found, "phase").panels[0];
  EXPECT_EQ(panel.title, "Phase portrait of the first 5 and the last 3 periods");
  const auto points = static_cast<double>(panel.curves[1].x.size());
  EXPECT_NEAR(points, 8 * 71, 5);
  // No envelope begins at the start of a swing, where a velocity is 0.
  const Figure velocity = drawn(found, "velocity");
  for (const Curve& curve : velocity.panels[0].curves)
    if (curve.role == "fitted") {
      for (const double each : curve.y) EXPECT_GT(std::abs(each), 5);
    }
}

TEST(CompareFigure, OfWhatCouldNotBeFittedTheSamplesAreDrawn) {
  std::string file = "Time (s),Position (m)\n";
  std::mt19937 noise(1);
  for (int i = 0; i < 500; ++i)
    file += std::to_string(0.01 * i) + "," + std::to_string(std::normal_distribution(0.0, 1.0)(noise)) + "\n";
  const Figure figure = drawn(compared(file, {}), "velocity,energy,phase");
  ASSERT_EQ(figure.panels.size(), 1u);
  EXPECT_THAT(names_of(figure.panels[0]), ElementsAre("measured: measured"));
}

TEST(CompareFigure, ManyRunsHaveARowEach) {
  CompareOptions options;
  options.fit.column = "Position";
  const auto found = compared(swing(3, 4), options);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(drawn(found, "position").columns, 3);
  const Figure figure = drawn(found, "position,phase");
  EXPECT_EQ(figure.columns, 2);
  ASSERT_EQ(figure.panels.size(), 8u);
  std::vector<std::string> key;
  for (const Curve& curve : figure.key) key.push_back(curve.role + ": " + curve.name);
  EXPECT_THAT(key, ElementsAre("measured: measured", "fitted: law", "constant-rate: one constant rate",
                               "euler-cromer: Euler-Cromer"));
  for (const Panel& panel : figure.panels)
    for (const Curve& curve : panel.curves) EXPECT_EQ(curve.name + curve.remark, "");
  EXPECT_EQ(figure.note, "");
  EXPECT_EQ(figure.panels[6].title, "Run 4: viscous");
  EXPECT_EQ(figure.panels[7].title, "Run 4: Phase portrait");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
