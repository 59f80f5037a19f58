#include "cromer/tasks/compare/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numbers>
#include <random>

#include "cromer/documents/words/words.h"
#include "cromer/identify/motion/motion_model.h"
#include "cromer/methods/all.h"
#include "tests/identify/synthetic.h"
#include "tests/tasks/disc_recording.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::HasSubstr;

CompareResult compared(const Series& series, const CompareOptions& options) {
  const Result<FittedRecording> fit = fit_series(series, "recording2.csv", options.fit);
  EXPECT_TRUE(fit.ok());
  Result<CompareResult> result = compare_fitted(*fit, options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : in_words(result.error()));
  return result.ok() ? *result : CompareResult{};
}

TEST(CompareTask, ExplainsTheMisfitInASentence) {
  CompareOptions options;
  options.fit.segment = 30;
  options.fit.segments = 3;
  options.method = {"rk4"};
  const std::string drag = in_words(explanation(compared(disc_recording(), options)));
  EXPECT_THAT(drag, HasSubstr("One decay rate is not enough. By the law it falls from 0.014"));
  EXPECT_THAT(drag, HasSubstr("are left, with viscous+drag 30"));
  EXPECT_THAT(drag, HasSubstr("% too small. Quote the law"));
  options.fit.goal = "drag 1 %";  // not of the constant rate beside it
  EXPECT_EQ(in_words(explanation(compared(disc_recording(), options))), drag);
  options.fit = FitOptions{};
  options.fit.law = "viscous";
  EXPECT_THAT(in_words(explanation(compared(disc_recording(), options))),
              HasSubstr("No other law was tried: with one"));
  options.fit.law = "auto";
  EXPECT_THAT(in_words(explanation(compared(
                  disc_recording(2, 60, {.mass = 0.2176, .stiffness = 17.04, .damping = 0.01}), options))),
              HasSubstr("One decay rate is enough: with one"));
  EXPECT_TRUE(explanation(CompareResult{}).empty());
}

TEST(CompareTask, OneRateLeavesWhatTheViscousFitLeaves) {
  const CompareResult result = compared(disc_recording(), {});
  FitOptions viscous;
  viscous.law = "viscous";
  const Result<FittedRecording> fit = fit_series(disc_recording(), "recording2.csv", viscous);
  ASSERT_TRUE(fit.ok());
  ASSERT_EQ(result.curves.size(), 3u);
  EXPECT_NEAR(result.curves[0].law_rms, fit->fit.residual.rms, 0.01 * fit->fit.residual.rms);
}

// The temperature and the seed need the disc and the trials, which the fit of one rate does not ask for.
TEST(CompareTask, WhatIsAskedOfTheFitIsNotAskedOfTheOneRate) {
  CompareOptions options;
  options.method = {"rk4"};
  options.fit.law = "viscous+drag";
  const CompareResult plain = compared(disc_recording(4, 20), options);
  options.fit.mass = {Quantity{0.2176, 0}};
  options.fit.disc_diameter = Quantity{0.12, 0};
  options.fit.temperature = Quantity{293, 0};
  options.fit.monte_carlo = 1000;
  options.fit.seed_given = true;
  options.fit.goal = "drag 1 %";
  options.fit.textbook = true;
  const CompareResult asked = compared(disc_recording(4, 20), options);
  ASSERT_EQ(plain.curves.size(), 3u);
  ASSERT_EQ(asked.curves.size(), 3u);
  EXPECT_EQ(asked.curves[0].rms, plain.curves[0].rms);
}

// Held for two seconds, then let go: --from says that all of it is to be compared.
TEST(CompareTask, BothCurvesAreOfTheSameSamples) {
  const Series free = disc_recording(4, 20);
  Series series = free;
  for (double& t : series.t) t += 2;
  series.t.insert(series.t.begin(), free.t.begin(), free.t.begin() + 200);
  series.y.insert(series.y.begin(), 200, free.y.front());
  series.lines.insert(series.lines.begin(), 200, 0);
  CompareOptions options;
  options.method = {"rk4"};
  options.fit.law = "viscous+drag";
  options.fit.from = 0;
  FitOptions viscous;
  viscous.law = "viscous";
  viscous.from = 0;
  const Result<FittedRecording> alone = fit_series(series, "recording2.csv", viscous);
  ASSERT_TRUE(alone.ok());
  const CompareResult result = compared(series, options);
  ASSERT_EQ(result.curves.size(), 3u);
  EXPECT_NEAR(result.curves[0].law_rms, alone->fit.residual.rms, 0.01 * alone->fit.residual.rms);
}

