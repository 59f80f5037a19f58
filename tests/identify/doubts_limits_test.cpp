// What speaks against a fit, on records and fits made by hand: at each limit, word for word.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/identify/diagnose/doubts.h"
#include "cromer/identify/diagnose/mean_decay.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// One period a second, 64 samples each, and the sample after the last; its amplitude is that of each four
/// periods.
SyntheticRecord swing(const std::vector<double>& amplitudes) {
  SyntheticRecord record{even_times(256 * amplitudes.size() + 1, 1.0 / 64), {}, 0};
  for (std::size_t i = 0; i < record.t.size(); ++i)
    record.y.push_back(amplitudes[std::min(i / 256, amplitudes.size() - 1)] *
                       std::cos(2 * pi * record.t[i] + 0.1));
  return record;
}

/// A fit that converged, of a swing with one period a second. Its motion is rest: all is left.
LawFit fit_with(double decay_rate, double error = 1e-6) {
  LawFit fit;
  fit.names = {"angular_frequency", "decay_rate"};
  fit.estimates = {{2 * pi, 1e-4, 2 * pi, 2 * pi},
                   {decay_rate, error, decay_rate - 2 * error, decay_rate + 2 * error}};
  fit.covariance = {1e-8, 0, 0, error * error};
  fit.student = 2;
  fit.step = 0.01;
  fit.motion.set_angular_frequency(2 * pi);
  fit.motion.set_decay_rate(std::max(decay_rate, 0.0));
  return fit;
}

std::vector<std::string> said_of(const SyntheticRecord& record, const LawFit& fit, const char* unit = "m") {
  return in_words(doubts(record.record(), fit, false, unit));
}

/// Of ever so fast a decay: not steady.
std::vector<std::string> said_of(const std::vector<double>& amplitudes, double resolution = 0) {
  SyntheticRecord record = swing(amplitudes);
  record.resolution = resolution;
  return said_of(record, fit_with(1));
}

std::string rises(const char* much, const char* between) {
  return std::string("the amplitude rises ") + much + " between " + between +
         " s: something drives or pushes it, two motions beat, or negative damping feeds it, as in "
         "viscous+van-der-pol. The frequency may then be the drive's, and the stiffness not the spring's";
}

TEST(DoubtsLimits, ARiseOfATenthOfTheLargest) {
  EXPECT_THAT(said_of({1, 0.5, 0.599}), IsEmpty());
  EXPECT_THAT(said_of({1, 0.5, 0.601}), ElementsAre(rises("by 20 %", "6 and 10")));
  EXPECT_THAT(said_of({0.5, 1}), IsEmpty());  // two windows
  EXPECT_THAT(said_of({0.5, 0.99, 0.99}), ElementsAre(rises("by 98 %", "2 and 6")));
  EXPECT_THAT(said_of({0.5, 1.01, 0.99}), ElementsAre(rises("2-fold", "2 and 6")));
  EXPECT_THAT(said_of({0.2, 0.1, 0.31}), ElementsAre(rises("3.1-fold", "6 and 10")));
}

TEST(DoubtsLimits, TheLargestRiseIsFromTheLowestBefore) {
  EXPECT_THAT(said_of({1, 0.3, 0.8, 0.2, 0.6}), ElementsAre(rises("2.7-fold", "6 and 10")));
  EXPECT_THAT(said_of({1, 0.3, 0.6, 0.2, 0.7}), ElementsAre(rises("3.5-fold", "14 and 18")));
  EXPECT_THAT(said_of({1, 0.5, 0.6, 0.52, 0.7}), ElementsAre(rises("by 40 %", "6 and 18")));
}

TEST(DoubtsLimits, ARiseOfTwoRoundingSteps) {
  EXPECT_THAT(said_of({1, 0.5, 0.7}, 0.099), ElementsAre(rises("by 40 %", "6 and 10")));
  EXPECT_THAT(said_of({1, 0.5, 0.7}, 0.101), IsEmpty());
}

