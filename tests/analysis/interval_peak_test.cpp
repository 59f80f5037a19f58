// Extremes inside an interval and after the last one, against the motion looked at thousands of times.
#include "cromer/analysis/interval_peak.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "cromer/base/pi.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Undamped, damped, all but critically and critically, and beyond.
const LinearLaw<double> laws[] = {{.decay_rate = 0, .stiffness = 4},
                                  {.decay_rate = 0.3, .stiffness = 9},
                                  {.decay_rate = 2.9, .stiffness = 9},
                                  {.decay_rate = 3, .stiffness = 9},
                                  {.decay_rate = 8, .stiffness = 9}};

/// Extremes of q strictly inside, each the top of a parabola through three of many values.
template <class Quantity>
Extremes looked_at(const Quantity& q, double until) {
  constexpr int many = 4000;
  Extremes found{infinite, -infinite};
  for (int i = 1; i < many; ++i) {
    const double left = q(until * (i - 1) / many), middle = q(until * i / many),
                 right = q(until * (i + 1) / many);
    if ((middle - left) * (right - middle) > 0) continue;
    found.include(middle - (right - left) * (right - left) / (8 * (right - 2 * middle + left)));
  }
  return found;
}

/// Where there is none, both say so.
void expect_same(double found, double truth, double size) {
  if (std::isfinite(truth)) {
    EXPECT_NEAR(found, truth, 1e-9 * size);
  } else {
    EXPECT_EQ(found, truth);
  }
}

TEST(IntervalPeak, InsideAreTheExtremesOfTheMotion) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  int turns = 0, none = 0;
  for (const auto& law : laws)
    for (const double wh : {0.2, 1.0, 2.5, pi})
      for (int i = 0; i < 12; ++i) {
        const double w = std::sqrt(law.stiffness), h = wh / w;
        const ResponseQuantity<double> quantity{normal(random), i % 3 == 0 ? 0 : normal(random) / w};
        const IntervalMotion motion(law, {normal(random), w * normal(random)}, law.stiffness * normal(random),
                                    i % 4 == 0 ? 0 : law.stiffness * normal(random) / h);
        const auto at = [&](double t) { return propagate_ramp(law, motion.f, motion.slope, t, motion.y); };
        const auto q = [&](double t) { return quantity.x * at(t).x + quantity.v * at(t).v; };
        const Extremes truth = looked_at(q, h);
        // A turn at the very end may be on either side of it.
        if (std::isfinite(truth.high) && std::abs(truth.high - q(h)) < 1e-6) continue;
        Extremes found{infinite, -infinite};
        include_inside(law, quantity, motion, at(h), h, found);
        const double size = std::abs(q(0)) + std::abs(q(h)) + 1;
        SCOPED_TRACE(testing::Message() << law.decay_rate << ' ' << wh << ' ' << i);
        // Values on the way to a turn are the motion's too: none is beyond it.
        const bool tops = !(truth.high <= std::max(q(0), q(h))), dips = !(truth.low >= std::min(q(0), q(h)));
        if (tops || !std::isfinite(truth.high)) expect_same(found.high, truth.high, size);
        if (dips || !std::isfinite(truth.low)) expect_same(found.low, truth.low, size);
        ++(std::isfinite(truth.high) ? turns : none);
      }
  EXPECT_GT(turns, 50);
  EXPECT_GT(none, 20);
}

TEST(IntervalPeak, TheTopIsExact) {
  // x = cos(2 t - 1) turns at 1/2 from 0 to 1, and at 1/2 and 1/2 + pi/2 within half a period from 0.3.
  const LinearLaw<double> law{.decay_rate = 0, .stiffness = 4};
  const IntervalMotion motion(law, {std::cos(-1.0), -2 * std::sin(-1.0)}, 0, 0);
  Extremes found{0, 0};
  include_inside(law, {1, 0}, motion, {std::cos(1.0), -2 * std::sin(1.0)}, 1, found);
  EXPECT_NEAR(found.high, 1, 1e-14);
  EXPECT_EQ(found.low, 0);
}