TEST(CompareTask, OneConstantRateEndsTenPerCentOff) {
  CompareOptions options;
  options.fit.segment = 30;
  options.fit.segments = 3;
  options.method = {"rk4"};
  const CompareResult result = compared(disc_recording(), options);
  ASSERT_EQ(result.curves.size(), 3u);
  const ComparedCurve &constant = result.curves[0], &law = result.curves[1];
  EXPECT_EQ(in_words(constant.label), "one constant decay rate");
  EXPECT_EQ(in_words(law.label), "viscous+drag");
  // exp(-0.00984 * 120) of the start over the closed form of the envelope with damping and drag: 0.904.
  EXPECT_NEAR(constant.amplitude_ratio_end, 0.904, 0.015);
  // Noise of 0.3 mm leaves 0.4 % in the end's amplitude (seen over many seeds).
  EXPECT_NEAR(law.amplitude_ratio_end, 1, 0.015);
  EXPECT_NEAR(law.phase_drift, 0, 0.01);
  EXPECT_NEAR(law.rms, 3e-4, 0.1e-4);  // the sensor's noise
  EXPECT_GT(constant.rms, 2 * law.rms);
  EXPECT_GT(law.r_squared, constant.r_squared);
  EXPECT_EQ(law.trajectory.size(), 12001u);
}

TEST(CompareTask, EveryMethodFollowsTheRecording) {
  const Series series = disc_recording(4, 20);
  for (const MethodInfo& info : method_infos) {
    CompareOptions options;
    options.fit.law = "viscous";
    options.method = {std::string(info.name)};
    options.step = 1e-3;
    const CompareResult result = compared(series, options);
    ASSERT_EQ(result.curves.size(), 3u) << info.name;
    // First-order methods that gain or lose energy are known to do so by w² h/2.
    const bool keeps_energy = info.order != 1 || info.symplectic;
    const double expected =
        keeps_energy ? 1 : std::exp((info.implicit ? -1 : 1) * 8.849 * 8.849 * 1e-3 / 2 * 20);
    EXPECT_NEAR(result.curves[2].amplitude_ratio_end, expected, 0.03 * expected) << info.name;
  }
}

TEST(CompareTask, PhaseDriftBeyondATurnIsNotFoldedBack) {
  // Euler-Cromer's own frequency, from the eigenvalues of its step at the recording's mean decay rate; its
  // velocity lags half a step.
  const Series series = disc_recording(4, 100);
  CompareOptions options;
  options.fit.law = "viscous+drag";
  options.step = 0.05;
  const CompareResult result = compared(series, options);
  const double w = std::sqrt(17.04 / 0.2176), h = 0.05, b = 0.0097;
  const double simulated = std::acos((1 - b * h - w * w * h * h / 2) / std::sqrt(1 - 2 * b * h)) / h;
  const double drift = (simulated - w) * 100 + w * h / 2;
  EXPECT_GT(drift, 6.3);
  EXPECT_NEAR(result.curves[2].phase_drift, drift, 0.05);
}

TEST(CompareTask, DefaultStepDividesTheSamplesAndThePeriod) {
  // 0.71 s / 200 = 3.55 ms: three steps a sample. A step that does not divide the sample spacing gives the
  // same to the interpolation's error.
  const Series series = disc_recording(4, 20);
  CompareOptions by_default, divided, odd;
  by_default.fit.law = divided.fit.law = odd.fit.law = "viscous";
  by_default.method = divided.method = odd.method = {"rk4"};
  divided.step = 0.01 / 3;
  odd.step = 0.0031;
  const CompareResult a = compared(series, by_default), b = compared(series, divided),
                      c = compared(series, odd);
  for (std::size_t i = 0; i < series.t.size(); ++i) {
    EXPECT_EQ(a.curves[2].trajectory.x[i], b.curves[2].trajectory.x[i]);
    EXPECT_NEAR(a.curves[2].trajectory.x[i], c.curves[2].trajectory.x[i], 2e-8);
  }
}