// A second difference of independent samples of deviation s has the mean square 6 s²; up and down by a, it is
// 4 a: s = 4 a / sqrt(6) = 1.633 a.
TEST(DoubtsLimits, ARiseOfThreeTimesTheNoise) {
  const auto with_noise = [](double a) {
    SyntheticRecord record = swing({1, 0.5, 0.7});
    for (std::size_t i = 0; i < record.y.size(); ++i) record.y[i] += i % 2 == 0 ? a : -a;
    return said_of(record, fit_with(1));
  };
  EXPECT_THAT(with_noise(0.2 / 4.9 - 0.002), ElementsAre(HasSubstr("rises")));
  EXPECT_THAT(with_noise(0.2 / 4.9 + 0.002), IsEmpty());
}

const std::string then =
    "the frequency is the drive's, and the stiffness that follows from it is not the spring's";

std::vector<double> steady(std::size_t fours) { return std::vector<double>(fours, 1.0); }

TEST(DoubtsLimits, TwentyPeriodsOfASteadySwing) {
  const std::string lasts = "the swing does not die down over 20 periods. If something drives it, " + then;
  EXPECT_THAT(said_of(swing(steady(5)), fit_with(0)), ElementsAre(lasts));
  EXPECT_THAT(said_of(swing(steady(4)), fit_with(0)), IsEmpty());
  SyntheticRecord later = swing(steady(5));
  for (double& t : later.t) t += 64;
  EXPECT_THAT(said_of(later, fit_with(0)), ElementsAre(lasts));
  // Surely more than none: its interval lies above.
  EXPECT_THAT(said_of(swing(steady(5)), fit_with(2e-6, 1e-6)), ElementsAre(lasts));
  EXPECT_THAT(said_of(swing(steady(5)), fit_with(0.9e-6, 1e-6)), ElementsAre(lasts));
  // A law that does not fit sees no decay.
  EXPECT_THAT(said_of(swing({1, 1, 1, 1, 0.68}), fit_with(0)), ElementsAre(lasts));
  EXPECT_THAT(said_of(swing({1, 1, 1, 1, 0.66}), fit_with(0)), IsEmpty());
}

TEST(DoubtsLimits, AnAmplitudeThatHardlyFalls) {
  // Over 20 s, by two hundredths at most.
  const auto falls_by = [](double share, std::size_t fours) {
    return said_of(swing(steady(fours)), fit_with(-std::log(1 - share) / (4.0 * static_cast<double>(fours))));
  };
  EXPECT_THAT(falls_by(0.0195, 5),
              ElementsAre("the amplitude falls by only 1.9 % over 20 periods (quality factor 3200): a "
                          "drive that is not quite steady looks the same. If something drives it, " +
                          then));
  EXPECT_THAT(falls_by(0.0205, 5), IsEmpty());
  // Of a quality factor of 5000 a tenth: pi / 5000 a period.
  const double duration = 80;
  EXPECT_THAT(
      said_of(swing(steady(20)), fit_with(pi / 5001)),
      ElementsAre(HasSubstr(fmt::format("falls by only {:.2g} % over 80 periods (quality factor 5000)",
                                        100 * (1 - std::exp(-duration * pi / 5001))))));
  EXPECT_THAT(said_of(swing(steady(20)), fit_with(pi / 4999)), IsEmpty());
  EXPECT_THAT(falls_by(0.0995, 50), ElementsAre(HasSubstr("falls by only 10 % over 200 periods")));
  EXPECT_THAT(falls_by(0.1005, 50), IsEmpty());
}

TEST(DoubtsLimits, ASwingThatKeepsItself) {
  LawFit fed = fit_with(-0.1);
  fed.law = fed.motion.law = law_of("viscous+van-der-pol");
  EXPECT_THAT(
      said_of(swing(steady(5)), fed),
      ElementsAre("the swing sustains itself over 20 periods: negative damping feeds it as much as the "
                  "rest takes. A steady drive looks much the same: then " +
                  then));
  EXPECT_THAT(said_of(swing({1, 1, 0.92, 1, 1}), fed), ElementsAre(HasSubstr("sustains itself")));
  EXPECT_THAT(said_of(swing({1, 1, 0.9, 1, 1}), fed), IsEmpty());
  // What is fed may rise.
  EXPECT_THAT(said_of(swing({0.5, 1, 1, 1, 1}), fed), IsEmpty());
}

