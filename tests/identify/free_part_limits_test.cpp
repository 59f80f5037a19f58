// Where a record is free and where it is lost, on swings made by hand: at each limit and a sample to either
// side of it.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/documents/words/words.h"
#include "cromer/identify/diagnose/free_part.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double h = 0.125;  // [s] times and differences of them are exact

/// Values one after the other.
struct Made {
  std::vector<double> y;
  double resolution = 0;
  std::vector<double> t{};  ///< even if empty

  Made& add(std::size_t samples, const std::vector<double>& pattern, double times = 1) {
    for (std::size_t i = 0; i < samples; ++i) y.push_back(times * pattern[i % pattern.size()]);
    return *this;
  }
  Made& drop(std::size_t samples) {
    y.resize(y.size() - samples);
    return *this;
  }
  std::vector<double> times() const { return t.empty() ? even_times(y.size(), h) : t; }
  /// The same in another unit, from another zero.
  Made in_another_unit(double unit) const {
    Made other{y, unit * resolution, times()};
    for (double& each : other.y) each = unit * (each + 2);
    return other;
  }
  std::optional<LostMotion> lost() const {
    const std::vector<double> at = times();
    const auto found = find_lost_motion({at, y, resolution});
    for (const double unit : {8.0, 0.125}) {
      const Made other = in_another_unit(unit);
      const auto there = find_lost_motion({at, other.y, other.resolution});
      EXPECT_EQ(there.has_value(), found.has_value()) << unit;
      if (there && found) {
        EXPECT_EQ(there->seen, found->seen) << unit;
      }
    }
    return found;
  }
  std::optional<FreePart> free() const {
    const std::vector<double> at = times();
    const auto part = find_free_part({at, y, resolution});
    for (const double unit : {8.0, 0.125}) {
      const auto there = find_free_part({at, in_another_unit(unit).y, 0});
      EXPECT_EQ(there.has_value(), part.has_value()) << unit;
      if (there && part) {
        EXPECT_EQ(in_words(there->reason), in_words(part->reason)) << unit;
      }
    }
    return part;
  }
};

// Seven samples a period; its fifth upward crossing is that of the 30th sample.
const std::vector<double> of_seven{-0.5, 1, 1, 0.5, -0.5, -1, -1};
const std::vector<double> of_eight{-0.5, 0.5, 1, 1, 0.5, -0.5, -1, -1};

TEST(LostMotionLimits, SamplesInAll) {
  const auto found = Made{}.add(48, of_seven).add(16, {3}).lost();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->seen, 48u);
  EXPECT_EQ(found->value, 3);
  EXPECT_EQ(found->share, 1);
  EXPECT_FALSE(Made{}.add(48, of_seven).add(15, {3}).lost());
}

TEST(LostMotionLimits, SamplesThatShowTheMotion) {
  const auto found = Made{}.add(32, of_seven).add(40, {3}).lost();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->seen, 32u);
  EXPECT_FALSE(Made{}.add(31, of_seven).add(40, {3}).lost());
}

TEST(LostMotionLimits, SamplesOfAPeriod) {
  EXPECT_TRUE(Made{}.add(48, of_seven).add(40, {3}).lost());
  EXPECT_FALSE(Made{}.add(48, {-0.5, 1, 1, 0.5, -1, -1}).add(40, {3}).lost());
}

TEST(LostMotionLimits, CrossingsOfTheMiddle) {
  EXPECT_TRUE(Made{}.add(42, of_eight).add(40, {3}).lost());
  EXPECT_FALSE(Made{}.add(33, of_eight).add(40, {3}).lost());  // four
}

TEST(LostMotionLimits, SamplesThatAreLost) {
  const auto found = Made{}.add(56, of_seven).add(8, {3}).lost();  // a period to the sample
  ASSERT_TRUE(found);
  EXPECT_EQ(found->seen, 56u);
  EXPECT_FALSE(Made{}.add(57, of_seven).add(7, {3}).lost());
  // Seven are too few for however long they last, and eight where they last less than a period.
  const auto spaced = [](std::size_t count, double apart) {
    Made made = Made{}.add(57, of_seven).add(count, {3});
    made.t = even_times(57, h);
    for (std::size_t i = 0; i < count; ++i) made.t.push_back(7.125 + static_cast<double>(i) * apart);
    return made.lost().has_value();
  };
  EXPECT_FALSE(spaced(7, 1));
  EXPECT_TRUE(spaced(8, 1));
  EXPECT_TRUE(spaced(15, 0.0625));
  EXPECT_FALSE(spaced(14, 0.0625));
}

