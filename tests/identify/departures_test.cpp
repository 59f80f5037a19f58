// What a recording shows beside a free swing, on records made by hand: at, below and above each limit, word
// for word.
#include "cromer/identify/diagnose/doubts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <variant>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/identify/record.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

/// Windows of eight samples and one second, with exactly these amplitudes, and the sample that ends the last.
SyntheticRecord of_amplitudes(const std::vector<double>& amplitudes) {
  SyntheticRecord record{even_times(8 * amplitudes.size() + 1, 0.125), {}, 0};
  for (const double a : amplitudes)
    for (const double y : {a, -a, a, -a, 0.0, 0.0, 0.0, 0.0}) record.y.push_back(y);
  record.y.push_back(0);
  return record;
}

std::string stop_of(const std::vector<double>& amplitudes, bool described = false, double resolution = 0) {
  SyntheticRecord record = of_amplitudes(amplitudes);
  record.resolution = resolution;
  return in_words(sudden_stop(record.record(), 1, "m", described));
}

std::string stops(const char* between, const char* amplitude) {
  return std::string("the swing stops between ") + between + " s, from an amplitude of " + amplitude +
         " to less than a tenth of it, as when a hand catches it: end before with --to";
}

TEST(AmplitudeWindows, StandOneAfterTheOther) {
  const SyntheticRecord record = of_amplitudes({3, 1, 2});
  const std::vector<AmplitudeWindow> windows = amplitude_windows(record.record(), 1, 8);
  ASSERT_EQ(windows.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(windows[i].from, static_cast<double>(i));
    EXPECT_EQ(windows[i].to, static_cast<double>(i + 1));
    EXPECT_EQ(windows[i].amplitude, (std::vector<double>{3, 1, 2})[i]);
  }
  // The last one is not full without its end; nine samples there are in none.
  EXPECT_EQ(amplitude_windows(record.record().first(24), 1, 8).size(), 2u);
  EXPECT_TRUE(amplitude_windows(record.record(), 1, 9).empty());
}

// A window with few samples is left out, and those behind it are not.
TEST(AmplitudeWindows, AGapTakesOneAway) {
  SyntheticRecord record = of_amplitudes({3, 1, 2});
  record.t.erase(record.t.begin() + 9, record.t.begin() + 14);
  record.y.erase(record.y.begin() + 9, record.y.begin() + 14);
  const std::vector<AmplitudeWindow> windows = amplitude_windows(record.record(), 1, 4);
  ASSERT_EQ(windows.size(), 2u);
  EXPECT_EQ(windows[0].amplitude, 3);
  EXPECT_EQ(windows[1].from, 2);
  EXPECT_EQ(windows[1].amplitude, 2);
}

TEST(SuddenStop, InTheFirstWindowsThatCanShowIt) {
  EXPECT_EQ(stop_of({1, 1, 1, 0.5, 0, 0, 0, 0}), stops("2.875 and 4", "1 m"));
  EXPECT_EQ(stop_of({1, 1, 0.5, 0, 0, 0, 0, 0}), "");
  EXPECT_EQ(stop_of({1, 1, 1, 0.5, 0, 0, 0}), "");  // too short to tell
}

TEST(SuddenStop, InTheLastWindow) {
  EXPECT_EQ(stop_of({1, 1, 1, 1, 1, 1, 0.5, 0}), stops("5.875 and 7", "1 m"));
  EXPECT_EQ(stop_of({1, 1, 1, 1, 1, 1, 1, 0.5}), "");
}

TEST(SuddenStop, WithoutAUnitThereIsNone) {
  EXPECT_EQ(in_words(sudden_stop(of_amplitudes({1, 1, 1, 1, 1, 1, 0.5, 0}).record(), 1, "", false)),
            stops("5.875 and 7", "1"));
}

TEST(SuddenStop, IsNoneWhereRoundingHidesTheSwing) {
  EXPECT_EQ(stop_of({1, 1, 1, 1, 1, 1, 0.5, 0}, false, 0.21), "");
  EXPECT_NE(stop_of({1, 1, 1, 1, 1, 1, 0.5, 0}, false, 0.09), "");
}

