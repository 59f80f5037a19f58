// A kink in an amplitude, on curves that have one at a known place.
#include "cromer/identify/diagnose/kink.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace {

struct Curve {
  std::vector<double> t, amplitude;

  std::optional<Kink> kink() const { return find_kink(t, amplitude); }
};

/// So many amplitudes, whose logarithm grows by `before` and from the one at `place` on falls, more slowly
/// with time.
Curve bent(std::size_t n, std::size_t place, double before, double from = 0, double step = 1) {
  Curve curve;
  for (std::size_t i = 0; i < n; ++i) {
    const double s = static_cast<double>(i) - static_cast<double>(place);
    curve.t.push_back(from + step * static_cast<double>(i));
    curve.amplitude.push_back(0.3 * std::exp(s < 0 ? before * s : -0.1 * s + 0.001 * s * s));
  }
  return curve;
}

TEST(Kink, StandsAtItsPlace) {
  for (const std::size_t place : {8u, 9u, 20u, 31u, 32u})
    for (const double before : {0.0, 0.01, -0.01, 0.05}) {
      const auto kink = bent(40, place, before).kink();
      ASSERT_TRUE(kink) << place << ' ' << before;
      EXPECT_NEAR(kink->t, static_cast<double>(place), 1e-9) << before;
      EXPECT_NEAR(kink->before, before, 1e-9) << place;
      EXPECT_NEAR(kink->after, -0.1, 1e-9) << place;
    }
}

TEST(Kink, AtTimesOfItsOwn) {
  const auto kink = bent(50, 30, 0.02, 100, 0.25).kink();
  ASSERT_TRUE(kink);
  EXPECT_NEAR(kink->t, 107.5, 1e-9);
  EXPECT_NEAR(kink->before, 0.08, 1e-9);
  EXPECT_NEAR(kink->after, -0.4, 1e-9);
}

TEST(Kink, HasEightOnEachSide) {
  ASSERT_TRUE(bent(16, 8, 0).kink());
  EXPECT_NEAR(bent(16, 8, 0).kink()->t, 8, 1e-9);
  EXPECT_FALSE(bent(15, 8, 0).kink());
  EXPECT_FALSE(bent(15, 7, 0).kink());
  EXPECT_FALSE(Curve{}.kink());
}

// A polynomial of the fourth degree and two sinusoids that beat account for these as well.
TEST(Kink, IsNoneInASmoothCurve) {
  for (const double rate : {0.0, 0.02, 0.1}) {
    Curve curve;
    for (int i = 0; i < 60; ++i) {
      const double s = i / 30.0 - 1;
      curve.t.push_back(i);
      curve.amplitude.push_back(
          std::exp(-rate * i + 0.5 * s - s * s + 0.3 * s * s * s - 0.4 * s * s * s * s));
    }
    EXPECT_FALSE(curve.kink()) << rate;
  }
}

TEST(Kink, IsNoneInABeat) {
  for (const double share : {0.3, 0.8, 0.97})
    for (const double turn : {0.7, 1.5, 3.0, 6.0, 12.0})
      for (const double rate : {0.0, 1.2}) {
        Curve beat;
        for (int i = 0; i < 60; ++i) {
          const double s = 2 * i / 59.0 - 1;
          beat.t.push_back(i);
          beat.amplitude.push_back(
              std::sqrt(std::exp(-rate * s) * (1 + share * share + 2 * share * std::cos(turn * s + 1))));
        }
        EXPECT_FALSE(beat.kink()) << share << ' ' << turn << ' ' << rate;
      }
}

}  // namespace
}  // namespace cromer::core