TEST(LostMotionLimits, ThreeFifthsOfWhatIsLeft) {
  // So many at the value, then it and spikes by turns.
  const auto with_spikes = [](std::size_t first, std::size_t spikes) {
    Made made = Made{}.add(56, of_seven).add(first, {3});
    for (std::size_t i = 0; i < spikes; ++i) made.add(1, {3}).add(1, {5 + static_cast<double>(i)});
    return made.lost();
  };
  const auto found = with_spikes(8, 16);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->seen, 56u);
  EXPECT_EQ(found->share, 0.6);
  EXPECT_FALSE(with_spikes(6, 17));
}

// Of sixteen samples, and of more than 320 a twentieth.
TEST(LostMotionLimits, TheValueIsThatOfTheLastSamples) {
  const auto found = Made{}.add(80, of_seven).add(20, {3}).add(7, {9}).add(9, {3}).lost();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->value, 3);
  EXPECT_FALSE(Made{}.add(80, of_seven).add(20, {3}).add(9, {9}).add(7, {3}).lost());
  const auto tie = Made{}.add(80, of_seven).add(20, {3}).add(1, {9}).add(16, {3, 9}).lost();
  ASSERT_TRUE(tie);
  EXPECT_EQ(tie->value, 3);
  const auto late = Made{}.add(299, of_seven).add(85, {3}).add(8, {9, 7, 3, 9}).add(8, {9, 9, 3, 8}).lost();
  ASSERT_TRUE(late);
  EXPECT_EQ(late->value, 3);
  EXPECT_EQ(late->seen, 299u);
}

TEST(LostMotionLimits, TheValueIsKnownToHalfARoundingStep) {
  const auto found = Made{{}, 0.125}.add(56, of_seven).add(40, {3, 3.0625, 3.0625}).lost();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->value, 3);
  EXPECT_EQ(found->share, 1);
  const auto two = Made{{}, 0.124}.add(56, of_seven).add(40, {3, 3.0625, 3.0625}).lost();
  ASSERT_TRUE(two);
  EXPECT_EQ(two->value, 3.0625);
  EXPECT_LT(two->share, 0.7);
}

TEST(LostMotionLimits, TheSwingIsLargerThanItsRounding) {
  EXPECT_TRUE((Made{{}, 0.2}.add(56, of_seven).add(40, {3}).lost()));
  EXPECT_FALSE((Made{{}, 0.21}.add(56, of_seven).add(40, {3}).lost()));
}

TEST(LostMotionLimits, TheSwingHasNotDiedDown) {
  EXPECT_TRUE(Made{}.add(2, {10, -10}).add(54, of_seven).add(40, {3}).lost());
  EXPECT_FALSE(Made{}.add(2, {10.125, -10.125}).add(54, of_seven).add(40, {3}).lost());
}

// It stops near the middle from one sample to the next, or jumps from a place at which it was slow, or stays
// where no swing stays.
TEST(LostMotionLimits, ATurningPointIsNone) {
  std::vector<double> slow;  // 24 samples a period, from a turning point on
  for (int i = 0; i < 24; ++i) slow.push_back(std::cos(i * 3.141592653589793 / 12));
  const auto ends_with = [&](std::size_t last, const std::vector<double>& flat, double value) {
    return Made{}.add(144 + last, slow).add(flat.size(), flat).add(60, {value}).lost().has_value();
  };
  EXPECT_TRUE(ends_with(6, {}, 0.01));  // amid the motion
  EXPECT_FALSE(ends_with(13, {-1, -1, -1}, -0.5));
  EXPECT_TRUE(ends_with(13, {-1, -1, -1}, -0.75));
  EXPECT_FALSE(ends_with(13, {-1, -1, -1}, -0.35));
  EXPECT_TRUE(ends_with(13, {-1, -1, -1}, 0));
  EXPECT_TRUE(ends_with(13, {-1, -1, -1}, -3));
  EXPECT_TRUE(ends_with(1, {1, 1, 1}, 0.65));
}

// Ten samples a period from a turning point on; they add up to nothing.
const std::vector<double> of_ten{1, 0.75, 0.25, -0.25, -0.75, -1, -0.75, -0.25, 0.25, 0.75};

TEST(FreePartLimits, HeldDisplaced) {
  // The fifth upward crossing is one of 64 samples.
  const auto part = Made{}.add(12, {1}).add(52, of_ten).free();
  ASSERT_TRUE(part);
  EXPECT_EQ(part->from, 12 * h);
  EXPECT_EQ(in_words(part->reason), "it is held still until 1.5 s");
  EXPECT_FALSE(Made{}.add(12, {1}).add(51, of_ten).free());
}

