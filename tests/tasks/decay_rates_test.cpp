// The decay rate part by part, of handmade records.
#include "cromer/tasks/fit/decay_rates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "cromer/base/state.h"
#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "cromer/model/sensor.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

/// A swing of 1 Hz that loses `rate` a second in its first 6 s and twice that in the next, 40 samples a
/// second from 10 s on.
struct Swing {
  std::vector<double> t, y;

  explicit Swing(double duration = 12, double rate = 0.1) {
    NormalDeviates noise(3);
    for (int i = 0; i <= static_cast<int>(40 * duration + 0.5); ++i) {
      const double s = i / 40.0, decay = s < 6 ? rate * s : rate * 6 + 2 * rate * (s - 6);
      t.push_back(10 + s);
      y.push_back(std::exp(-decay) * std::cos(2 * M_PI * s) + 1e-3 * noise.next());
    }
  }
  Record record() const { return {t, y, 0}; }
};

TEST(DecaySegments, AreOfALengthOrSoMany) {
  const Swing swing;
  const auto segments = [&](std::optional<double> length, std::optional<int> count) {
    return fit_segments(swing.record(), 1, length, count);
  };
  EXPECT_THAT(segments({}, {}).segments, IsEmpty());
  EXPECT_FALSE(segments({}, {}).mean);
  for (const DecaySegments& two : {segments(6, {}), segments({}, 2), segments(6, 2)}) {
    ASSERT_EQ(two.segments.size(), 2u);
    EXPECT_THAT(in_words(two.notices), IsEmpty());
    EXPECT_EQ(two.segments[0].from, 10);
    EXPECT_EQ(two.segments[0].to, 16);
    EXPECT_EQ(two.segments[1].from, 16);
    EXPECT_EQ(two.segments[1].to, 22);
    EXPECT_NEAR(two.segments[0].rate.value, 0.1, 2e-3);
    EXPECT_NEAR(two.segments[1].rate.value, 0.2, 4e-3);
    EXPECT_NEAR(two.mean->value, (two.segments[0].rate.value + two.segments[1].rate.value) / 2, 1e-12);
    EXPECT_NEAR(two.mean->standard_error,
                std::hypot(two.segments[0].rate.standard_error, two.segments[1].rate.standard_error) / 2,
                1e-12);
    EXPECT_GT(two.mean->high, two.mean->value + 1.9 * two.mean->standard_error);
  }
  const DecaySegments one = segments(6, 1);
  ASSERT_EQ(one.segments.size(), 1u);
  EXPECT_EQ(one.segments[0].to, 16);
  EXPECT_THAT(in_words(one.notices), IsEmpty());
  EXPECT_THAT(in_words(segments(6, 3).notices),
              ElementsAre("the record of 12 s holds 2 of the 3 segments of 6 s"));
  EXPECT_EQ(segments(6, 3).segments.size(), 2u);
  EXPECT_THAT(in_words(segments(13, {}).notices),
              ElementsAre("the record of 12 s is shorter than one segment of 13 s"));
  EXPECT_THAT(segments(13, {}).segments, IsEmpty());
  // The last sample stands for one step more.
  EXPECT_EQ(segments(12.025, {}).segments.size(), 1u);
}

TEST(DecaySegments, HoldAPeriodAndAHalfAndEightSamples) {
  const Swing swing;
  EXPECT_EQ(fit_segments(swing.record(), 1, 1.55, {}).segments.size(), 7u);
  EXPECT_THAT(in_words(fit_segments(swing.record(), 1, 1.5, {}).notices),
              testing::Each(testing::Not(testing::StartsWith("no decay rates"))));
  EXPECT_THAT(
      in_words(fit_segments(swing.record(), 1, 1.49, {}).notices),
      ElementsAre(
          "no decay rates by segment: those of --segment 1.49 would be 1.49 s long, but a segment must "
          "hold 1.5 periods and 8 samples, here 1.5 s"));
  EXPECT_THAT(
      in_words(fit_segments(swing.record(), 1, {}, 9).notices),
      ElementsAre("no decay rates by segment: those of --segments 9 would be 1.33 s long, but a segment must "
                  "hold 1.5 periods and 8 samples, here 1.5 s"));
  EXPECT_THAT(
      in_words(fit_segments(swing.record(), 0.1, 0.19, {}).notices),
      ElementsAre(
          "no decay rates by segment: those of --segment 0.19 would be 0.19 s long, but a segment must "
          "hold 1.5 periods and 8 samples, here 0.2 s"));
}

