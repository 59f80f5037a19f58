#include "cromer/tasks/spectrum/response_spectrum.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

#include "cromer/base/pi.h"
#include "cromer/documents/words/words.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// `samples` at a step, with seventeen digits.
SpectrumFile recording(int samples, double step, const std::function<double(double)>& a,
                       const std::string& heading = "acceleration (m/s^2)") {
  std::string bytes = "time (s)," + heading + "\n";
  char line[80];
  for (int i = 0; i < samples; ++i) {
    std::snprintf(line, sizeof line, "%.15g,%.17g\n", i * step, a(i * step));
    bytes += line;
  }
  return {"shake.csv", bytes};
}

double ripple(double t) { return std::sin(20 * t) * std::exp(-t) + 0.3 * std::sin(3 * t + 1); }

Result<SpectrumResult> spectrum_of(const SpectrumFile& file, const SpectrumOptions& options) {
  return response_spectrum({&file, 1}, options);
}

std::string message(const SpectrumFile& file, const SpectrumOptions& options) {
  const auto result = spectrum_of(file, options);
  return result ? "accepted" : in_words(result.error());
}

// A half-sine pulse of 10 ms on an undamped oscillator: during it the mass follows
// A r/(r^2 - 1) (sin(w t)/... ) in closed form, after it it swings with 2 A r cos(pi r/2)/(1 - r^2), r = 2
// D/T.
TEST(ShockSpectrum, OfAHalfSineIsTheAnalyticOne) {
  const double duration = 0.01, amplitude = 300;
  constexpr int samples = 20001;
  const SpectrumFile file = recording(samples, duration / (samples - 1), [&](double t) {
    return t >= duration ? 0.0 : amplitude * std::sin(pi * t / duration);
  });
  SpectrumOptions options;
  options.shock = true;
  options.damping_ratio = {"0"};
  options.frequencies = "10:1000:97:log Hz";
  const auto result = spectrum_of(file, options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  const double p = pi / duration;
  for (std::size_t i = 0; i < result->periods.size(); ++i) {
    const double w = 2 * pi / result->periods[i], r = w / p;
    if (std::abs(r - 1) < 1e-3) continue;  // the closed form below is 0/0 there
    // Absolute acceleration y = A r/(r^2 - 1) (r sin p t - sin w t); it turns where cos p t = cos w t.
    double primary = 0, positive = 0, negative = 0;
    for (int n = 1; n < 400; ++n)
      for (const double t : {2 * pi * n / (w + p), 2 * pi * n / std::abs(w - p)}) {
        if (t > duration) continue;
        const double y = amplitude * r / (r * r - 1) * (r * std::sin(p * t) - std::sin(w * t));
        primary = std::max(primary, std::abs(y));
        positive = std::max(positive, y);
        negative = std::max(negative, -y);
      }
    const double end = -amplitude * r / (r * r - 1) * std::sin(w * duration);
    primary = std::max(primary, std::abs(end));
    const double residual = std::abs(2 * amplitude * r * std::cos(pi * r / 2) / (1 - r * r));
    const Shock& shock = result->spectra[0].shock[i];
    EXPECT_NEAR(shock.primary, primary, 1e-6 * primary) << r;
    EXPECT_NEAR(shock.residual, residual, 1e-6 * std::max(residual, primary)) << r;
    EXPECT_NEAR(shock.maximax(), std::max(primary, residual), 1e-6 * primary) << r;
    EXPECT_NEAR(shock.positive, std::max(positive, residual), 1e-6 * primary) << r;
    EXPECT_NEAR(shock.negative, std::max(negative, residual), 1e-6 * primary) << r;
  }
}

// The same oscillators by a fine Runge-Kutta integration of z'' + 2 zeta w z' + w^2 z = -a, the pulse cut
// short so that a swing remains; extremes by parabolas through the steps.
TEST(ShockSpectrum, OfEachResponseIsThatOfAFineIntegration) {
  constexpr int samples = 41;
  const double spacing = 0.01, zeta = 0.08;
  const auto a = [](double t) { return 5 * std::sin(9 * t) + 3 * t; };
  const SpectrumFile file = recording(samples, spacing, a);
  const double periods[] = {0.05, 0.3, 1.1, 6};
  for (std::size_t which = 0; which < shock_responses.size(); ++which) {
    SpectrumOptions options;
    options.shock = true;
    options.shock_response = shock_responses[which];
    options.damping_ratio = {"0.08"};
    options.periods = "0.05,0.3,1.1,6";
    const auto result = spectrum_of(file, options);
    ASSERT_TRUE(result.ok()) << in_words(result.error());
    for (std::size_t p = 0; p < 4; ++p) {
      const double w = 2 * pi / periods[p];
      constexpr int per_interval = 400, end = (samples - 1) * per_interval;
      const double h = spacing / per_interval;
      // The base in half steps; at rest once the recording has ended.
      const auto base = [&](int half_steps) {
        const int i = std::min(half_steps / (2 * per_interval), samples - 2);
        const double share = half_steps / (2.0 * per_interval) - i;
        return std::lerp(a(i * spacing), a((i + 1) * spacing), share);
      };
      const auto pull = [&](double x, double u, double of_base) {
        return -of_base - 2 * zeta * w * u - w * w * x;
      };
      double z = 0, v = 0, high[2] = {}, low[2] = {};
      const int steps = end + static_cast<int>(2 * periods[p] / h);
      for (int n = 0; n <= steps; ++n) {
        const double q[] = {-2 * zeta * w * v - w * w * z, v, z, w * z, -w * w * z};
        const bool after = n > end, rests = n >= end;
        high[after] = std::max(high[after], q[which]);
        low[after] = std::min(low[after], q[which]);
        const double f0 = rests ? 0 : base(2 * n), f1 = rests ? 0 : base(2 * n + 1),
                     f2 = rests ? 0 : base(2 * n + 2);
        const double k1 = pull(z, v, f0), k2 = pull(z + h / 2 * v, v + h / 2 * k1, f1),
                     k3 = pull(z + h / 2 * v + h * h / 4 * k1, v + h / 2 * k2, f1),
                     k4 = pull(z + h * v + h * h / 2 * k2, v + h * k3, f2);
        z += h * v + h * h / 6 * (k1 + k2 + k3);
        v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      }
      const Shock& shock = result->spectra[0].shock[p];
      const double most = std::max({high[0], high[1], -low[0], -low[1]});
      const double within = 2e-5 * most;
      EXPECT_NEAR(shock.maximax(), most, within) << shock_responses[which] << " " << p;
      EXPECT_NEAR(shock.positive, std::max(high[0], high[1]), within) << shock_responses[which] << " " << p;
      EXPECT_NEAR(shock.negative, -std::min(low[0], low[1]), within) << shock_responses[which] << " " << p;
      EXPECT_NEAR(shock.primary, std::max(high[0], -low[0]), within) << shock_responses[which] << " " << p;
    }
  }
  EXPECT_THAT(message(file, {.shock_response = "pseudo-velocity"}),
              HasSubstr("--shock-response says of what"));
  EXPECT_THAT(message(file, {.shock = true, .shock_response = "velocity"}),
              HasSubstr("--shock-response: \"velocity\""));
}

// A held constant force on an undamped oscillator swings to twice its static displacement, ever.
TEST(ResponseSpectrum, OfAStepIsTwiceTheStaticOne) {
  const SpectrumFile file = recording(400, 0.01, [](double) { return 2.0; });
  SpectrumOptions options;
  options.damping_ratio = {"0", "0.05"};
  options.periods = "0.03,0.5,2";
  const auto result = spectrum_of(file, options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = result->periods[i];
    EXPECT_NEAR(pseudo_acceleration(result->spectra[0].displacement[0][i], t), 4, 1e-12);
    const double overshoot = 1 + std::exp(-0.05 * pi / std::sqrt(1 - 0.0025));
    EXPECT_NEAR(pseudo_acceleration(result->spectra[1].displacement[0][i], t), 2 * overshoot, 1e-12);
  }
}

// One cycle of sin(w t) carries the ground 2 pi/w^2 away at most, and a mass on a very soft spring stays
// behind.
TEST(ResponseSpectrum, OfLongPeriodsIsTheGroundsDisplacement) {
  const double w = 20;
  const SpectrumFile file = recording(2001, 2 * pi / w / 2000, [&](double t) { return std::sin(w * t); });
  SpectrumOptions options;
  options.periods = "1e4";
  options.damping_ratio = {"0"};
  options.peaks = "samples";
  const auto result = spectrum_of(file, options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  EXPECT_NEAR(result->spectra[0].displacement[0][0] * w * w / (2 * pi), 1, 1e-6);
}

TEST(ResponseSpectrum, IntensityAndDuration) {
  // a = 1 for 10 s: pi/(2 g) * 10; from 5 to 95 % 9 s.
  const SpectrumFile file = recording(1001, 0.01, [](double) { return 1.0; });
  SpectrumOptions options;
  options.periods = "1";
  const auto result = spectrum_of(file, options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  const Intensity& found = result->components[0].intensity;
  EXPECT_NEAR(found.arias, pi / (2 * standard_gravity) * 10, 1e-12);
  EXPECT_NEAR(found.from, 0.5, 1e-9);
  EXPECT_NEAR(found.duration, 9, 1e-9);
  // The transform of a rectangle at 0: its area.
  EXPECT_NEAR(result->components[0].fourier.amplitude[0], 10.01, 1e-9);
}

TEST(ResponseSpectrum, OfOneDirectionRotatedIsItsProjection) {
  const SpectrumFile files[] = {recording(800, 0.01, ripple),
                                recording(800, 0.01, [](double t) { return 0.75 * ripple(t); })};
  for (const char* peaks : {"continuous", "samples", "peer"}) {
    SpectrumOptions options;
    options.periods = "0.02,0.3,0.31,5";
    options.peaks = peaks;
    const auto result = response_spectrum(files, options);
    ASSERT_TRUE(result.ok()) << in_words(result.error());
    const ResponseSpectrum& spectrum = result->spectra[0];
    for (std::size_t i = 0; i < 4; ++i) {
      const double along = 1.25 * spectrum.displacement[0][i];
      EXPECT_NEAR(spectrum.displacement[1][i], 0.75 * spectrum.displacement[0][i], 1e-12 * along);
      EXPECT_NEAR(spectrum.geometric_mean[i], std::sqrt(0.75) * spectrum.displacement[0][i], 1e-12 * along);
      EXPECT_NEAR(spectrum.rotd100[i], along, 4e-5 * along) << peaks;
      EXPECT_LE(spectrum.rotd100[i], along * (1 + 1e-12)) << peaks;
      EXPECT_NEAR(spectrum.rotd50[i], along * std::cos(pi / 4), 0.01 * along) << peaks;  // median of |cos|
    }
  }
}

TEST(ResponseSpectrum, RotationsAreThoseOfRotatedRecords) {
  const auto other = [](double t) { return std::cos(13 * t) * std::exp(-0.4 * t); };
  const SpectrumFile files[] = {recording(300, 0.02, ripple), recording(300, 0.02, other)};
  for (const char* peaks : {"continuous", "samples", "peer"})
    for (const char* between : {"linear", "hold", "band-limited"}) {
      SpectrumOptions options;
      options.periods = "0.011,0.04,0.1,0.3,2,30";
      options.peaks = peaks;
      options.between_samples = between;
      const auto both = response_spectrum(files, options);
      if (!both) continue;  // peer joins by straight lines
      std::vector<std::vector<double>> reach(6);
      for (int degree = 0; degree < 180; ++degree) {
        const double angle = degree * pi / 180;
        const auto alone = spectrum_of(
            recording(300, 0.02,
                      [&](double t) { return std::cos(angle) * ripple(t) + std::sin(angle) * other(t); }),
            options);
        for (std::size_t i = 0; i < 6; ++i) reach[i].push_back(alone->spectra[0].displacement[0][i]);
      }
      for (std::size_t i = 0; i < 6; ++i) {
        std::sort(reach[i].begin(), reach[i].end());
        EXPECT_NEAR(both->spectra[0].rotd100[i] / reach[i].back(), 1, 1e-11) << peaks << " " << between << i;
        EXPECT_NEAR(both->spectra[0].rotd50[i] / ((reach[i][89] + reach[i][90]) / 2), 1, 1e-11)
            << peaks << " " << between << i;
      }
    }
}

TEST(ResponseSpectrum, UnitsAreRead) {
  SpectrumOptions options;
  options.periods = "0.5";
  const auto psa = [&](const char* heading, double factor, const char* unit = "") {
    options.unit = unit;
    const auto result = spectrum_of(recording(
                                        200, 0.01, [&](double t) { return ripple(t) / factor; }, heading),
                                    options);
    return result ? result->spectra[0].displacement[0][0] : std::nan("");
  };
  const double reference = psa("acceleration (m/s^2)", 1);
  EXPECT_NEAR(psa("acc (g)", 9.80665), reference, 1e-12 * reference);
  EXPECT_NEAR(psa("acc (cm/s^2)", 0.01), reference, 1e-12 * reference);
  EXPECT_NEAR(psa("acc (gal)", 0.01), reference, 1e-12 * reference);
  EXPECT_NEAR(psa("acceleration", 9.80665, "g"), reference, 1e-12 * reference);
  EXPECT_NEAR(psa("acceleration", 1), reference, 1e-12 * reference);
}

// The same samples as a CSV, a PEER and a universal file.
TEST(ResponseSpectrum, FilesOfOtherDialectsAreRead) {
  std::string csv = "time (s),acc (g)\n", at2, uff;
  char text[400];
  constexpr int samples = 200;
  for (int i = 0; i < samples; ++i) {
    std::snprintf(text, sizeof text, "%.5E", 0.1 * ripple(0.01 * i));
    const double a = std::atof(text);
    std::snprintf(text, sizeof text, "%.2f,%.5E\n", 0.01 * i, a);
    csv += text;
    std::snprintf(text, sizeof text, "%14.5E%s", a, i % 5 == 4 ? "\n" : "");
    at2 += text;
    std::snprintf(text, sizeof text, "%13.5E%s", a, i % 6 == 5 || i + 1 == samples ? "\n" : "");
    uff += text;
  }
  at2 =
      "PEER NGA STRONG MOTION DATABASE RECORD\nsomewhere, 1/1/2000, station, 0\nACCELERATION TIME SERIES IN "
      "UNITS OF G\nNPTS=   200, DT=   .0100 SEC\n" +
      at2;
  uff =
      "    -1\n    58\ntable\nNONE\n02-JUN-20 10:00:00\nNONE\nNONE\n"
      "    1         0    0         0 NONE               3   3 NONE               0   0\n"
      "         2       200         1  0.00000E+00  1.00000E-02  0.00000E+00\n"
      "        17    0    0    0 Time                 s                   \n"
      "        12    0    0    0 NONE                 g                   \n"
      "         0    0    0    0 NONE                 NONE                \n"
      "         0    0    0    0 NONE                 NONE                \n" +
      uff + "    -1\n";
  SpectrumOptions options;
  options.periods = "0.1,1";
  const auto reference = spectrum_of({"a.csv", csv}, options);
  ASSERT_TRUE(reference.ok()) << in_words(reference.error());
  for (const SpectrumFile& file : {SpectrumFile{"a.AT2", at2}, SpectrumFile{"a.uff", uff}}) {
    const auto found = spectrum_of(file, options);
    ASSERT_TRUE(found.ok()) << in_words(found.error());
    EXPECT_THAT(in_words(found->notices), ElementsAre(HasSubstr("the integrated velocity ends at ")))
        << file.name;
    EXPECT_EQ(found->components[0].acceleration, reference->components[0].acceleration) << file.name;
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(found->spectra[0].displacement[0][i] / reference->spectra[0].displacement[0][i], 1, 1e-12);
  }
}

TEST(ResponseSpectrum, RowsAreInTheOrderAskedFor) {
  SpectrumOptions options;
  options.periods = "2,0.1,1";
  EXPECT_THAT(spectrum_of(recording(300, 0.01, ripple), options)->periods, ElementsAre(2, 0.1, 1));
  options.periods = "";
  options.frequencies = "1,2 Hz";
  const auto by_frequency = spectrum_of(recording(300, 0.01, ripple), options);
  EXPECT_THAT(by_frequency->periods, ElementsAre(1, 0.5));
}

TEST(ResponseSpectrum, BadOptionsAreNamed) {
  const SpectrumFile file = recording(300, 0.01, ripple);
  const auto with = [&](auto change) {
    SpectrumOptions options;
    change(options);
    return message(file, options);
  };
  EXPECT_THAT(with([](auto& o) { o.periods = "0.1:1"; }), HasSubstr("--periods: \"0.1:1\" has 2 pieces"));
  EXPECT_THAT(with([](auto& o) { o.periods = " "; }), HasSubstr("--periods: the grid is empty"));
  EXPECT_THAT(with([](auto& o) { o.periods = "1,-2"; }),
              HasSubstr("--periods: it must be positive, not -2 s"));
  EXPECT_THAT(with([](auto& o) { o.periods = "0,1"; }), HasSubstr("it must be positive"));
  EXPECT_THAT(with([](auto& o) { o.periods = "1 Hz"; }), HasSubstr("--periods: \"1 Hz\" is a frequency"));
  EXPECT_THAT(with([](auto& o) { o.periods = "1e-9"; }),
              HasSubstr("below a thousandth of the sampling step"));
  EXPECT_THAT(with([](auto& o) { o.periods = "1e12"; }), HasSubstr("more than a million times"));
  EXPECT_THAT(with([](auto& o) {
                o.periods = "0.1:1:1000000000000000";
                o.memory = 8e9;
              }),
              HasSubstr("1e+15 points need 664 PB of memory, but there are only 8 GB"));
  EXPECT_THAT(with([](auto& o) {
                o.periods = "1";
                o.frequencies = "1";
              }),
              HasSubstr("leave one of them out"));
  EXPECT_THAT(with([](auto& o) { o.damping_ratio = {"-0.05"}; }),
              HasSubstr("--damping-ratio: it must lie between 0 and 20, not -0.05"));
  EXPECT_THAT(with([](auto& o) { o.damping_ratio = {"much"}; }), HasSubstr("--damping-ratio: \"much\""));
  EXPECT_THAT(
      with([](auto& o) { o.peaks = "sample"; }),
      HasSubstr("--peaks: \"sample\" is not known; it takes continuous, samples or peer (did you mean "
                "samples?)"));
  EXPECT_THAT(with([](auto& o) { o.between_samples = "cubic"; }), HasSubstr("--between-samples: \"cubic\""));
  EXPECT_THAT(with([](auto& o) {
                o.peaks = "peer";
                o.between_samples = "hold";
              }),
              HasSubstr("--peaks peer joins the samples by straight lines"));
  EXPECT_THAT(with([](auto& o) { o.unit = "g"; }), HasSubstr("--unit: shake.csv: column"));
  EXPECT_THAT(with([](auto& o) { o.run = 3; }), HasSubstr("there is no run 3: the file has 1 run"));
  EXPECT_THAT(with([](auto& o) { o.column = {"force"}; }), HasSubstr("force"));
}

TEST(ResponseSpectrum, OfSeveralRunsTheFirstIsTakenAndTheNoticesNameTheFile) {
  std::string bytes = "Time (s),Acceleration (m/s^2)\n";
  for (const double w : {5.0, 9.0})
    for (int i = 0; i < 300; ++i)
      bytes += std::to_string(0.01 * i) + "," + std::to_string(std::sin(0.01 * w * i)) + "\n";
  SpectrumOptions options;
  options.periods = "0.1,1";
  const auto found = spectrum_of({"shake.csv", bytes}, options);
  ASSERT_TRUE(found.ok()) << in_words(found.error());
  EXPECT_THAT(
      in_words(found->notices),
      ::testing::IsSupersetOf({"shake.csv: the spectrum is that of run 1 of 2; --run chooses another",
                               "shake.csv: the time starts again in line 302: the file is read as 2 runs"}));
  options.run = 2;
  EXPECT_THAT(in_words(spectrum_of({"shake.csv", bytes}, options)->notices),
              ::testing::Not(::testing::Contains(HasSubstr("--run chooses another"))));
}

// With little damping, half the loss factor is the damping ratio, apart from what the ground does between its
// samples.
TEST(ResponseSpectrum, OfHystereticDampingIsNearThatOfADamper) {
  const SpectrumFile file = recording(600, 0.01, [](double t) { return ripple(t) * t * std::exp(-t); });
  SpectrumOptions options;
  options.periods = "0.1,0.3,1,3";
  options.damping_ratio = {"0.01"};
  const auto viscous = spectrum_of(file, options);
  options.damping_ratio = {};
  options.loss_factor = {"0.02"};
  const auto hysteretic = spectrum_of(file, options);
  ASSERT_TRUE(hysteretic.ok()) << in_words(hysteretic.error());
  EXPECT_TRUE(hysteretic->hysteretic());
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(hysteretic->spectra[0].displacement[0][i] / viscous->spectra[0].displacement[0][i], 1, 0.02)
        << i;

  options.peaks = "samples";
  EXPECT_THAT(message(file, options), HasSubstr("leave --peaks out"));
  options.peaks = "";
  options.shock = true;
  EXPECT_THAT(message(file, options), HasSubstr("leave --shock out"));
  options.shock = false;
  options.damping_ratio = {"0.05"};
  EXPECT_THAT(message(file, options), HasSubstr("leave one of them out"));
  options.damping_ratio = {};
  options.loss_factor = {"0"};
  EXPECT_THAT(message(file, options), HasSubstr("--loss-factor: it must lie between 0.001 and 2, not 0"));
  options.loss_factor = {"0.001"};
  options.periods = "100000";
  EXPECT_THAT(message(file, options), HasSubstr("until the slowest oscillator rests"));
}

TEST(ResponseSpectrum, BadRecordingsAreNamed) {
  EXPECT_THAT(message(recording(1, 0.01, ripple), {}), HasSubstr("sample"));
  EXPECT_THAT(message(recording(300, 0.01, ripple, "position (m)"), {}),
              HasSubstr("holds position, not an acceleration (m/s^2 or g); choose another with --column"));
  EXPECT_THAT(message({"shake.csv", "time (s),ax (g),ay (g)\n0,1,2\n0.1,2,3\n0.2,3,4\n0.3,4,5\n"}, {}),
              HasSubstr("which column is the acceleration? \"ax\", \"ay\"; say it with --column"));
  EXPECT_THAT(message({"shake.csv", "time (s),a (g)\n0,1\n0.1,2\n0.2,3\n0.37,4\n0.5,4\n0.6,5\n"}, {}),
              HasSubstr("a spectrum needs even samples"));
  SpectrumOptions unit;
  unit.unit = "kg";
  EXPECT_THAT(message(recording(300, 0.01, ripple, "acceleration"), unit),
              HasSubstr("--unit: \"kg\" is no unit of acceleration"));
}

TEST(ResponseSpectrum, TwoComponentsMustMatch) {
  const SpectrumFile slow = recording(300, 0.02, ripple), fast = recording(300, 0.01, ripple),
                     cut = recording(250, 0.01, ripple);
  const SpectrumFile unlike[] = {fast, slow}, unequal[] = {fast, cut}, three[] = {fast, fast, fast};
  const auto refused = response_spectrum(unlike, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(in_words(refused.error()), HasSubstr("has a sample every 0.01 s"));
  EXPECT_THAT(in_words(refused.error()), HasSubstr("one every 0.02 s"));
  const auto shortened = response_spectrum(unequal, {});
  ASSERT_TRUE(shortened.ok());
  EXPECT_EQ(shortened->components[0].acceleration.size(), 250u);
  EXPECT_THAT(in_words(shortened->notices),
              ::testing::Contains(HasSubstr("its last 50 samples are left out")));
  EXPECT_FALSE(response_spectrum(three, {}).ok());
  SpectrumOptions shock;
  shock.shock = true;
  const SpectrumFile both[] = {fast, fast};
  EXPECT_FALSE(response_spectrum(both, shock).ok());
}

TEST(ResponseSpectrum, OfSpringsThatYieldTakesLittleElse) {
  const SpectrumFile file = recording(300, 0.01, ripple);
  const SpectrumFile both[] = {file, file};
  const auto refused = [](std::string_view option) {
    return "--ductility follows one motion, straight between its samples, until its last sample; leave --" +
           std::string(option) + " out";
  };
  const SpectrumOptions yielding{.ductility = {"2"}, .periods = "0.5,1"};
  const auto with = [&](auto change) {
    SpectrumOptions options = yielding;
    change(options);
    return message(file, options);
  };
  EXPECT_EQ(with([](auto&) {}), "accepted");
  EXPECT_EQ(with([](auto& o) { o.loss_factor = {"0.1"}; }), refused("loss-factor"));
  EXPECT_EQ(with([](auto& o) { o.shock = true; }), refused("shock"));
  EXPECT_EQ(with([](auto& o) { o.peaks = "samples"; }), refused("peaks"));
  EXPECT_EQ(with([](auto& o) { o.between_samples = "hold"; }), refused("between-samples"));
  EXPECT_EQ(with([](auto& o) { o.between_samples = "linear"; }), "accepted");
  EXPECT_EQ(in_words(response_spectrum(both, yielding).error()),
            "--ductility takes one recording; ask for the components one after the other");
  for (const auto& [option, steady] : {std::pair{"loss-factor", SpectrumOptions{.loss_factor = {"0.1"}}},
                                       std::pair{"shock", SpectrumOptions{.shock = true}}})
    EXPECT_EQ(
        in_words(response_spectrum(both, steady).error()),
        "--" + std::string(option) + " takes one recording; ask for the components one after the other");
  EXPECT_EQ(message(file, {.loss_factor = {"0.1"}, .between_samples = "linear"}),
            "--loss-factor sums steady states of a band-limited ground; leave --between-samples out");
}

TEST(ResponseSpectrum, ItsOptionsAreCheckedBeforeAnythingIsRead) {
  const auto told = [](const SpectrumOptions& options, std::size_t files = 1) {
    const auto good = check_spectrum_options(options, files);
    return good ? "" : in_words(good.error());
  };
  EXPECT_EQ(told({}), "");
  EXPECT_EQ(told({}, 2), "");
  EXPECT_EQ(told({}, 3), "spectrum takes one recording, or the two components of one motion; 3 are given");
  EXPECT_EQ(told({.peaks = "peer", .between_samples = "hold"}),
            "--peaks peer joins the samples by straight lines; leave --between-samples out");
  EXPECT_EQ(told({.shock = true}, 2),
            "--shock takes one recording; ask for the components one after the other");
  EXPECT_EQ(told({.shock = true, .column = {"x", "y"}}),
            "--shock takes one recording; ask for the components one after the other");
  EXPECT_EQ(told({.shock = true, .column = {"x"}}), "");
}

TEST(ResponseSpectrum, SaysHowFarItIs) {
  const SpectrumFile file = recording(40, 0.01, ripple);
  std::vector<double> seen;
  const auto result = response_spectrum(
      {&file, 1}, {.damping_ratio = {"0.02,0.05"}, .ductility = {"2"}, .periods = "0.1,0.2,0.3,0.4,0.5"},
      {.progress = [&](double share) { seen.push_back(share); }});
  ASSERT_TRUE(result.ok());
  EXPECT_THAT(seen, ElementsAre(0.4, 0.5, 0.9, 1));
}

TEST(ResponseSpectrum, SaysWhereADuctilityIsNotReached) {
  // Two hundred cycles at a natural frequency: the ground itself moves far less than the mass.
  const auto result = spectrum_of(recording(4001, 0.025, [](double t) { return std::cos(4 * pi * t); }),
                                  {.damping_ratio = {"0"}, .ductility = {"2", "100"}, .periods = "0.5,2"});
  ASSERT_TRUE(result.ok());
  EXPECT_THAT(
      in_words(result->notices),
      ::testing::Contains("a ductility of 100 is not reached at 1 period, however weak the spring: NaN"));
  EXPECT_EQ(result->notices.size(), 2u);
  EXPECT_TRUE(std::isnan(result->spectra[1].displacement[0][0]));
  for (const double reached : {result->spectra[0].displacement[0][0], result->spectra[0].displacement[0][1],
                               result->spectra[1].displacement[0][1]})
    EXPECT_GT(reached, 0);
}

TEST(ResponseSpectrum, DoubtfulPeriodsAreSaid) {
  SpectrumOptions options;
  options.periods = "0.015,0.5,100";
  options.peaks = "samples";
  const auto result = spectrum_of(recording(300, 0.01, ripple), options);
  ASSERT_TRUE(result.ok());
  EXPECT_THAT(
      in_words(result->notices),
      ElementsAre(HasSubstr("--periods: one period is below 0.02 s, twice the sampling step of 0.01 s: the "
                            "recording holds nothing that fast"),
                  HasSubstr("--peaks samples: the recording (2.99 s) is shorter than the longest period"),
                  HasSubstr("the integrated velocity ends at ")));
  options.periods = "0.02,1";
  options.peaks = "continuous";
  EXPECT_THAT(in_words(spectrum_of(recording(300, 0.01, ripple), options)->notices),
              ElementsAre(HasSubstr("the integrated velocity ends at ")));
  // A ground that ends at speed goes on: the softest springs are stretched later.
  options.periods = "0.5,50,200";
  EXPECT_THAT(
      in_words(spectrum_of(recording(300, 0.01, [](double t) { return 1 + 0.1 * t; }), options)->notices),
      ElementsAre(HasSubstr("the integrated velocity ends at "),
                  HasSubstr("from a period of 50 s on, some peaks come after the recording's end")));
  options.peaks = "samples";
  EXPECT_THAT(
      in_words(spectrum_of(recording(300, 0.01, [](double t) { return 1 + 0.1 * t; }), options)->notices),
      ElementsAre(HasSubstr("is shorter than the longest period"),
                  HasSubstr("the integrated velocity ends at ")));
}

TEST(ResponseSpectrum, StopsWhenInterrupted) {
  std::atomic<bool> interrupt{true};
  const SpectrumFile file = recording(300, 0.01, ripple);
  const auto result = response_spectrum({&file, 1}, {}, {.interrupt = &interrupt});
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->interrupted);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