TEST(FreePartLimits, HeldForHalfAPeriod) {
  const auto part = Made{}.add(4, {1}).add(86, of_ten).free();
  ASSERT_TRUE(part);
  EXPECT_EQ(part->from, 4 * h);
  EXPECT_FALSE(Made{}.add(3, {1}).add(87, of_ten).free());
}

TEST(FreePartLimits, ThreeSamplesInAQuarterPeriod) {
  EXPECT_TRUE(Made{}.add(20, {1}).add(100, {1, 0.5, 0.25, -0.75, -1, -1, -0.75, 0.25, 0.5}).free());
  EXPECT_FALSE(Made{}.add(20, {1}).add(100, {1, 0.5, -0.5, -1, -1, -0.5, 0.5, 1}).free());
}

TEST(FreePartLimits, FourPeriodsAreLeft) {
  // Within the hold nothing crosses: five crossings are four periods and what leads to the first.
  EXPECT_TRUE(Made{}.add(40, {1}).add(50, of_ten).free());
  EXPECT_FALSE(Made{}.add(40, {1}).add(46, of_ten).free());
}

TEST(FreePartLimits, WhatStaysWithinATwentiethIsStill) {
  // Amplitude 1: 0.046875 to either side of the mean of a quarter period.
  const auto part = Made{}.add(12, {1, 1, 1, 0.953125}).add(52, of_ten).add(36, of_ten).free();
  ASSERT_TRUE(part);
  EXPECT_EQ(part->from, 12 * h);
  // Two samples beyond are noise, three are the swing.
  const auto two = Made{}.add(6, {1}).add(2, {0.9375}).add(4, {1}).add(88, of_ten).free();
  ASSERT_TRUE(two);
  EXPECT_EQ(two->from, 12 * h);
  const auto three = Made{}.add(6, {1}).add(3, {0.9375}).add(3, {1}).add(88, of_ten).free();
  ASSERT_TRUE(three);
  EXPECT_EQ(three->from, 5 * h);
  const auto both_sides = Made{}.add(6, {1}).add(3, {0.9375, 1.0625}).add(3, {1}).add(88, of_ten).free();
  ASSERT_TRUE(both_sides);
  EXPECT_EQ(both_sides->from, 12 * h);
}

TEST(FreePartLimits, NoiseWidensTheBand) {
  // Second differences of the first three samples: noise of 0.4/sqrt(6), a band of 0.65.
  EXPECT_TRUE(Made{}.add(12, {1, 0.9, 1.2, 1}).add(88, of_ten).free());
}

// What was at rest, or nearer than half the amplitude to where it then swings, was set going.
TEST(FreePartLimits, HeldAtHalfTheAmplitude) {
  const auto displaced = Made{}.add(20, {0.5}).add(5, {-0.25, -0.75, -1, -1, -0.75}).add(95, of_ten).free();
  ASSERT_TRUE(displaced);
  EXPECT_EQ(displaced->from, 19 * h);
  EXPECT_EQ(in_words(displaced->reason), "it is held still until 2.375 s");
  const auto at_rest =
      Made{}.add(20, {0.484375}).add(5, {-0.25, -0.75, -1, -1, -0.75}).add(95, of_ten).free();
  ASSERT_TRUE(at_rest);
  EXPECT_EQ(in_words(at_rest->reason), "it does not swing until 2.375 s and is then set going");
  // The first large swing is the one down, from the 23rd sample to the 26th.
  EXPECT_EQ(at_rest->from, 25 * h);
}

TEST(FreePartLimits, AFirstLargeSwingHasFourFifthsOfTheAmplitude) {
  const auto with = [](double first) {
    return Made{}.add(20, {0}).add(7, {0.5, first, 0.5, -0.5, -0.5, -0.25, 0.5}).add(93, of_ten).free();
  };
  ASSERT_TRUE(with(0.8));
  EXPECT_EQ(with(0.8)->from, 23 * h);
  ASSERT_TRUE(with(0.7));
  EXPECT_EQ(with(0.7)->from, 30 * h);
}