TEST(IntervalPeak, TheBoundOfTheOvershootIsThatOfAFreeSwing) {
  // x = 3 cos(2 t): x'' = -12 cos(2 t), x''' = 24 sin(2 t); the velocity's are twice that.
  const LinearLaw<double> law{.decay_rate = 0, .stiffness = 4};
  for (const double t : {0.0, 0.4, 1.1}) {
    const IntervalMotion motion(law, {3 * std::cos(2 * t), -6 * std::sin(2 * t)}, 0, 0);
    EXPECT_NEAR(overshoot_bound(law, {1, 0}, motion, 0.1), 0.01 / 8 * 12, 1e-15);
    EXPECT_NEAR(overshoot_bound(law, {0, 1}, motion, 0.1), 0.01 / 8 * 24, 1e-15);
  }
  // A damped one: x = e^{-t} cos(2 t), s = 5. At 0: x'' = -3, x''' = 11, x'''' = -7.
  const LinearLaw<double> damped{.decay_rate = 1, .stiffness = 5};
  const IntervalMotion motion(damped, {1, -1}, 0, 0);
  EXPECT_NEAR(motion.acceleration, -3, 1e-15);
  EXPECT_NEAR(motion.jerk, 11, 1e-15);
  EXPECT_NEAR(overshoot_bound(damped, {1, 0}, motion, 2), 0.5 * std::sqrt(9 + 121 / 5.0), 1e-14);
  EXPECT_NEAR(overshoot_bound(damped, {2, 3}, motion, 2), 0.5 * std::sqrt(27 * 27 + 1 / 5.0), 1e-13);
  // Under a ramp the acceleration begins with the force, the jerk with its slope.
  const IntervalMotion driven(damped, {1, -1}, 7, 2);
  EXPECT_NEAR(driven.acceleration, 4, 1e-15);
  EXPECT_NEAR(driven.jerk, 2 - 8 + 5, 1e-15);
}

TEST(IntervalPeak, AFreeMotionHasItsFirstTwoTurnsAndItsEnd) {
  std::mt19937_64 random(12);
  std::normal_distribution<double> normal;
  for (const auto& law : laws)
    for (int i = 0; i < 40; ++i) {
      const double w = std::sqrt(law.stiffness);
      State<double> y{normal(random), w * normal(random)};
      if (i % 8 == 0) y.v = 0;
      if (i % 8 == 1) y.x = 0;
      const ResponseQuantity<double> quantity{normal(random), i % 3 == 0 ? 0 : normal(random) / w};
      const auto q = [&](double t) {
        const State<double> at = propagate_ramp(law, 0.0, 0.0, t, y);
        return quantity.x * at.x + quantity.v * at.v;
      };
      Extremes truth = looked_at(q, 8 * pi / w), found{infinite, -infinite};
      truth.include(0);
      truth.include(q(0));
      include_free(law, quantity, y, found);
      const double size = std::abs(q(0)) + 1;
      EXPECT_NEAR(found.low, truth.low, 1e-7 * size) << law.decay_rate << ' ' << i;
      EXPECT_NEAR(found.high, truth.high, 1e-7 * size) << law.decay_rate << ' ' << i;
    }
}

TEST(IntervalPeak, AFreeMotionFromRestTurnsHalfAPeriodLater) {
  const LinearLaw<double> law{.decay_rate = 0.3, .stiffness = 9};
  Extremes found{infinite, -infinite};
  include_free(law, {1, 0}, {2, 0}, found);
  EXPECT_EQ(found.high, 2);
  EXPECT_NEAR(found.low, -2 * std::exp(-0.3 * pi / std::sqrt(9 - 0.09)), 1e-14);
  Extremes rest{infinite, -infinite};
  include_free(law, {1, 0}, {0, 0}, rest);
  EXPECT_EQ(rest.low, 0);
  EXPECT_EQ(rest.high, 0);
}

TEST(IntervalPeak, ATurnBeforeTheBeginningIsNone) {
  // It creeps back already: v = -0.1 m/s at 1 m.
  for (const double decay_rate : {3.0, 8.0}) {
    Extremes found{infinite, -infinite};
    include_free({.decay_rate = decay_rate, .stiffness = 9}, {1, 0}, {1, -0.1}, found);
    EXPECT_EQ(found.high, 1) << decay_rate;
    EXPECT_EQ(found.low, 0) << decay_rate;
  }
}

TEST(Extremes, TheMagnitudeIsTheLargerSide) {
  EXPECT_EQ((Extremes{-3, 2}.magnitude()), 3);
  EXPECT_EQ((Extremes{-3, 4}.magnitude()), 4);
  Extremes range{0, 0};
  range.include(2);
  range.include(-1);
  EXPECT_EQ(range.low, -1);
  EXPECT_EQ(range.high, 2);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