TEST(SuddenStop, IsNoneWhereTheSwingComesBack) {
  EXPECT_EQ(stop_of({1, 1, 1, 0.5, 0, 0, 0, 0, 0.2}), "");
  EXPECT_EQ(stop_of({1, 1, 1, 0.5, 0, 0.2, 0, 0, 0}), "");
  EXPECT_EQ(stop_of({1, 1, 1, 0.5, 0, 0.09, 0, 0, 0}), stops("2.875 and 4", "1 m"));
}

TEST(SuddenStop, LeavesLessThanATenth) {
  EXPECT_EQ(stop_of({1, 1, 1, 1, 0.5, 0.0999, 0.0999, 0.0999, 0.0999}), stops("3.875 and 5", "1 m"));
  EXPECT_EQ(stop_of({1, 1, 1, 1, 0.5, 0.1, 0.1, 0.1, 0.1}), "");
}

TEST(SuddenStop, BeginsAtAFifthOfTheLargestAmplitude) {
  EXPECT_EQ(stop_of({1, 0.5, 0.3, 0.3, 0.201, 0.1, 0, 0, 0}), stops("3.875 and 6", "0.3 m"));
  EXPECT_EQ(stop_of({1, 0.5, 0.3, 0.3, 0.2, 0.1, 0, 0, 0}), "");
  EXPECT_EQ(stop_of({0.5, 1, 0.3, 0.3, 0.2, 0.1, 0, 0, 0}), "");
  EXPECT_EQ(stop_of({10, 5, 3, 3, 2.01, 1, 0, 0, 0}), stops("3.875 and 6", "3 m"));
  EXPECT_EQ(stop_of({10, 5, 3, 3, 2, 1, 0, 0, 0}), "");
}

// Of two windows before: a swing that decays so fast stops by itself.
TEST(SuddenStop, FollowsASwingThatLasted) {
  EXPECT_EQ(stop_of({1.3, 1.3, 1, 0.8, 0.61, 0.1, 0, 0, 0}), stops("3.875 and 6", "0.8 m"));
  EXPECT_EQ(stop_of({1.3, 1.3, 1, 0.8, 0.6, 0.1, 0, 0, 0}), "");
}

// Friction halves it at least; what leaves more in two windows is no friction, whatever law goes along with
// it.
TEST(SuddenStop, OfASwingNearlyDoneOrDescribedIsNoFriction) {
  EXPECT_EQ(stop_of({1, 0.3, 0.05, 0.05, 0.0351, 0.02, 0, 0, 0}), stops("3.875 and 6", "0.05 m"));
  EXPECT_EQ(stop_of({1, 0.3, 0.05, 0.05, 0.0349, 0.02, 0, 0, 0}), "");
  EXPECT_EQ(stop_of({1, 0.3, 0.03, 0.03, 0.0301, 0.02, 0, 0, 0}), stops("4.875 and 6", "0.0301 m"));
  EXPECT_EQ(stop_of({1, 0.3, 0.03, 0.03, 0.03, 0.02, 0, 0, 0}), "");
  EXPECT_EQ(stop_of({1, 0.3, 0.05, 0.05, 0.045, 0.02, 0, 0, 0}, false, 0.0044),
            stops("3.875 and 6", "0.05 m"));
  EXPECT_EQ(stop_of({1, 0.3, 0.05, 0.05, 0.045, 0.02, 0, 0, 0}, false, 0.0046), "");
  EXPECT_EQ(stop_of({1.3, 1.3, 1, 0.8, 0.71, 0.1, 0, 0, 0}, true), stops("3.875 and 6", "0.8 m"));
  EXPECT_EQ(stop_of({1.3, 1.3, 1, 0.8, 0.69, 0.1, 0, 0, 0}, true), "");
}