CompareOptions by_method(const char* method) {
  CompareOptions options;
  options.method = {method};
  return options;
}

TEST(CompareTask, SaysWhatItCannotDo) {
  const Series series = disc_recording(4, 20);
  const Result<FittedRecording> fit = fit_series(series, "f", {});
  ASSERT_TRUE(fit.ok());
  const auto message = [&](const CompareOptions& options) {
    const Result<CompareResult> result = compare_fitted(*fit, options);
    return result.ok() ? std::string("compared") : in_words(result.error());
  };
  EXPECT_THAT(message(by_method("euler-kromer")), HasSubstr("did you mean euler-cromer"));
  EXPECT_THAT(message(by_method("exact")), HasSubstr("no closed form with drag"));
  EXPECT_THAT(message({.step = 0}), HasSubstr("--step"));
  EXPECT_THAT(message({.step = 1e-12}), HasSubstr("--step"));

  for (const std::string quantity :
       {"velocity", "angular velocity", "acceleration", "angular acceleration"}) {
    Series derivative = series;
    derivative.quantity = quantity;
    const Result<FittedRecording> fitted = fit_series(derivative, "f", {});
    ASSERT_TRUE(fitted.ok()) << quantity;
    const Result<CompareResult> result = compare_fitted(*fitted, {});
    ASSERT_FALSE(result.ok()) << quantity;
    EXPECT_THAT(in_words(result.error()), HasSubstr("compare needs a position or an angle"));
  }
}

TEST(CompareTask, ARunThatDivergesIsAWarning) {
  const Series series = disc_recording(4, 60);
  CompareOptions options;
  options.fit.law = "viscous+drag";
  options.method = {"forward-euler"};
  options.step = 0.5;
  const CompareResult result = compared(series, options);
  ASSERT_EQ(result.curves.size(), 3u);
  EXPECT_TRUE(std::isnan(result.curves[2].rms));
  EXPECT_THAT(in_words(result.notices), testing::Contains(HasSubstr("not_finite")));
}

// A motion of one law, sampled 100 times a second with noise.
Series recording_of(const Motion& law, double duration, double noise, const char* quantity) {
  Series series;
  series.column = "x";
  series.quantity = quantity;
  series.rate = 100;
  for (int i = 0; i <= static_cast<int>(100 * duration); ++i) series.t.push_back(i / 100.0);
  std::mt19937_64 engine(11);
  std::normal_distribution<double> normal(0, noise);
  for (const double x : free_motion(law, series.t, 1e-3).x)
    series.y.push_back(law.equilibrium + x + normal(engine));
  series.lines.resize(series.t.size());
  return series;
}

TEST(CompareTask, SamplesThatFitSetsAsideCountNowhere) {
  Series series = disc_recording(4, 30);
  for (std::size_t i = 100; i < series.y.size(); i += 400)
    for (std::size_t k = i; k < i + 4; ++k) series.y[k] = 0;
  series.y[333] = 1;
  CompareOptions options;
  options.fit.law = "viscous+drag";
  options.method = {"rk4"};
  const CompareResult result = compared(series, options);
  ASSERT_EQ(result.curves.size(), 3u);
  EXPECT_NEAR(result.curves[2].rms, 3e-4, 0.2e-4);
  EXPECT_GT(result.curves[2].r_squared, 0.999);
  EXPECT_NEAR(result.curves[2].amplitude_ratio_end, 1, 0.01);
  EXPECT_THAT(in_words(result.notices), testing::Contains(HasSubstr("set aside")));
  EXPECT_EQ(result.curves[2].trajectory.size(), series.t.size());
}

