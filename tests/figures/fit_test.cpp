// What a figure of fitted recordings holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cromer/figures/figures.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;

std::vector<FittedRecording> fitted(const std::string& file, const FitOptions& options = {}) {
  auto found = fit(file, "lab.csv", options);
  EXPECT_TRUE(found.ok());
  return *std::move(found);
}

TEST(FitFigure, OfWhatFollowsNoLawSaysSoAndHasItsUnit) {
  std::string file = "Time (s),Voltage (V)\n";
  std::mt19937 noise(1);
  for (int i = 0; i < 500; ++i)
    file += std::to_string(0.01 * i) + "," + std::to_string(std::normal_distribution(0.0, 1.0)(noise)) + "\n";
  const Figure figure = fit_figure(fitted(file));
  ASSERT_EQ(figure.panels.size(), 1u);
  EXPECT_EQ(figure.panels[0].title, "Voltage, run 1: no law found (no oscillation)");
  EXPECT_EQ(figure.panels[0].y.name, "voltage (V)");
}

TEST(FitFigure, OfManyRecordingsHasTheirNamesInItsKey) {
  std::string file = "Time (s)";
  for (int run = 1; run <= 4; ++run) file += ",Run " + std::to_string(run) + ": Position (m)";
  file += "\n";
  std::mt19937 noise(1);
  for (int i = 0; i < 400; ++i) {
    const double t = 0.01 * i;
    file += std::to_string(t);
    for (int run = 0; run < 4; ++run)
      file +=
          "," + std::to_string(0.036 * std::exp(-0.02 * t) * std::cos(8.849 * t) +
                               std::normal_distribution(0.0, 1e-4)(noise) + (run == 2 && i == 200 ? 0.2 : 0));
    file += "\n";
  }
  FitOptions options;
  options.law = "viscous";
  options.column = "Position";
  const Figure figure = fit_figure(fitted(file, options));
  ASSERT_EQ(figure.panels.size(), 4u);
  EXPECT_EQ(figure.panels[1].title, "lab.csv, run 2: viscous");
  std::vector<std::string> key;
  for (const Curve& curve : figure.key) key.push_back(curve.name);
  EXPECT_THAT(key, ElementsAre("measured", "fitted", "set aside"));
  EXPECT_EQ(figure.key[2].mark, Mark::crosses);
  for (const Panel& panel : figure.panels)
    for (const Curve& curve : panel.curves) EXPECT_EQ(curve.name + curve.remark, "");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
