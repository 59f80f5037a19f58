#include "cromer/study/task/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/methods/all.h"
#include "tests/study/task/disc_recording.h"

namespace cromer {
namespace {

using testing::HasSubstr;

CompareResult compared(const Series& series, const CompareOptions& options) {
  const Result<FittedRecording> fit = fit_series(series, "recording2.csv", options.fit);
  EXPECT_TRUE(fit.ok());
  Result<CompareResult> result = compare_fitted(*fit, options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message);
  return result.ok() ? *result : CompareResult{};
}

TEST(CompareTask, ExplainsTheMisfitInASentence) {
  CompareOptions options;
  options.fit.segment = 30;
  options.fit.segments = 3;
  options.method = "rk4";
  const std::string drag = explanation(compared(disc_recording(), options));
  EXPECT_THAT(drag, HasSubstr("One decay rate is not enough. It falls from 0.014"));
  EXPECT_THAT(drag, HasSubstr("% too small, with viscous+drag 0.00030"));
  options.fit.goal = "drag 1 %";  // not of the constant rate beside it
  EXPECT_EQ(explanation(compared(disc_recording(), options)), drag);
  options.fit = FitOptions{};
  options.fit.law = "viscous";
  EXPECT_THAT(explanation(compared(disc_recording(), options)),
              HasSubstr("One decay rate is enough: with one"));
  EXPECT_EQ(explanation(CompareResult{}), "");
}

TEST(CompareTask, OneConstantRateEndsTenPerCentOff) {
  CompareOptions options;
  options.fit.segment = 30;
  options.fit.segments = 3;
  options.method = "rk4";
  const CompareResult result = compared(disc_recording(), options);
  ASSERT_EQ(result.curves.size(), 2u);
  const ComparedCurve &constant = result.curves[0], &law = result.curves[1];
  EXPECT_EQ(constant.label, "one constant decay rate");
  EXPECT_EQ(law.label, "viscous+drag");
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
    options.method = info.name;
    options.step = 1e-3;
    const CompareResult result = compared(series, options);
    ASSERT_EQ(result.curves.size(), 2u) << info.name;
    // First-order methods that gain or lose energy are known to do so by w² h/2.
    const bool keeps_energy = info.order != 1 || info.symplectic;
    const double expected =
        keeps_energy ? 1 : std::exp((info.implicit ? -1 : 1) * 8.849 * 8.849 * 1e-3 / 2 * 20);
    EXPECT_NEAR(result.curves[1].amplitude_ratio_end, expected, 0.03 * expected) << info.name;
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
  EXPECT_NEAR(result.curves[1].phase_drift, drift, 0.05);
}

TEST(CompareTask, DefaultStepDividesTheSamplesAndThePeriod) {
  // 0.71 s / 200 = 3.55 ms: three steps a sample. A step that does not divide the sample spacing gives the
  // same to the interpolation's error.
  const Series series = disc_recording(4, 20);
  CompareOptions by_default, divided, odd;
  by_default.fit.law = divided.fit.law = odd.fit.law = "viscous";
  by_default.method = divided.method = odd.method = "rk4";
  divided.step = 0.01 / 3;
  odd.step = 0.0031;
  const CompareResult a = compared(series, by_default), b = compared(series, divided),
                      c = compared(series, odd);
  for (std::size_t i = 0; i < series.t.size(); ++i) {
    EXPECT_EQ(a.curves[1].trajectory.x[i], b.curves[1].trajectory.x[i]);
    EXPECT_NEAR(a.curves[1].trajectory.x[i], c.curves[1].trajectory.x[i], 2e-8);
  }
}

CompareOptions by_method(const char* method) {
  CompareOptions options;
  options.method = method;
  return options;
}

TEST(CompareTask, SaysWhatItCannotDo) {
  const Series series = disc_recording(4, 20);
  const Result<FittedRecording> fit = fit_series(series, "f", {});
  ASSERT_TRUE(fit.ok());
  const auto message = [&](const CompareOptions& options) {
    const Result<CompareResult> result = compare_fitted(*fit, options);
    return result.ok() ? std::string("compared") : result.error().message;
  };
  EXPECT_THAT(message(by_method("euler-kromer")), HasSubstr("did you mean euler-cromer"));
  EXPECT_THAT(message(by_method("exact")), HasSubstr("no closed form with drag"));
  EXPECT_THAT(message({.step = 0}), HasSubstr("--step"));
  EXPECT_THAT(message({.step = 1e-12}), HasSubstr("--step"));
}

TEST(CompareTask, ARunThatDivergesIsAWarning) {
  const Series series = disc_recording(4, 60);
  CompareOptions options;
  options.fit.law = "viscous+drag";
  options.method = "forward-euler";
  options.step = 0.5;
  const CompareResult result = compared(series, options);
  ASSERT_EQ(result.curves.size(), 2u);
  EXPECT_TRUE(std::isnan(result.curves[1].rms));
  EXPECT_THAT(result.warnings, testing::Contains(HasSubstr("not_finite")));
}

}  // namespace
}  // namespace cromer
