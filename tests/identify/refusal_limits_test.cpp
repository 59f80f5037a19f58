// When a fit is refused, on fits made by hand: at, below and above each limit, with the sentence that is
// said.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "cromer/identify/diagnose/refusal.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A fit of 10 s at 100 samples a second that accounts for nearly all.
struct Seen {
  double periods = 10;
  double damping_ratio = 0.01;  ///< as fitted
  double explained = 0.99;
  double independent_samples = 1000;
  double falls = 0;     ///< damping ratio of the record itself
  double error = 1e-4;  ///< of frequency and decay rate, independent of each other
};

constexpr double duration = 10;

SyntheticRecord record_of(const Seen& seen) {
  const double w0 = 2 * pi * seen.periods / duration;
  return viscous_record({.w0 = w0, .g = seen.falls * w0, .equilibrium = 0, .position = 1, .velocity = 0},
                        even_times(1001, duration / 1000));
}

LawFit fit_of(const Seen& seen) {
  const double w = 2 * pi * seen.periods / duration;  // of the damped motion
  const double w0 = w / std::sqrt(1 - seen.damping_ratio * seen.damping_ratio);
  LawFit fit;
  fit.names = {"angular_frequency", "decay_rate", "equilibrium", "position", "velocity"};
  for (const double value : {w0, seen.damping_ratio * w0, 0.0, 1.0, 0.0})
    fit.estimates.push_back({value, 1e-4, value - 2e-4, value + 2e-4});
  fit.covariance.assign(25, 0);
  for (std::size_t i = 0; i < 5; ++i) fit.covariance[6 * i] = seen.error * seen.error;
  fit.explained = seen.explained;
  fit.independent_samples = seen.independent_samples;
  return fit;
}

/// "too_short: the record holds ..."; empty where the fit is taken.
std::string told(const std::optional<Refusal>& refusal) {
  return refusal ? std::string(name(refusal->status)) + ": " + in_words(refusal->message) : "";
}

std::string told(const Seen& seen) { return told(refuse_fit(record_of(seen).record(), fit_of(seen))); }

TEST(RefusalLimits, OneAndAHalfPeriods) {
  EXPECT_EQ(told({.periods = 1.501}), "");
  EXPECT_EQ(told({.periods = 1.499}),
            "too_short: the record holds 1.5 periods of 6.67 s: a fit needs at least 1.5");
  EXPECT_EQ(told({.periods = 1.2}),
            "too_short: the record holds 1.2 periods of 8.33 s: a fit needs at least 1.5");
  // At a hundred samples a second a swing of 100.08 Hz has the values of one of 0.08 Hz.
  EXPECT_EQ(told({.periods = 1000.8, .damping_ratio = 1e-5}),
            "too_short: the record holds 0.8 periods of 12.5 s: a fit needs at least 1.5");
  EXPECT_EQ(told({.periods = 1005, .damping_ratio = 1e-5}), "");
  // What accounts for little says so instead.
  EXPECT_THAT(told({.periods = 1.2, .explained = 0.3}), StartsWith("too_noisy: "));
}

TEST(RefusalLimits, AMotionThatDoesNotOscillate) {
  const char* at_rest =
      "overdamped: the motion comes to rest without an oscillation that can be seen: it is overdamped or "
      "nearly so, or nothing pulls it back";
  const char* ended =
      "too_short: the record ends before an oscillation can be seen, if there is one: a fit needs at least "
      "1.5 periods";
  EXPECT_EQ(told({.periods = 2, .damping_ratio = 0.94, .falls = 0.9}), "");
  // w0 = 4.49, g = 4.31, and w = 1.26 is known to 0.31 or to 0.32 rad/s.
  EXPECT_EQ(told({.periods = 2, .damping_ratio = 0.96, .falls = 0.9, .error = 0.063}), "");
  EXPECT_EQ(told({.periods = 2, .damping_ratio = 0.96, .falls = 0.9, .error = 0.064}), at_rest);
  EXPECT_EQ(told({.periods = 0.4, .damping_ratio = 0.96, .falls = 0.96, .error = 0.1}), at_rest);
  EXPECT_EQ(told({.periods = 0.13, .damping_ratio = 0.96, .falls = 0}), ended);
  // Within a period and a half less damping will do: g > 0.7 w.
  EXPECT_THAT(told({.periods = 1.4, .damping_ratio = 0.56, .falls = 0.5, .error = 0.3}),
              StartsWith("too_short: the record holds"));
  EXPECT_EQ(told({.periods = 1.4, .damping_ratio = 0.58, .falls = 0.6, .error = 0.3}), at_rest);
  EXPECT_EQ(told({.periods = 0.5, .damping_ratio = 0.58, .falls = 0.05}), ended);
}