TEST(DecayByAmplitude, NeedsTwentyFourSamples) {
  NormalDeviates noise(3);
  std::vector<double> t, y;
  for (int i = 0; i < 24; ++i) {
    t.push_back(0.1 * i);
    y.push_back(std::exp(-0.3 * t.back()) * std::cos(4 * M_PI * t.back()) + 1e-4 * noise.next());
  }
  const Record all{t, y, 0}, fewer = all.first(23);
  const LawFit fit = fit_law(all, {.law = law_of("viscous")});
  ASSERT_EQ(fit.status, FitStatus::converged);
  EXPECT_THAT(decay_by_amplitude(all, fit), testing::Not(IsEmpty()));
  EXPECT_THAT(decay_by_amplitude(fewer, fit), IsEmpty());
}

// A sinusoid that is fitted to noise has about the amplitude that noise shows.
TEST(DecaySegments, ASwingThatIsOverHasNoRate) {
  Swing swing;
  NormalDeviates noise(5);
  for (std::size_t i = 0; i < swing.t.size(); ++i)
    if (swing.t[i] > 13) swing.y[i] = 1e-3 * noise.next();
  const DecaySegments one = fit_segments(swing.record(), 1, 3, {});
  EXPECT_EQ(one.segments.size(), 1u);
}

TEST(DecaySegments, WhatFailsIsLeftOutAndSaidOnce) {
  Swing swing;
  for (std::size_t i = 0; i < swing.t.size(); ++i)
    if (swing.t[i] > 13 && swing.t[i] < 16) swing.y[i] = 0.25;
  const DecaySegments one = fit_segments(swing.record(), 1, 3, {});
  EXPECT_EQ(one.segments.size(), 3u);
  ASSERT_EQ(in_words(one.notices).size(), 1u);
  EXPECT_THAT(in_words(one.notices)[0], testing::StartsWith("the segment from 13 to 16 s is left out: "));
  for (std::size_t i = 0; i < swing.t.size(); ++i)
    if (swing.t[i] > 13) swing.y[i] = 0.25;
  const DecaySegments three = fit_segments(swing.record(), 1, 3, {});
  EXPECT_EQ(three.segments.size(), 1u);
  ASSERT_EQ(in_words(three.notices).size(), 1u);
  EXPECT_THAT(in_words(three.notices)[0],
              testing::StartsWith("3 of the 4 segments are left out; the first, from 13 to 16 s: "));
  const std::atomic<bool> stop{true};
  EXPECT_THAT(in_words(fit_segments(swing.record(), 1, 3, {}, {&stop, {}}).notices),
              ElementsAre("interrupted after 0 of the 4 segments"));
}

// One rate of a swing that falls to a quarter meanwhile would be that of its beginning.
TEST(DecayByAmplitude, NoStretchIsMuchLongerThanTheSwingTakesToHalve) {
  NormalDeviates noise(2);
  std::vector<double> t, y;
  for (int i = 0; i < 3000; ++i) {
    t.push_back(0.02 * i);
    y.push_back(std::exp(-0.15 * t.back()) * std::cos(6 * t.back()) + 1e-3 * noise.next());
  }
  const Record record{t, y, 0};
  const auto stretches = decay_by_amplitude(record, fit_law(record, {}));
  ASSERT_GT(stretches.size(), 4u);
  for (const AmplitudeRate& each : stretches) EXPECT_LT((each.to - each.from) * 0.15, 1.6 * std::log(2));
}

/// The states of x'' = -pull(x) - 2 g x' from rest at x, fifty a second.
template <class Pull>
std::vector<State<double>> damped_swing(const Pull& pull, double g, double x, int samples) {
  constexpr double h = 1e-3;
  std::vector<State<double>> states;
  double v = 0;
  for (int i = 0; i < 20 * samples; ++i) {
    if (i % 20 == 0) states.push_back({x, v});
    v -= 0.5 * h * (pull(x) + 2 * g * v);
    x += h * v;
    v = (v - 0.5 * h * pull(x)) / (1 + g * h);
  }
  return states;
}

// A pendulum's: w = w0/(1 + A^2/16 + 11 A^4/3072 + 173 A^6/737280 + 22931 A^8/1321205760 + ...). Within the
// first stretches it changes by percents.
TEST(DecayByAmplitude, TellsTheFrequencyToo) {
  double squares = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    NormalDeviates noise(seed);
    constexpr double w0 = 6;
    std::vector<double> t, y;
    for (const State<double>& at :
         damped_swing([](double x) { return w0 * w0 * std::sin(x); }, 0.03, 1.5, 2000)) {
      t.push_back(0.02 * static_cast<double>(t.size()));
      y.push_back(at.x + 3e-3 * noise.next());
    }
    const Record record{t, y, 0};
    LawFitOptions options;
    options.law = law_of("viscous+pendulum");
    const auto stretches = decay_by_amplitude(record, fit_law(record, options));
    ASSERT_GT(stretches.size(), 4u);
    EXPECT_GT(stretches.back().angular_frequency.value, 1.08 * stretches.front().angular_frequency.value);
    for (const AmplitudeRate& each : stretches) {
      const double A2 = each.amplitude * each.amplitude;
      const double w =
          w0 / (1 + A2 * (1.0 / 16 + A2 * (11.0 / 3072 + A2 * (173.0 / 737280 + A2 * 22931 / 1321205760))));
      EXPECT_NEAR(each.law_angular_frequency / w, 1, 3e-4);
      EXPECT_NEAR(each.angular_frequency.value / w, 1, 1e-3);
      squares += std::pow((each.angular_frequency.value - w) / each.angular_frequency.standard_error, 2);
      ++count;
    }
  }
  EXPECT_LT(std::sqrt(squares / count), 1.4);
  EXPECT_GT(std::sqrt(squares / count), 0.6);
}

