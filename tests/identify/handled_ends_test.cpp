// Ends of a part that a hand may not have left alone.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "cromer/identify/diagnose/undisturbed.h"
#include "cromer/identify/law_fit.h"
#include "cromer/model/sensor.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double period = 1.25, rate = 0.03;

/// Six swings; in the last one a hand takes hold and damps it by `more` [1/s] as well.
struct Held {
  std::vector<double> t, y;

  Held(std::uint64_t seed, double more) {
    NormalDeviates noise(seed);
    for (int i = 0; i < 600; ++i) {
      const double at = i * 6 * period / 599, late = std::max(0.0, at - 5 * period);
      t.push_back(at);
      y.push_back(std::exp(-rate * at - more * late) * std::cos(2 * M_PI / period * at) +
                  1e-3 * noise.next());
    }
  }
  LawFit fit(double last, std::size_t samples = 600) const {
    Record record = Record{t, y}.first(samples);
    record.handled_last = last;
    return fit_law(record, {});
  }
};

TEST(HandledEnds, WhatASwingLessWouldChangeIsInTheUncertainties) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Held held(seed, 0.1);
    const Estimate sharp = held.fit(0).decay_rate(), wide = held.fit(period).decay_rate(),
                   without = held.fit(0, 500).decay_rate();
    EXPECT_EQ(sharp.value, wide.value);
    EXPECT_GT(std::abs(sharp.value - rate), 3 * sharp.standard_error);
    EXPECT_LT(std::abs(wide.value - rate), 2 * wide.standard_error);
    const double moved = std::sqrt(std::pow(wide.standard_error, 2) - std::pow(sharp.standard_error, 2));
    EXPECT_NEAR(moved, std::abs(without.value - wide.value), 0.1 * moved);
  }
}

TEST(HandledEnds, OfAFreeSwingMoveLittle) {
  double wider = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Held free(seed, 0);
    wider += free.fit(period).decay_rate().standard_error / free.fit(0).decay_rate().standard_error / 10;
  }
  EXPECT_LT(wider, 1.5);
}

// A viscous law alone would describe a few swings of these.
TEST(FreeSwing, IsTakenWholeWhereDragOrABentSpringChangeIt) {
  for (const bool bent : {false, true}) {
    NormalDeviates noise(3);
    std::vector<double> t, y;
    double x = 0.1, v = 0;
    const double h = 1e-3;
    for (int i = 0; i < 50'000; ++i) {
      const double at = i * h;
      if (i % 20 == 0) {
        t.push_back(at);
        y.push_back((at < 5 || at >= 40 ? 0.05 * std::cos(2.1 * at + std::sin(at)) : x) +
                    2e-4 * noise.next());
      }
      if (at < 5 || at >= 40) continue;
      v -= h * (25 * x + (bent ? 750 * x * x * x + 0.1 * v : 0.6 * v * std::abs(v)));
      x += h * v;
    }
    const auto found = find_free_swing({t, y});
    ASSERT_TRUE(found && found->to) << bent;
    EXPECT_NEAR(found->from, 5, 0.7) << bent;
    EXPECT_NEAR(*found->to, 40, 0.7) << bent;
  }
}

// Five periods between two hands; from 8 s on one may touch it already. What swings along besides lets no law
// leave noise alone.
std::optional<FreeSwing> swing_of_five_periods(double touch, std::uint64_t seed) {
  NormalDeviates noise(seed);
  std::vector<double> t, y;
  for (int i = 0; i < 600; ++i) {
    const double at = 0.02 * i, late = std::max(0.0, at - 8);
    const bool is_free = at >= 2.8 && at < 9.2;
    t.push_back(at);
    y.push_back((is_free ? std::exp(-rate * at - touch * late) * std::cos(2 * M_PI / period * at)
                         : 0.5 * std::cos(2.1 * at + std::sin(at))) +
                0.03 * std::cos(15 * at) + 3e-3 * noise.next());
  }
  return find_free_swing({t, y});
}

TEST(FreeSwing, EndsWhereItIsTouched) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto free = swing_of_five_periods(0, seed), touched = swing_of_five_periods(0.3, seed);
    ASSERT_TRUE(free && free->to && touched && touched->to) << seed;
    EXPECT_NEAR(*free->to, 9.2, 0.3) << seed;
    EXPECT_LT(*touched->to, 8.7) << seed;
    EXPECT_GT(*touched->to, 7.7) << seed;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