TEST(DoubtsLimits, ASwingThatGrows) {
  EXPECT_THAT(
      said_of(swing({0.905, 1, 1}), fit_with(-0.1)),
      ElementsAre(testing::AllOf(HasSubstr("the swing grows by itself, at 0.100000"), HasSubstr(then))));
  EXPECT_THAT(said_of(swing({0.915, 1, 1}), fit_with(-0.1)), IsEmpty());
  // By less than a tenth over so many periods it is steady.
  EXPECT_THAT(said_of(swing({0.915, 1, 1, 1, 1}), fit_with(-0.1)),
              ElementsAre("the swing does not die down over 20 periods. If something drives it, " + then));
}

// Sixteen samples in four periods show an amplitude.
TEST(DoubtsLimits, ASwingOfFewSamplesIsNotCalledSteady) {
  const auto steady_of = [](double samples_per_period) {
    SyntheticRecord record;
    for (double i = 0; i < 40 * samples_per_period; ++i) {
      record.t.push_back(i / samples_per_period);
      record.y.push_back(std::cos(2 * pi * record.t.back()));
    }
    return said_of(record, fit_with(0));
  };
  EXPECT_THAT(steady_of(4.3), ElementsAre(HasSubstr("the swing does not die down over 40 periods")));
  EXPECT_THAT(steady_of(3.7), ElementsAre(HasSubstr("samples in a period")));
}

TEST(DoubtsLimits, FourLevels) {
  const auto levels = [](double count, double rms, const char* unit = "m") {
    SyntheticRecord record = swing({1});
    record.resolution = 0.25;
    for (double& y : record.y) y = 0.25 * std::round(0.5 * (count - 1) * (y + 1));
    LawFit fit = fit_with(1);
    fit.residual.rms = rms * record.resolution;
    return said_of(record, fit, unit);
  };
  const std::string end =
      ": the frequency follows from when they change, but amplitude and decay rate hardly show, and their "
      "uncertainties cannot be trusted; measure with a finer resolution";
  EXPECT_THAT(levels(4, 0.3), ElementsAre("the values take only 4 levels, 0.25 m apart" + end));
  EXPECT_THAT(levels(3, 0.3, ""), ElementsAre("the values take only 3 levels, 0.25 apart" + end));
  EXPECT_THAT(levels(5, 0.3), IsEmpty());
  EXPECT_THAT(levels(4, 0.359), testing::SizeIs(1));
  EXPECT_THAT(levels(4, 0.361), IsEmpty());
}

/// What is left is the whole record, smooth, of rms 1.
LawFit fit_that_leaves_much(double explained = 0.99) {
  LawFit fit = fit_with(1);
  fit.residual.rms = 1;
  fit.residual.autocorrelation = 0.9;
  fit.explained = explained;
  return fit;
}

std::string no_law(double times) {
  return fmt::format(
      "no law tried describes this recording: the residual is {:.0f} times the noise from sample to sample, "
      "and the uncertainties cannot be trusted",
      times);
}

// A second difference of a cosine is 2 - 2 cos(w h) of it: over the root of six, of rms 1 / sqrt(2).
TEST(DoubtsLimits, ALineThatIsLeft) {
  const double noise = (2 - 2 * std::cos(pi / 32)) / std::sqrt(12.0);
  const std::vector<double> fall{1, 0.9, 0.8, 0.7, 0.6};
  EXPECT_THAT(said_of(swing(fall), fit_that_leaves_much()).size(), 1u);
  const auto left = said_of(swing(steady(4)), fit_that_leaves_much());
  EXPECT_THAT(left, ElementsAre(no_law(1 / noise)));
  EXPECT_THAT(in_words(doubts(swing(steady(4)).record(), fit_that_leaves_much(), true, "m")),
              ElementsAre(HasSubstr("the law viscous does not describe this recording: the residual is ")));
  LawFit fit = fit_that_leaves_much();
  fit.residual.autocorrelation = 0.5;
  EXPECT_THAT(said_of(swing(steady(4)), fit), IsEmpty());
  fit.residual.autocorrelation = 0.51;
  EXPECT_THAT(said_of(swing(steady(4)), fit), testing::SizeIs(1));
  fit.residual.rms = 1.99 * noise;
  EXPECT_THAT(said_of(swing(steady(4)), fit), IsEmpty());
  fit.residual.rms = 2.01 * noise;
  EXPECT_THAT(said_of(swing(steady(4)), fit), ElementsAre(no_law(2)));
  // Above the rounding.
  SyntheticRecord coarse = swing(steady(4));
  coarse.resolution = 0.99;
  fit.residual.rms = 1;
  EXPECT_THAT(said_of(coarse, fit), testing::SizeIs(1));
  coarse.resolution = 1.01;
  EXPECT_THAT(said_of(coarse, fit), IsEmpty());
}

