// Springs that yield, against a plain integration in very short steps.
#include "cromer/analysis/yielding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cromer::core {
namespace CROMER_FILE {

/// The force follows the spring from the one before, and stays between those of yield.
double peak_in_short_steps(const YieldingOscillator& of, double yield) {
  constexpr int parts = 4000;
  const double h = of.spacing / parts, most = of.w * of.w * yield, c = 2 * of.damping_ratio * of.w;
  double x = 0, v = 0, force = 0, largest = 0;
  for (std::size_t i = 0; i + 1 < of.acceleration.size(); ++i)
    for (int part = 0; part < parts; ++part) {
      const double a = std::lerp(of.acceleration[i], of.acceleration[i + 1], (part + 0.5) / parts);
      const double middle = v + 0.5 * h * (-a - c * v - force);
      x += h * middle;
      force = std::clamp(force + of.w * of.w * h * middle, -most, most);
      v = middle + 0.5 * h * (-a - c * middle - force);
      largest = std::max(largest, std::abs(x));
    }
  return largest;
}

std::vector<double> shaken() {
  std::vector<double> a;
  for (int i = 0; i < 400; ++i) {
    const double t = 0.02 * i;
    a.push_back(3 * std::exp(-0.3 * t) * (std::sin(9 * t) + 0.7 * std::cos(23 * t + 1) + 0.3 * t));
  }
  return a;
}

TEST(Yielding, FollowsAPlainIntegration) {
  const std::vector<double> a = shaken();
  for (const double w : {2.0, 12.0, 60.0})
    for (const double damping : {0.0, 0.05, 0.4}) {
      const YieldingOscillator oscillator{a, 0.02, w, damping};
      const double elastic = oscillator.peak(1e9);
      for (const double part : {0.7, 0.3, 0.1}) {
        const double plain = peak_in_short_steps(oscillator, part * elastic);
        EXPECT_NEAR(oscillator.peak(part * elastic), plain, 2e-4 * plain)
            << w << " " << damping << " " << part;
      }
    }
}

TEST(Yielding, TheStrongestSpringThatReachesTheDuctility) {
  const std::vector<double> a = shaken();
  const YieldingOscillator oscillator{a, 0.02, 12, 0.05};
  const double elastic = oscillator.peak(1e9);
  for (const double ductility : {1.5, 4.0, 8.0}) {
    const double yield = oscillator.yield_displacement(ductility, elastic);
    EXPECT_NEAR(oscillator.peak(yield) / yield, ductility, 1e-3 * ductility);
    for (double stronger = 1.001 * yield; stronger < elastic; stronger *= 1.03)
      EXPECT_LT(oscillator.peak(stronger) / stronger, ductility) << stronger / yield;
  }
  const std::vector<double> still(100, 0.0);
  EXPECT_EQ((YieldingOscillator{still, 0.02, 12, 0.05}.yield_displacement(4, 0)), 0);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