// A hand that brakes takes two windows or three. Friction leaves 2/4 of the amplitude in the two windows
// before one, 3/5 before two and 4/6 before three, or a little more where windows begin between its turning
// points.
TEST(SuddenStop, MayTakeThreeWindows) {
  EXPECT_EQ(stop_of({1.3, 1, 1, 0.71, 0.5, 0.2, 0, 0, 0}), stops("2.875 and 6", "1 m"));
  EXPECT_EQ(stop_of({1.3, 1, 1, 0.71, 0.5, 0.2, 0, 0, 0}, true), stops("2.875 and 6", "1 m"));
  EXPECT_EQ(stop_of({1.3, 1, 1, 0.69, 0.5, 0.2, 0, 0, 0}), "");
  EXPECT_EQ(stop_of({1, 1, 1, 0.8, 0.5, 0.2, 0.1, 0, 0}), "");
  EXPECT_EQ(stop_of({1, 1, 1, 0.81, 0.6, 0.4, 0.2, 0, 0, 0}), stops("2.875 and 7", "1 m"));
  EXPECT_EQ(stop_of({1, 1, 1, 0.79, 0.6, 0.4, 0.2, 0, 0, 0}), "");
  EXPECT_EQ(stop_of({1, 0.86, 0.71, 0.57, 0.43, 0.28, 0.14, 0, 0}), "");
}

// The part before the stop holds nothing of what came after, wherever in its cycle the hand catches it.
TEST(SuddenStop, IsPlacedBeforeTheHandCatchesIt) {
  for (const double noise : {0.0, 3e-4})
    for (const bool to_rest : {true, false})
      for (double caught = 10; caught < 11; caught += 0.03) {
        SyntheticRecord record{even_times(2000, 0.01), {}, 0};
        std::mt19937 engine(7);
        std::normal_distribution<double> normal(0, 1);
        const auto swing = [](double t) { return 0.05 * std::exp(-0.05 * t) * std::cos(2 * pi * t / 0.8); };
        for (const double t : record.t)
          record.y.push_back(0.2 + noise * normal(engine) +
                             (t < caught ? swing(t)
                              : to_rest  ? 0
                                         : swing(caught)));
        const Notice stop = sudden_stop(record.record(), 0.8, "m", false);
        ASSERT_EQ(stop.code, "swing_stops") << caught;
        const double from = std::get<double>(stop.values.at(0).value);
        // A swing that is held where it turns looks free a moment longer.
        EXPECT_LE(from, caught + 0.08 * 0.8) << caught << ' ' << to_rest;
        EXPECT_GT(from, caught - 0.25 * 0.8) << caught << ' ' << to_rest;
      }
}

// What is left after the last whole window tells as well.
TEST(SuddenStop, IsSeenInTheLastPeriod) {
  const auto with_rest = [](std::size_t samples) {
    SyntheticRecord record = of_amplitudes({1, 1, 1, 1, 1, 1, 1, 0.5});
    for (std::size_t i = 1; i <= samples; ++i) {
      record.t.push_back(8 + 0.125 * static_cast<double>(i));
      record.y.push_back(0);
    }
    return in_words(sudden_stop(record.record(), 1, "m", false));
  };
  EXPECT_EQ(with_rest(2), "");
  EXPECT_EQ(with_rest(7), stops("6.875 and 7.875", "1 m"));
}

// Four samples in a window are too few to know its amplitude.
TEST(SuddenStop, NeedsSixSamplesInAWindow) {
  const SyntheticRecord record = of_amplitudes({1, 1, 1, 0.5, 0, 0, 0, 0});
  const auto thinned = [&](std::size_t keep) {
    SyntheticRecord some;
    for (std::size_t i = 0; i < record.t.size(); ++i)
      if (i % 8 < keep) some.t.push_back(record.t[i]), some.y.push_back(record.y[i]);
    return in_words(sudden_stop(some.record(), 1, "m", false));
  };
  EXPECT_NE(thinned(6), "");
  EXPECT_EQ(thinned(5), "");
}

/// Residuals at even times of one second.
struct Wandered {
  std::vector<double> t, r;

  std::string told(std::string_view unit = "m") const { return in_words(wandering_zero({t, r}, r, unit)); }
  double share() const { return wandering_share({t, r}, r); }
};

template <class Value>
Wandered wandered(std::size_t n, const Value& value) {
  Wandered record{even_times(n, 1), {}};
  for (std::size_t i = 0; i < n; ++i) record.r.push_back(value(static_cast<double>(i)));
  return record;
}

/// Up and down from sample to sample.
double alternating(double i) { return std::fmod(i, 2) == 0 ? 1 : -1; }