TEST(DoubtsLimits, TwelveSamplesAPeriodShowWhatIsSmooth) {
  const auto thinned = [](std::size_t stride) {
    const SyntheticRecord all = swing(steady(8));
    SyntheticRecord some;
    for (std::size_t i = 0; i < all.t.size(); i += stride) {
      some.t.push_back(all.t[i]);
      some.y.push_back(all.y[i]);
    }
    return said_of(some, fit_that_leaves_much());
  };
  EXPECT_THAT(thinned(5), testing::SizeIs(1));  // 12.8 samples
  EXPECT_THAT(thinned(6), IsEmpty());           // 10.7
}

// No line at the swing's frequency: what the residuals do is named, and where it has no name the law is in
// doubt if it accounts for too little.
TEST(DoubtsLimits, WhatIsLeftHasAName) {
  SyntheticRecord drift = swing(steady(4)), other = drift;
  for (std::size_t i = 0; i < drift.t.size(); ++i) {
    drift.y[i] = 0.5 * drift.t[i];
    other.y[i] = std::cos(0.7 * static_cast<double>(i * i));
  }
  for (const double explained : {0.5, 0.99})
    EXPECT_THAT(said_of(drift, fit_that_leaves_much(explained)),
                testing::Contains(HasSubstr("the zero drifts, by 8 m over the record")))
        << explained;
  const auto said_of_other = [&](double explained, double times) {
    LawFit fit = fit_that_leaves_much(explained);
    fit.residual.rms = times * noise_of(residuals_of(fit, other.record()));
    return said_of(other, fit);
  };
  EXPECT_THAT(said_of_other(0.951, 5.9), IsEmpty());
  EXPECT_THAT(said_of_other(0.949, 5.9), ElementsAre(HasSubstr("no law tried describes")));
  EXPECT_THAT(said_of_other(0.9989, 6.1), ElementsAre(HasSubstr("no law tried describes")));
  EXPECT_THAT(said_of_other(0.9991, 6.1), IsEmpty());
}

bool more_is_tried(const std::vector<double>& y, const LawFit& fit, double resolution = 0) {
  return something_is_left({even_times(y.size(), 1.0 / 64), y, resolution}, fit);
}

/// Up and down from sample to sample, by so much in each quarter.
std::vector<double> quarters(std::size_t n, double first, double last) {
  std::vector<double> y;
  for (std::size_t i = 0; i < n; ++i)
    y.push_back((i < n / 4 ? first : i < n - n / 4 ? 1 : last) * (i % 2 == 0 ? 1 : -1));
  return y;
}

TEST(SomethingIsLeft, WhatShrinksWithTheMotion) {
  LawFit fit = fit_with(1);
  fit.residual.rms = 1;
  const auto shrinks = [&](double first, double autocorrelation, std::size_t n = 400) {
    fit.residual.autocorrelation = autocorrelation;
    return more_is_tried(quarters(n, first, 1), fit);
  };
  EXPECT_TRUE(shrinks(1.45, 0.4));  // more than twice the squares
  EXPECT_FALSE(shrinks(1.38, 0.4));
  EXPECT_TRUE(shrinks(2.05, 0.5));  // four times
  EXPECT_FALSE(shrinks(1.95, 0.5));
  EXPECT_TRUE(shrinks(3, 0.21));
  EXPECT_FALSE(shrinks(3, 0.2));
  EXPECT_TRUE(shrinks(3, 0.4, 64));
  EXPECT_FALSE(shrinks(3, 0.4, 63));
}

