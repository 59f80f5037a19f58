// What a figure of many motions holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cromer/figures/figures.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace {

TEST(SpectraFigure, OfManyMotionsNamesTheThinLines) {
  std::vector<MotionSpectra> motions;
  for (int m = 0; m < 11; ++m) {
    std::string bytes = "t (s),a (m/s^2)\n";
    for (int i = 0; i < 200; ++i)
      bytes += std::to_string(0.01 * i) + "," + std::to_string((1 + 0.1 * m) * std::sin(0.2 * i)) + "\n";
    const SpectrumFile file{"motion" + std::to_string(m) + ".csv", bytes};
    SpectrumOptions options;
    options.periods = "0.1:2:5:log";
    motions.push_back({{file.name}, response_spectrum({&file, 1}, options)});
    ASSERT_TRUE(motions.back().succeeded());
  }
  const Panel panel = spectra_figure(motions, false).panels[0];
  std::vector<std::string> named;
  for (const Curve& curve : panel.curves)
    if (!curve.name.empty()) named.push_back(curve.role + ": " + curve.name);
  EXPECT_THAT(named, testing::ElementsAre("one-of-many: each motion", "family:2: 84 %",
                                          "family:0: median of 11", "family:2: 16 %"));
  EXPECT_EQ(std::count_if(panel.curves.begin(), panel.curves.end(),
                          [](const Curve& curve) { return curve.role == "one-of-many"; }),
            11);
}

}  // namespace
}  // namespace cromer::core
