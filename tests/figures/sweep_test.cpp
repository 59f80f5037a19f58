// What a figure of a sweep holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/figures/figures.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;

Figure drawn(const SweepOptions& options) {
  const auto result = sweep(options);
  EXPECT_TRUE(result.ok());
  return *sweep_figure(*result);
}

TEST(SweepFigure, SaysWhatItsNumbersAre) {
  SweepOptions options;
  options.values = {{"damping-ratio", "0.02,0.1"}, {"drive-amplitude", "1"}, {"drive-frequency", "0.5:2:9"}};
  options.measure = {"amplitude"};
  const Panel panel = drawn(options).panels[0];
  EXPECT_EQ(panel.title, "amplitude for each damping ratio");
  std::vector<std::string> names;
  for (const Curve& curve : panel.curves) names.push_back(curve.name);
  EXPECT_THAT(names, ElementsAre("0.02", "0.1"));
}

TEST(SweepFigure, NamesTheLastState) {
  SweepOptions options;
  options.values = {{"stiffness", "9"}, {"position", "0.1:3:9"}, {"until", "20"}};
  options.measure = {"final"};
  const Figure figure = drawn(options);
  ASSERT_EQ(figure.panels.size(), 2u);
  EXPECT_EQ(figure.panels[0].y.name, "final position {/:Italic x} (m)");
  EXPECT_EQ(figure.panels[0].title, "final position {/:Italic x}");
  EXPECT_EQ(figure.panels[1].y.name, "final velocity {/:Italic v} (m/s)");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