TEST(SomethingIsLeft, AboveTheRounding) {
  LawFit fit = fit_with(1);
  fit.residual.autocorrelation = 0.4;
  fit.residual.rms = 1;
  EXPECT_TRUE(more_is_tried(quarters(400, 3, 1), fit, 0.99));
  EXPECT_FALSE(more_is_tried(quarters(400, 3, 1), fit, 1));
  fit.residual.rms = 1e-10;  // of the arithmetic
  EXPECT_FALSE(more_is_tried(quarters(400, 3, 1), fit));
}

TEST(SomethingIsLeft, UnderARecordedForceWhatIsNotWhite) {
  const std::vector<double> y = quarters(400, 1, 1);
  for (const bool white : {true, false}) {
    LawFit fit = fit_with(1);
    fit.residual.rms = 1;
    fit.residual.white = white;
    EXPECT_FALSE(more_is_tried(y, fit));
    fit.drive.kind = DriveKind::harmonic;
    EXPECT_FALSE(more_is_tried(y, fit));
    fit.names[0] = "mass";  // no spring
    EXPECT_EQ(more_is_tried(y, fit), !white);
  }
}

// At the swing's frequency, twice and three times it, and those of the drive.
TEST(SomethingIsLeft, AtAMultiple) {
  const auto line_at = [](double w, double amplitude, double autocorrelation) {
    std::vector<double> y(1000);
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] = amplitude * std::cos(w * static_cast<double>(i) / 64 + 1);
    LawFit fit = fit_with(0.01);
    fit.residual.rms = 1;
    fit.residual.autocorrelation = autocorrelation;
    fit.motion.drive_frequency = 20;
    return more_is_tried(noisy(y, 1), fit);
  };
  for (const double w : {2 * pi, 4 * pi, 6 * pi, 20.0, 40.0, 60.0}) {
    EXPECT_TRUE(line_at(w, 1, 0.1)) << w;
    EXPECT_TRUE(line_at(w, 1, 0.6)) << w;
  }
  for (const double w : {pi, 9.4, 8 * pi, 31.0, 50.0, 80.0}) EXPECT_FALSE(line_at(w, 1, 0.1)) << w;
}

TEST(Widening, IsSaidBelowNineteenTwentieths) {
  LawFit fit;
  fit.residual = {.rms = 1, .normality = 0, .autocorrelation = 0.1234, .white = false};
  const std::string correlated = "the residuals are correlated (0.123 from sample to sample)";
  fit.independent_samples = 190.1;
  EXPECT_EQ(
      in_words(widening(fit, 200)),
      correlated +
          ", but not at the swing's frequency: the uncertainties of frequency and decay are hardly widened");
  fit.independent_samples = 189.9;
  EXPECT_EQ(in_words(widening(fit, 200)),
            correlated + ": the uncertainties are widened to those of 190 independent samples");
  fit.independent_samples = 0;
  EXPECT_EQ(in_words(widening(fit, 200)), "");
}

/// A fit of three dampings, in a swing of 4 rad/s.
LawFit three_dampings() {
  LawFit fit;
  fit.law = law_of("viscous+drag+friction");
  fit.motion.law = fit.law;
  fit.motion.set_angular_frequency(4);
  fit.names = {"angular_frequency", "decay_rate", "drag", "friction"};
  for (const double value : {4.0, 0.03, 0.2, 0.05}) fit.estimates.push_back({value, 0, 0, 0});
  fit.covariance = {1, 0, 0, 0, 0, 4e-4, 1e-4, -2e-4, 0, 1e-4, 9e-4, -3e-4, 0, -2e-4, -3e-4, 16e-4};
  fit.student = 2;
  return fit;
}