TEST(CompareTask, SaysWhatTheMethodAddsToTheLaw) {
  // A third of the sample spacing: Euler-Cromer's own frequency is higher by (w h)²/24 and, at a decay rate
  // b, by b h/2; what it calls the position is half a step ahead. The mean of b is that of the envelope's
  // closed form.
  CompareOptions options;
  options.fit.law = "viscous+drag";
  const CompareResult result = compared(disc_recording(), options);
  ASSERT_EQ(result.curves.size(), 3u);
  const ComparedCurve& law = result.curves[2];
  const double w = std::sqrt(17.04 / 0.2176), h = 0.01 / 3;
  EXPECT_NEAR(law.step, h, 1e-12);
  EXPECT_NEAR(law.law_rms, 3e-4, 0.1e-4);
  EXPECT_GT(law.rms, 1.5 * law.law_rms);
  const double g = 0.000789 / (2 * 0.2176), q = 4 * 0.02043 * w / (3 * std::numbers::pi * 0.2176);
  const double shrunk = std::exp(-g * 120) / (1 + q * 0.036 / g * (1 - std::exp(-g * 120)));
  const double b = -std::log(shrunk) / 120;
  EXPECT_NEAR(law.method_phase, w * (w * w * h * h / 24 + b * h / 2) * 120 + w * h / 2, 5e-4);
  const std::string sentence = in_words(explanation(result));
  EXPECT_THAT(sentence, HasSubstr("with viscous+drag 30"));
  EXPECT_THAT(sentence, HasSubstr("Simulated by euler-cromer in steps of 0.00333"));
  EXPECT_THAT(sentence, HasSubstr("the method adds a phase of 0.069"));
}

TEST(CompareTask, EachMethodIsACurveBesideTheLawItself) {
  CompareOptions options;
  options.fit.law = "viscous+drag";
  options.method = {"forward-euler", "euler-cromer", "rk4"};
  options.step = 1e-3;
  const CompareResult all = compared(disc_recording(4, 20), options);
  ASSERT_EQ(all.curves.size(), 5u);
  EXPECT_EQ(all.curves[0].method, "exact");
  EXPECT_EQ(all.curves[1].method, "exact");
  for (std::size_t i = 0; i < options.method.size(); ++i) {
    EXPECT_EQ(all.curves[i + 2].method, options.method[i]);
    EXPECT_EQ(in_words(all.curves[i + 2].label), "viscous+drag by " + options.method[i]);
    EXPECT_EQ(all.curves[i + 2].law_rms, all.curves[1].rms);
    CompareOptions alone = options;
    alone.method = {options.method[i]};
    EXPECT_EQ(compared(disc_recording(4, 20), alone).curves[2].rms, all.curves[i + 2].rms);
  }
  // What is left without a method's error is what the fit leaves.
  EXPECT_NEAR(all.curves[1].rms, all.recording.fit.residual.rms, 1e-9);
  EXPECT_EQ(all.curves[1].method_amplitude_ratio, 1);
  EXPECT_EQ(all.curves[1].method_phase, 0);
  const std::string said = in_words(explanation(all));
  EXPECT_THAT(said, HasSubstr("Simulated by forward-euler in steps of 0.00100"));
  EXPECT_THAT(said, HasSubstr("Simulated by euler-cromer in steps of 0.00100"));
  EXPECT_THAT(said, testing::Not(HasSubstr("rk4")));  // adds nothing that shows
}

TEST(CompareTask, AStepTooLongForTheMethodLeavesTheVerdict) {
  CompareOptions options;
  options.fit.law = "viscous";
  options.step = 5;
  const CompareResult result = compared(disc_recording(4, 20), options);
  EXPECT_THAT(in_words(explanation(result)), HasSubstr("No other law was tried: with one rate"));
  ASSERT_EQ(result.curves.size(), 3u);
  EXPECT_TRUE(result.curves[2].diverged);
  EXPECT_THAT(in_words(explanation(result)), HasSubstr("the motion runs away"));
}

TEST(CompareTask, AMotionThatHasStoppedHasNoRatioAndNoPhase) {
  // The amplitude falls by 4 f/w² a cycle: it rests after 8 of them, 10 s.
  const TrueSwing cart{
      .angular_frequency = 5, .decay_rate = 0.01, .friction = 0.08, .equilibrium = 0, .position = 0.1};
  const Series series = recording_of(cart, 30, 3e-4, "position");
  CompareOptions options;
  options.fit.law = "viscous+friction";
  for (const char* method : {"rk4", "exact"}) {
    options.method = {method};
    const CompareResult result = compared(series, options);
    ASSERT_EQ(result.curves.size(), 3u);
    for (const ComparedCurve& curve : result.curves) {
      EXPECT_TRUE(curve.measured_at_rest);
      EXPECT_TRUE(std::isnan(curve.amplitude_ratio_end));
      EXPECT_TRUE(std::isnan(curve.phase_drift));
    }
    EXPECT_TRUE(result.curves[2].at_rest);
    EXPECT_NEAR(result.curves[2].rms, 3e-4, 0.2e-4);
    EXPECT_THAT(in_words(explanation(result)), HasSubstr("swings where the measured motion has died down"));
  }
}