TEST(WanderingZero, ALineIsADrift) {
  const Wandered drift = wandered(32, [](double i) { return 5 - 0.25 * i; });
  EXPECT_NEAR(drift.share(), 1, 1e-12);
  EXPECT_EQ(drift.told(),
            "the zero drifts, by -7.75 m over the record: remove the drift, or choose a shorter part");
  EXPECT_EQ(wandered(31, [](double i) { return 5 - 0.25 * i; }).told(), "");
  // Later, and in steps of another length.
  Wandered later = drift;
  for (double& t : later.t) t = 100 + 3 * t;
  EXPECT_NEAR(later.share(), 1, 1e-12);
  EXPECT_EQ(later.told(""),
            "the zero drifts, by -7.75 over the record: remove the drift, or choose a shorter part");
}

TEST(WanderingZero, AStepIsAJump) {
  const Wandered jump = wandered(40, [](double i) { return i < 10 ? 1.5 : 4; });
  EXPECT_NEAR(jump.share(), 1, 1e-12);
  EXPECT_EQ(jump.told(), "the zero jumps by 2.5 m at 10 s: choose one side of it with --from and --to");
  EXPECT_EQ(wandered(40, [](double i) { return i < 39 ? 4 : 1.5; }).told(),
            "the zero jumps by -2.5 m at 39 s: choose one side of it with --from and --to");
  EXPECT_EQ(wandered(40, [](double i) { return i < 1 ? 4 : 1.5; }).told(),
            "the zero jumps by -2.5 m at 1 s: choose one side of it with --from and --to");
}

// One step of a size of 2 beside what alternates by b takes 1/(1 + b²) of the variance away.
TEST(WanderingZero, IsSaidFromThreeTenthsOn) {
  const auto beside = [](double b) {
    return wandered(32, [=](double i) { return (i < 16 ? -1 : 1) + b * alternating(i); });
  };
  EXPECT_NEAR(beside(1.5).share(), 1 / 3.25, 1e-12);
  EXPECT_EQ(beside(1.5).told(), "the zero jumps by 2 m at 16 s: choose one side of it with --from and --to");
  EXPECT_NEAR(beside(1.55).share(), 1 / 3.4025, 1e-12);
  EXPECT_EQ(beside(1.55).told(), "");
}

TEST(WanderingZero, ALineBesideWhatAlternates) {
  // Of 33 samples about the middle: i² adds up to 2992, and what alternates by b to 33 b².
  const auto beside = [](double b) {
    return wandered(33, [=](double i) { return 0.1 * (i - 16) + b * alternating(i); });
  };
  for (const double b : {0.5, 1.0, 1.4}) {
    const double line = 29.92, mean = b / 33, rest = 33 * (b * b - mean * mean);
    EXPECT_NEAR(beside(b).share(), line / (line + rest), 1e-12) << b;
  }
  EXPECT_EQ(beside(1.4).told(),
            "the zero drifts, by 3.2 m over the record: remove the drift, or choose a shorter part");
  EXPECT_EQ(beside(1.5).told(), "");
}

TEST(WanderingZero, NoneInResidualsThatAreAllTheSame) {
  const Wandered same = wandered(32, [](double) { return 0.5; });
  EXPECT_EQ(same.share(), 0);
  EXPECT_EQ(same.told(), "");
  EXPECT_EQ(wandered(1, [](double) { return 0.5; }).share(), 0);
  EXPECT_NEAR(wandered(2, [](double i) { return i; }).share(), 1, 1e-12);
}

std::string few_of(const std::vector<double>& t, double frequency) {
  return in_words(few_samples({t, t}, 2 * pi * frequency));
}

TEST(FewSamples, FewerThanFourInAPeriod) {
  const std::vector<double> t = even_times(11, 0.5);
  EXPECT_EQ(few_of(t, 0.5), "");
  EXPECT_EQ(few_of(t, 0.625),
            "only 3.2 samples in a period: sampled at 2 Hz, a swing of 1.375 or 2.625 Hz would look the same "
            "as this one of 0.625 Hz; sample faster if it may be one of them");
}