// Over a cycle of amplitude A: g, 4 b w A / 3 pi and 2 f / (pi w A).
TEST(MeanDecay, IsTheSumOfItsParts) {
  SyntheticRecord record{even_times(4, 1), {1.5, -1.5, 1.5, -1.5}};
  for (const int derivative : {0, 1, 2}) {
    const double A = 1.5 * std::sqrt(2.0) / std::pow(4, derivative);
    const MeanDecay decay = mean_decay(three_dampings(), {record.t, record.y, 0, derivative}).value();
    EXPECT_NEAR(decay.amplitude, A, 1e-12);
    const double of[] = {1, 4 * 4 * A / (3 * pi), 2 / (pi * 4 * A)};
    EXPECT_NEAR(decay.rate.value, 0.03 * of[0] + 0.2 * of[1] + 0.05 * of[2], 1e-6 * decay.rate.value);
    double variance = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        variance += of[i] * of[j] * three_dampings().covariance[4 * (i + 1) + j + 1];
    EXPECT_NEAR(decay.rate.standard_error, std::sqrt(variance), 1e-6 * std::sqrt(variance));
    EXPECT_NEAR(decay.rate.high - decay.rate.value, 2 * decay.rate.standard_error, 1e-12);
  }
  LawFit loop = three_dampings();
  loop.law = law_of("viscous+hysteresis");
  EXPECT_FALSE(mean_decay(loop, record.record()));
}

// E = 1 - cos A, of which a cycle takes 2 g times the mean of v²: elliptic integrals, with k = sin A/2.
TEST(MeanDecay, OfAPendulumIsTheAmplitudes) {
  const SyntheticRecord record{even_times(4, 1), {1.5, -1.5, 1.5, -1.5}};
  LawFit fit;
  fit.law = law_of("viscous+pendulum");
  fit.motion.law = fit.law;
  fit.motion.per_mass.pendulum = 16;
  fit.motion.per_mass.damping = 0.06;
  fit.names = {"angular_frequency", "decay_rate"};
  for (const double value : {4.0, 0.03}) fit.estimates.push_back({value, 0, 0, 0});
  fit.covariance = {1, 0, 0, 1e-6};
  fit.student = 2;
  const MeanDecay decay = mean_decay(fit, record.record()).value();
  const double A = decay.amplitude, k = std::sin(A / 2), K = std::comp_ellint_1(k), E = std::comp_ellint_2(k);
  // Mean of v² is 4 w² (E/K - (1 - k²)), and dE/dA = w² sin A.
  const double rate = 2 * 0.03 * 4 * (E / K - (1 - k * k)) / (A * std::sin(A));
  EXPECT_NEAR(decay.rate.value, rate, 1e-5 * rate);
  EXPECT_NEAR(decay.rate.standard_error, rate / 0.03 * 1e-3, 1e-5);
}

// Each pair of the three.
TEST(MeanDecay, DampingsThatAreTraded) {
  for (const auto& [i, j] : {std::pair{1, 2}, {1, 3}, {2, 3}}) {
    LawFit fit = three_dampings();
    EXPECT_FALSE(dampings_are_collinear(fit));
    const auto correlate = [&, i = i, j = j](double r) {
      const auto at = [&](int a, int b) -> double& {
        return fit.covariance[static_cast<std::size_t>(4 * a + b)];
      };
      at(i, j) = at(j, i) = r * std::sqrt(at(i, i) * at(j, j));
      return dampings_are_collinear(fit);
    };
    EXPECT_FALSE(correlate(-0.89));
    EXPECT_TRUE(correlate(-0.91));
    EXPECT_FALSE(correlate(0.95));
  }
  LawFit held = three_dampings();
  held.covariance.assign(16, 0.0);
  EXPECT_FALSE(dampings_are_collinear(held));
}

TEST(MeanDecay, IsFedWhereTheIntervalIsBelowNone) {
  EXPECT_TRUE(is_fed(fit_with(-0.1, 0.04)));
  EXPECT_FALSE(is_fed(fit_with(-0.1, 0.06)));
  LawFit fit = fit_with(-0.1, 0.04);
  fit.find("decay_rate")->high = 0;
  EXPECT_FALSE(is_fed(fit));
  fit.names[1] = "drag";
  EXPECT_FALSE(is_fed(fit));
}

TEST(MeanDecay, IsWrittenWithItsError) {
  EXPECT_EQ(in_words(as_clause(MeanDecay{1, {0.0123, 0.0004, 0, 0}, "m"})),
            "decay rate 0.0123\u00a0±\u00a00.0004\u00a01/s at the swing's rms amplitude, 1\u00a0m");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