// What dies down within a period never shows one and a half.
TEST(RefusalLimits, AMotionThatDiesDownWithinAPeriod) {
  EXPECT_EQ(told({.periods = 0.8, .damping_ratio = 0.7, .falls = 0.7}), "");
  EXPECT_EQ(told({.periods = 1.4, .damping_ratio = 0.45, .falls = 0.45}), "");  // g > 0.5 w
  EXPECT_THAT(told({.periods = 1.4, .damping_ratio = 0.44, .falls = 0.44}),
              StartsWith("too_short: the record holds"));
}

// Of long motions half the variance will do, or 300 times the noise; short ones are wandering noise sooner.
TEST(RefusalLimits, HowFarALineStandsOut) {
  EXPECT_EQ(told({.explained = 0.51, .independent_samples = 20}), "");
  EXPECT_EQ(told({.explained = 0.231}), "");  // 0.231/0.769 of 1000: 300.4
  EXPECT_EQ(told({.explained = 0.23}),
            "too_noisy: too noisy: a sinusoid accounts for only 23.0 % of the variance");
  EXPECT_EQ(told({.periods = 3, .explained = 0.334}), "");  // 501
  EXPECT_THAT(told({.periods = 3, .explained = 0.333}), StartsWith("too_noisy: "));
  EXPECT_EQ(told({.periods = 3, .explained = 0.91, .independent_samples = 6}), "");  // 60.7
  EXPECT_THAT(told({.periods = 3, .explained = 0.91, .independent_samples = 5}),
              StartsWith("no_oscillation: "));
  // A motion that has died down after two periods has no more than those.
  EXPECT_THAT(told({.periods = 20, .damping_ratio = 0.1, .explained = 0.3}), StartsWith("too_noisy: "));
}

TEST(RefusalLimits, NoiseOrNoOscillation) {
  EXPECT_THAT(told({.explained = 0.0567}), StartsWith("too_noisy: "));  // 60.1
  EXPECT_EQ(told({.explained = 0.0565}),
            "no_oscillation: no oscillation found: the best decaying sinusoid accounts for 5.7 % of the "
            "variance, and noise like the residual could do as much; choose the part that oscillates with "
            "--from and --to, or another --column");
  // Noise that wanders is no noise that more samples would help against.
  EXPECT_THAT(told({.explained = 0.2, .independent_samples = 501}), StartsWith("too_noisy: "));
  EXPECT_THAT(told({.explained = 0.2, .independent_samples = 499}), StartsWith("no_oscillation: "));
  EXPECT_THAT(told({.explained = -0.1}), HasSubstr("accounts for 0.0 % of the variance"));
}

TEST(RefusalLimits, ThreeLevelsShowNoTops) {
  const Seen seen{.explained = 0.2, .independent_samples = 100};
  SyntheticRecord record = record_of(seen);
  record.resolution = 1;  // -1, 0 and 1
  EXPECT_EQ(told(refuse_fit(record.record(), fit_of(seen))),
            "too_noisy: the values take only 3 levels, 1 apart: the resolution is too coarse for a motion as "
            "small as this");
  record.resolution = 0.66;
  EXPECT_THAT(told(refuse_fit(record.record(), fit_of(seen))), StartsWith("no_oscillation: "));
}

TEST(RefusalLimits, TopsCutOff) {
  const Seen seen;
  // A sinusoid stays 0.014 s within 1 mm of its top; half as much more and three samples may pass.
  for (const auto& [top, said] :
       {std::pair{0.99, ""},  // 0.045 s
        {0.98,
         "clipped: the motion's peaks are cut off at the same value again and again: the sensor was out of "
         "its range; choose the later part with --from"}})  // 0.064 s
    for (const double sign : {1.0, -1.0}) {
      SyntheticRecord record = record_of(seen);
      record.resolution = 1e-3;
      for (double& y : record.y) y = sign * std::min(top, std::round(1e3 * y) / 1e3);
      EXPECT_EQ(told(refuse_fit(record.record(), fit_of(seen))), said) << top << ' ' << sign;
    }
}

// The amplitude is that of the start: with damping it is no longer hypot(x, v / w).
TEST(RefusalLimits, TheAmplitudeCountsTheDampingAtTheStart) {
  const Seen seen{.damping_ratio = 0.2};
  SyntheticRecord record =
      viscous_record({.w0 = 2 * pi, .g = 0, .equilibrium = 0, .position = 1, .velocity = 0},
                     even_times(10001, duration / 10000));
  record.resolution = 1e-3;
  for (double& y : record.y) y = std::min(0.99785, y);  // 21 samples a top, 1 ms apart
  LawFit fit = fit_of(seen);
  // 1.56 m may stay 0.0201 s near its top, 1.28 m 0.0219 s.
  fit.find("velocity")->value = 2 * pi;
  EXPECT_THAT(told(refuse_fit(record.record(), fit)), StartsWith("clipped: "));
  fit.find("velocity")->value = -2 * pi;
  EXPECT_EQ(told(refuse_fit(record.record(), fit)), "");
}

