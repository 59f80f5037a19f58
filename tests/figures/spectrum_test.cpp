// What a figure of many motions holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/base/pi.h"
#include "cromer/figures/figures.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

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

/// Whether a value is 1, 2 or 5 times a power of ten.
bool is_round(double value) {
  const double digit = value / std::pow(10.0, std::floor(std::log10(value * 1.0000001)));
  return std::abs(digit - 1) < 1e-6 || std::abs(digit - 2) < 1e-6 || std::abs(digit - 5) < 1e-6;
}

// Along a line of equal displacement v = 2 pi f d, along one of equal acceleration v = a/(2 pi f).
TEST(TripartiteFigure, OfAShockHasPseudoVelocitiesOverItsFrequencies) {
  std::string bytes = "t (s),a (m/s^2)\n";
  for (int i = 0; i <= 1000; ++i)
    bytes += std::to_string(1e-4 * i) + "," +
             std::to_string(i <= 110 ? 500 * std::sin(std::numbers::pi * i / 110.0) : 0) + "\n";
  const SpectrumFile file{"drop.csv", bytes};
  for (const bool by_frequency : {true, false}) {
    SpectrumOptions options;
    options.shock = true;
    options.shock_response = "pseudo-velocity";
    options.damping_ratio = {"2%,10%"};
    (by_frequency ? options.frequencies : options.periods) =
        by_frequency ? "5:2000:60:log Hz" : "0.0005:0.2:60:log";
    const auto result = response_spectrum({&file, 1}, options);
    ASSERT_TRUE(result.ok());
    const Panel panel = tripartite_figure(*result).panels[0];
    int curves = 0, rising = 0, falling = 0;
    for (const Curve& curve : panel.curves) {
      const double up = curve.y.front() / curve.x.front() / two_pi, down = curve.y.front() * curve.x.front();
      if (curve.role != "grid") {
        ++curves;
        // A stiff oscillator follows the base.
        const std::size_t stiff = by_frequency ? curve.x.size() - 1 : 0;
        const double f = by_frequency ? curve.x[stiff] : 1 / curve.x[stiff];
        EXPECT_NEAR(two_pi * f * curve.y[stiff], 500, 10);
      } else if (curve.y.back() > curve.y.front()) {
        ++rising;
        EXPECT_TRUE(is_round(by_frequency ? up : two_pi * two_pi * up)) << up;
      } else {
        ++falling;
        EXPECT_TRUE(is_round(by_frequency ? two_pi * down : down / two_pi)) << down;
      }
    }
    EXPECT_EQ(curves, 2);
    EXPECT_GE(rising, 3);
    EXPECT_GE(falling, 3);
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