TEST(CompareTask, APendulumIsSimulatedAsOne) {
  const TrueSwing pendulum{.angular_frequency = 3, .decay_rate = 0.02, .position = 1.5, .pendulum = true};
  CompareOptions options;
  options.fit.law = "viscous+pendulum";
  options.method = {"rk4"};
  const CompareResult result = compared(recording_of(pendulum, 60, 0.005, "angle"), options);
  ASSERT_EQ(result.curves.size(), 3u) << in_words(result.recording.fit.message);
  EXPECT_EQ(in_words(result.curves[1].label), "viscous+pendulum");
  EXPECT_EQ(in_words(result.curves[2].label), "viscous+pendulum by rk4");
  EXPECT_NEAR(result.curves[2].rms, 0.005, 0.0003);
  EXPECT_NEAR(result.curves[2].amplitude_ratio_end, 1, 0.01);
  EXPECT_NEAR(result.curves[0].rms, 0.005, 0.0003);  // one rate, and the law's own frequency
}

// The rates of segments are those of an amplitude, which a bent spring changes.
TEST(CompareTask, SegmentsSayNothingOfTheRateOfABentSpring) {
  const TrueSwing pendulum{.angular_frequency = 3, .decay_rate = 0.03, .position = 2, .pendulum = true};
  CompareOptions options;
  options.fit.segment = 10;
  options.method = {"rk4"};
  const CompareResult result = compared(recording_of(pendulum, 60, 0.005, "angle"), options);
  ASSERT_EQ(result.curves.size(), 3u) << in_words(result.recording.fit.message);
  EXPECT_NEAR(result.curves[0].rms, 0.005, 0.0005);
  EXPECT_THAT(in_words(explanation(result)), HasSubstr("Viscous damping alone is enough"));
}

TEST(CompareTask, ProgressNeverGoesBack) {
  std::string file = "Time (s),Position (m),Run 2: Position (m)\n";
  const Series series = disc_recording(4, 20);
  for (std::size_t i = 0; i < series.t.size(); ++i)
    file += std::to_string(series.t[i]) + "," + std::to_string(series.y[i]) + "," +
            std::to_string(series.y[i]) + "\n";
  CompareOptions options;
  options.fit.law = "auto";
  options.fit.column = "Position";
  double furthest = 0;
  bool back = false;
  const Watch watch{nullptr, [&](double fraction) {
                      back = back || fraction < furthest - 1e-9;
                      furthest = std::max(furthest, fraction);
                    }};
  const auto result = compare(file, "two.csv", options, watch);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  EXPECT_FALSE(back);
  EXPECT_NEAR(furthest, 1, 1e-9);
}