TEST(FewSamples, NothingOfUnevenOnes) {
  // What is off by a hundredth of a step may be the clock.
  for (const std::size_t moved : {1u, 4u, 9u}) {
    std::vector<double> t = even_times(11, 0.5);
    t[moved] += 0.0049;
    EXPECT_NE(few_of(t, 0.625), "") << moved;
    t[moved] += 0.0002;
    EXPECT_EQ(few_of(t, 0.625), "") << moved;
  }
}

std::string turns_of(const std::vector<double>& y, int derivative = 0) {
  return in_words(turning_over({even_times(y.size(), 0.5), y, 0, derivative}));
}

TEST(TurningOver, MoreThanOneTurn) {
  EXPECT_EQ(turns_of({0, 2 * pi}), "");
  EXPECT_EQ(turns_of({0, 7, 13, 12.5, 12.6}),
            "the angle goes through 2.1 turns: the pendulum turns over, which is no swing; from 1 s on it "
            "only swings: choose that part with --from");
  EXPECT_EQ(turns_of({0, -7, -13, -12.5, -12.6}),
            "the angle goes through 2.1 turns: the pendulum turns over, which is no swing; from 1 s on it "
            "only swings: choose that part with --from");
  // It ends upside down.
  EXPECT_EQ(turns_of({-4, pi}),
            "the angle goes through 1.1 turns: the pendulum turns over, which is no swing");
  EXPECT_EQ(turns_of({7}), "");
  EXPECT_EQ(turns_of({}), "");
}

TEST(TurningOver, OfAnAngleAlone) {
  EXPECT_NE(turns_of({0, 7}), "");
  EXPECT_EQ(turns_of({0, 7}, 1), "");
  EXPECT_EQ(turns_of({0, 7}, 2), "");
}

/// Residuals at even times: noise, and a line of amplitude a at w.
bool has_line(std::size_t n, double a, double w, double times = 30, double decay_rate = 0.01) {
  std::vector<double> r(n);
  const std::vector<double> t = even_times(n, 0.1);
  for (std::size_t i = 0; i < n; ++i) r[i] = a * std::cos(w * t[i] + 0.3);
  r = noisy(r, 1);
  return leaves_a_line(t, r, decay_rate, 6, times);
}

TEST(LeavesALine, AboutTheFrequencyAndNowhereElse) {
  EXPECT_FALSE(has_line(1000, 0, 6));
  for (const double w : {5.82, 6.0, 6.18}) EXPECT_TRUE(has_line(1000, 1, w)) << w;
  for (const double w : {4.5, 5.5, 6.5, 7.5}) EXPECT_FALSE(has_line(1000, 1, w)) << w;
  // What decays is broader.
  for (const double w : {5.0, 7.0}) EXPECT_TRUE(has_line(1000, 1, w, 30, 0.35)) << w;
  EXPECT_FALSE(has_line(1000, 1, 7.3, 30, 0.35));
}

/// How many times the line's power is the median's on either side: where the answer changes.
double stands_out(std::size_t n, double w, double decay_rate) {
  const std::vector<double> t = even_times(n, 0.1);
  std::vector<double> r(n);
  for (std::size_t i = 0; i < n; ++i)
    r[i] = std::cos(0.7 * static_cast<double>(i * i)) + 0.3 * std::cos(6 * t[i]);
  double low = 0, high = 1000;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (leaves_a_line(t, r, decay_rate, w, middle) ? low : high) = middle;
  }
  return low;
}

// The largest power within three resolutions, or three decay rates, over the median of 24 places on either
// side: worked out apart from the program, by least squares at each of these frequencies.
TEST(LeavesALine, BySoManyTimes) {
  EXPECT_NEAR(stands_out(400, 6, 0.01), 12.59349132, 1e-6);
  EXPECT_NEAR(stands_out(400, 6, 0.2), 11.01152466, 1e-6);
  EXPECT_NEAR(stands_out(401, 1.3, 0.01), 4.77387907, 1e-6);
  EXPECT_NEAR(stands_out(150, 9, 0.3), 3.85483734, 1e-6);
}

TEST(LeavesALine, InTooFewSamplesIsNotDenied) {
  EXPECT_TRUE(has_line(31, 0, 6, 1000));
  EXPECT_FALSE(has_line(32, 0, 6, 1000));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