TEST(RefusalLimits, FrequenciesUnknown) {
  LawFit fit = fit_of({});
  fit.law = law_of("viscous+drag");
  const double w = fit.angular_frequency().value;
  const auto off_by = [&](double share) {
    fit.find("angular_frequency")->standard_error = share * w;
    return told(refuse_frequency(fit));
  };
  EXPECT_EQ(off_by(0.0499), "");
  EXPECT_EQ(off_by(0.0501), "too_noisy: too noisy: the frequency is known only to 5 %");
  EXPECT_EQ(off_by(0.98), "too_noisy: too noisy: the frequency is known only to 98 %");
  EXPECT_EQ(off_by(1.02), "too_noisy: the law viscous+drag fits so badly that the frequency is unknown");
  fit.names[0] = "mass";
  EXPECT_EQ(told(refuse_frequency(fit)), "");
}

TEST(RefusalLimits, AHarmonicOfTheDrive) {
  LawFit fit = fit_of({.damping_ratio = 0});
  fit.names.emplace_back("drive_frequency");
  const double w = fit.angular_frequency().value;
  fit.find("angular_frequency")->standard_error = 0;
  const auto driven_at = [&](double frequency) {
    fit.estimates.resize(5);
    fit.estimates.push_back({frequency, 0, frequency, frequency});
    return told(refuse_harmonic(fit));
  };
  EXPECT_EQ(driven_at(w), "");
  EXPECT_THAT(driven_at(w / 2),
              HasSubstr("a steady oscillation at 0.5 Hz and its harmonic of order 2, which does not decay"));
  EXPECT_THAT(driven_at(w / 3), HasSubstr("order 3"));
  EXPECT_THAT(driven_at(w / 2 * (1 + 0.9e-4)), HasSubstr("order 2"));
  EXPECT_EQ(driven_at(w / 2 * (1 + 1.1e-4)), "");
  fit.find("angular_frequency")->standard_error = 0.001 * w;
  EXPECT_THAT(driven_at(w / 2 * 1.0039), HasSubstr("order 2"));
  EXPECT_EQ(driven_at(w / 2 * 1.0043), "");
  EXPECT_THAT(driven_at(w / 2), HasSubstr("order 2"));
  // A swing larger than the steady line is the body's own, not the line's harmonic.
  fit.names.emplace_back("drive_amplitude");
  const auto pushed_by = [&](double amplitude) {
    fit.estimates.push_back({amplitude, 0, amplitude, amplitude});
    const std::string said = told(refuse_harmonic(fit));
    fit.estimates.pop_back();
    return said;
  };
  fit.motion.position = 0.03;
  fit.motion.velocity = 0.04 * w;
  const double start = std::hypot(fit.motion.position, fit.motion.velocity / w), way = 0.75 * w * w;
  EXPECT_EQ(pushed_by(0.49 * start * way), "");
  EXPECT_THAT(pushed_by(0.51 * start * way), HasSubstr("order 2"));
  fit.names.pop_back();
  fit.find("decay_rate")->low = 1e-6;  // it does decay
  EXPECT_EQ(driven_at(w / 2), "");
}

TEST(RefusalLimits, NothingPullsBack) {
  const std::vector<double> t = even_times(100, 0.1), y = noisy(t, 0.1);
  const auto refusal = [&](const Law& law, const Drive& drive) {
    const auto found = refuse_record({t, y}, {.law = law, .drive = drive});
    return found ? in_words(found->message) : "";
  };
  const Drive recorded = Drive::recorded({y, 0, 0.1, BetweenSamples::linear});
  EXPECT_EQ(refusal(law_with<Viscous>, {}), in_words(Notice{"no_spring"}));
  EXPECT_EQ(refusal(law_with<Viscous>, Drive::harmonic()), in_words(Notice{"no_spring"}));
  EXPECT_EQ(refusal(law_with<Viscous>, recorded), "");
  EXPECT_EQ(refusal(law_of("viscous"), {}), "");
}

TEST(RefusalLimits, FewestSamples) {
  const auto with = [](std::size_t samples, const LawFitOptions& options) {
    const SyntheticRecord record = viscous_record({}, even_times(samples, 0.01));
    return told(refuse_record(record.record(), options));
  };
  EXPECT_EQ(with(8, {}), "");
  EXPECT_EQ(with(7, {}), "too_short: 7 samples are too few: a fit of the law viscous needs at least 8");
  EXPECT_EQ(with(9, {.law = law_of("viscous+drag")}), "");
  EXPECT_EQ(with(8, {.law = law_of("viscous+drag")}),
            "too_short: 8 samples are too few: a fit of the law viscous+drag needs at least 9");
  const LawFitOptions driven{.drive = Drive::harmonic()};
  EXPECT_EQ(with(32, driven), "");
  EXPECT_THAT(with(31, driven), StartsWith("too_short: 31 samples are too few"));
  const SyntheticRecord rest = viscous_record({.position = 0, .velocity = 0}, even_times(100, 0.01));
  EXPECT_EQ(told(refuse_record(rest.record(), {})), "no_oscillation: all values are the same: nothing moves");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