TEST(FreePartLimits, ABeatRisesSlowly) {
  const auto rises_for = [](std::size_t samples) {
    const std::size_t n = 20 + samples + 2, rest = (n + 29) / 30 * 15;  // the last third is whole periods
    Made made = Made{}.add(20, {0});
    for (std::size_t i = 0; i < samples; ++i)
      made.add(1, {of_ten[(i + 10 - samples % 10) % 10] > 0 ? 0.5 : -0.5});
    return made.add(2 * rest + 60, of_ten).free();
  };
  ASSERT_TRUE(rises_for(20));
  EXPECT_EQ(rises_for(20)->from, 43 * h);
  EXPECT_FALSE(rises_for(21));
}

// Held at the middle of the swing that follows. Beside larger values it is no first large swing.
TEST(FreePartLimits, ValuesThatStickOutWhileItIsHeldAreNoSwing) {
  const auto held_with = [](double out) {
    Made made;
    for (int k = 0; k < 4; ++k) made.add(70, {0}).add(2, {out});
    return made.add(30, {0}).add(700, of_ten).free();
  };
  ASSERT_TRUE(held_with(1));
  EXPECT_EQ(in_words(held_with(1)->reason).substr(0, 17), "it does not swing");
  EXPECT_FALSE(held_with(10));
}

// The envelope: level, and from `stop` on it falls.
std::optional<FreePart> after_a_drive(double stop, double duration, double rate, double samples_per_period,
                                      double rising = 0) {
  Made made;
  const auto n = static_cast<std::size_t>(duration * samples_per_period) + 1;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / samples_per_period;
    made.t.push_back(t);
    made.y.push_back((t < stop ? 1 + rising * (t - stop) : std::exp(-rate * (t - stop))) *
                     std::cos(6.283185307179586 * t + 0.4));
  }
  return made.free();
}

TEST(FreePartLimits, ADriveThatStops) {
  for (const double stop : {12.0, 25.0, 60.0, 150.0})
    for (const double per_period : {6.0, 20.0}) {
      const auto part = after_a_drive(stop, stop + 30, 0.03, per_period);
      ASSERT_TRUE(part) << stop << ' ' << per_period;
      EXPECT_NEAR(part->from, stop + 1, 0.8) << stop << ' ' << per_period;
      EXPECT_NEAR(std::stod(in_words(part->reason).substr(std::string("from ").size())), part->from - 1,
                  0.06);
      EXPECT_TRUE(in_words(part->reason).ends_with(" s on the amplitude only falls, as when a drive stops"))
          << in_words(part->reason);
    }
  // Ten samples in two periods show no amplitude.
  EXPECT_FALSE(after_a_drive(25, 55, 0.03, 5));
}

// Where little is left it may rise by a fortieth of what it was driven to.
TEST(FreePartLimits, WhatADriveLeavesOnlyFalls) {
  const auto rising_to = [](double again) {
    Made made;
    for (int i = 0; i < 1800; ++i) {
      const double t = i / 20.0, A = t < 25 ? 1 : t < 60 ? std::exp(-0.08 * (t - 25)) : again;
      made.t.push_back(t);
      made.y.push_back(A * std::cos(6.283185307179586 * t + 0.4));
    }
    return made.free();
  };
  EXPECT_TRUE(rising_to(0.07));
  EXPECT_TRUE(rising_to(std::exp(-0.08 * 35) + 0.022));
  EXPECT_FALSE(rising_to(std::exp(-0.08 * 35) + 0.03));
}

TEST(FreePartLimits, EightPeriodsBeforeADriveStopsAndAfterwards) {
  EXPECT_TRUE(after_a_drive(9.4, 60, 0.03, 20));
  EXPECT_FALSE(after_a_drive(8.6, 60, 0.03, 20));
  EXPECT_TRUE(after_a_drive(40, 48.6, 0.03, 20));
  EXPECT_FALSE(after_a_drive(40, 47.6, 0.03, 20));
}

TEST(FreePartLimits, AFallOfATwelfth) {
  EXPECT_TRUE(after_a_drive(40, 60, 0.0055, 20));
  EXPECT_FALSE(after_a_drive(40, 60, 0.0035, 20));
}

// A swing that fell before falls on: no drive.
TEST(FreePartLimits, ALevelThatRoseOrHardlyFell) {
  EXPECT_TRUE(after_a_drive(40, 70, 0.03, 20, 0.002));
  EXPECT_TRUE(after_a_drive(40, 70, 0.03, 20, -0.002));
  EXPECT_FALSE(after_a_drive(40, 70, 0.03, 20, -0.007));
  // Nor is it level where a brake comes on late.
  EXPECT_TRUE(after_a_drive(40, 70, 0.08, 20, -0.003));
  EXPECT_FALSE(after_a_drive(40, 70, 0.08, 20, -0.008));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