TEST(CompareTask, WhatIsSaidOfAFileStaysWhereItsFirstRunCannotBeCompared) {
  std::string file = "Time (s),Position (m),Run 2: Position (m)\n";
  const Series series = disc_recording(4, 20);
  std::mt19937 noise(1);
  for (std::size_t i = 0; i < series.t.size(); ++i)
    file += std::to_string(series.t[i]) + "," + std::to_string(std::normal_distribution(0.0, 0.01)(noise)) +
            "," + std::to_string(series.y[i]) + "\n" + (i == 100 ? "no number,0,0\n" : "");
  CompareOptions options;
  options.fit.column = "Position";
  options.fit.law = "viscous";
  options.fit.read.skip_bad_rows = true;
  const auto result = compare(file, "two.csv", options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  ASSERT_EQ(result->size(), 2u);
  EXPECT_EQ(result->at(0).curves.size(), 0u);
  EXPECT_EQ(result->at(0).recording.of_file, 2u);
  EXPECT_THAT(in_words(result->at(0).notices),
              testing::ElementsAre(HasSubstr("1 bad row left out"), HasSubstr("is called")));
  EXPECT_EQ(result->at(1).curves.size(), 3u);
  EXPECT_THAT(in_words(result->at(1).notices), testing::Not(testing::Contains(HasSubstr("left out"))));
}

TEST(CompareTask, WhatIsSaidOfAFileIsSaidOnceOfDrivenRuns) {
  std::string file = "Time (s),Position (m),Run 2: Position (m)\n";
  std::mt19937 noise(1);
  const auto position = [&](double t, double phase) {
    return 0.02 * std::cos(7 * t + phase) + 0.03 * std::exp(-0.05 * t) * std::cos(9 * t) +
           std::normal_distribution(0.0, 1e-4)(noise);
  };
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.02 * i;
    file += std::to_string(t) + "," + std::to_string(position(t, 0.3)) + "," +
            std::to_string(position(t, 1.1)) + "\n" + (i == 100 ? "no number,0,0\n" : "");
  }
  CompareOptions options;
  options.fit.column = "Position";
  options.fit.read.skip_bad_rows = true;
  const auto result = compare(file, "two.csv", options);
  ASSERT_TRUE(result.ok()) << in_words(result.error());
  ASSERT_EQ(result->size(), 2u);
  for (const CompareResult& each : *result)
    EXPECT_THAT(in_words(each.doubts), testing::Contains(HasSubstr("driven")));
  EXPECT_THAT(in_words(result->at(0).notices), testing::Contains(HasSubstr("1 bad row left out")));
  EXPECT_THAT(in_words(result->at(1).notices), testing::Not(testing::Contains(HasSubstr("left out"))));
}

TEST(CompareTask, WhatFitDoubtsIsNoVerdict) {
  Series series = disc_recording(4, 30);
  for (std::size_t i = 0; i < series.t.size(); ++i) series.y[i] += 0.002 * series.t[i];
  const CompareResult result = compared(series, by_method("rk4"));
  EXPECT_THAT(in_words(result.notices), testing::Contains(HasSubstr("the zero drifts, by 0.0599 m")));
  EXPECT_THAT(in_words(explanation(result)), HasSubstr("No verdict on the damping"));
  EXPECT_THAT(in_words(explanation(result)), testing::Not(HasSubstr("enough")));
}

/// Interrupts a comparison at its n-th look at the watch; returns what is there of it.
Result<CompareResult> interrupted_at(int n, const FittedRecording& fit, const CompareOptions& options) {
  std::atomic<bool> interrupt{false};
  int looks = 0;
  Watch watch{.interrupt = &interrupt};
  watch.pulse = [&] { interrupt = ++looks >= n; };
  return compare_fitted(fit, options, watch);
}

TEST(CompareTask, AnInterruptLeavesWhatIsThere) {
  CompareOptions options;
  options.method = {"rk4", "euler-cromer"};
  options.fit.law = "viscous+drag";
  const auto fit = fit_series(disc_recording(4, 20), "recording2.csv", options.fit);
  ASSERT_TRUE(fit);
  const auto early = interrupted_at(1, *fit, options);
  ASSERT_TRUE(early) << in_words(early.error());
  EXPECT_FALSE(early->complete);
  EXPECT_TRUE(early->curves.empty());
  EXPECT_EQ(in_words(early->notices.back()), "interrupted before anything was simulated");
  // Sooner or later it falls into the first run, then into the second one, then behind both.
  std::vector<std::size_t> ended;
  for (int n = 2; ended.size() < 2; ++n) {
    const auto late = interrupted_at(n, *fit, options);
    ASSERT_TRUE(late);
    if (late->complete) break;
    if (late->curves.empty()) continue;
    ASSERT_EQ(late->curves.size(), 4u);
    const bool first = !late->curves[2].complete;
    if (first) {
      EXPECT_FALSE(late->curves[3].complete);
    }
    const ComparedCurve& curve = late->curves[first ? 2 : 3];
    EXPECT_FALSE(curve.diverged);
    EXPECT_TRUE(std::isnan(curve.rms));
    EXPECT_LT(curve.trajectory.size(), late->recording.series.t.size());
    EXPECT_THAT(in_words(late->notices.back()),
                testing::ContainsRegex("viscous.drag: interrupted at [0-9.]+ s"));
    if (ended.empty() || ended.back() != (first ? 2u : 3u)) ended.push_back(first ? 2 : 3);
  }
  EXPECT_THAT(ended, testing::ElementsAre(2, 3));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