// A velocity falls faster than the displacement where the frequency falls with the amplitude.
TEST(DecayByAmplitude, OfAVelocityIsThatOfTheDisplacement) {
  double squares = 0, count = 0;
  for (const double bend : {3600.0, -1800.0})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      NormalDeviates noise(seed);
      const auto pull = [&](double x) { return 36 * x + bend * x * x * x; };
      std::vector<double> t, y;
      for (const State<double>& at : damped_swing(pull, 0.03, 0.1, 3000)) {
        t.push_back(0.02 * static_cast<double>(t.size()));
        y.push_back(at.v + 2e-3 * noise.next());
      }
      const Record record{t, y, 0, 1};
      LawFitOptions options;
      options.law = law_of("viscous+cubic");
      const auto stretches = decay_by_amplitude(record, fit_law(record, options));
      ASSERT_GT(stretches.size(), 4u);
      for (const AmplitudeRate& each : stretches) {
        squares += std::pow((each.rate.value - each.law_rate) / each.rate.standard_error, 2);
        ++count;
      }
    }
  EXPECT_LT(std::sqrt(squares / count), 1.4);
}

// What swings along moves the rate of a stretch that holds less than a few beats by far more than its error,
// and that of others by as much as is in their errors.
TEST(DecayByAmplitude, AStretchHoldsSomeBeats) {
  double squares = 0, count = 0;
  for (const double faster : {0.5, 1.0, 2.0}) {
    NormalDeviates noise(4);
    std::vector<double> t, y;
    for (int i = 0; i < 4500; ++i) {
      t.push_back(0.02 * i);
      y.push_back(std::exp(-0.03 * t.back()) *
                      (std::cos(6 * t.back()) + 0.01 * std::cos((6 + faster) * t.back())) +
                  3e-4 * noise.next());
    }
    const Record record{t, y, 0};
    const LawFit fit = fit_law(record, {});
    const std::vector<ResidualLine> lines{
        {.angular_frequency = 6 + faster, .amplitude = 0.01, .decay_rate = 0.03}};
    const double beat = 2 * M_PI / faster;
    const auto farthest = [&](const std::vector<AmplitudeRate>& stretches) {
      double most = 0;
      for (const AmplitudeRate& each : stretches) most = std::max(most, std::abs(each.rate.value / 0.03 - 1));
      return most;
    };
    const auto short_ones = decay_by_amplitude(record, fit),
               long_ones = decay_by_amplitude(record, fit, lines);
    ASSERT_GT(long_ones.size(), 3u);
    for (const AmplitudeRate& each : long_ones) {
      EXPECT_GT(each.to - each.from, 0.99 * std::min(3 * beat, 15.0));
      squares += std::pow((each.rate.value - 0.03) / each.rate.standard_error, 2);
      ++count;
    }
    EXPECT_LT(farthest(long_ones), 0.5 * farthest(short_ones)) << faster;
  }
  EXPECT_LT(std::sqrt(squares / count), 1.3);
  EXPECT_GT(std::sqrt(squares / count), 0.3);
}

// Noise that is slower than a stretch moves its rate, and does not show within it.
TEST(DecayByAmplitude, NeighboursShowHowWellARateIsKnown) {
  double squares = 0, by_themselves = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    NormalDeviates noise(seed);
    std::vector<double> t, y;
    double slow = 0;  // how strong what swings along is: it changes within some ten seconds
    for (int i = 0; i < 3000; ++i) {
      t.push_back(0.02 * i);
      slow = 0.998 * slow + 0.01 * noise.next();
      y.push_back((0.3 * std::exp(-0.03 * t.back()) + 0.03 * slow) * std::cos(6 * t.back()) +
                  1e-3 * noise.next());
    }
    const Record record{t, y, 0};
    for (const AmplitudeRate& each : decay_by_amplitude(record, fit_law(record, {}))) {
      const double off = (each.rate.value - 0.03) / each.rate.standard_error;
      squares += off * off;
      by_themselves += std::pow(off * each.widened, 2);
      count += 1;
    }
  }
  // Without the largest difference they are not widened by all that they need.
  EXPECT_GT(std::sqrt(by_themselves / count), 2.5);
  EXPECT_LT(std::sqrt(squares / count), 1.5);
  EXPECT_GT(std::sqrt(squares / count), 0.7);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
