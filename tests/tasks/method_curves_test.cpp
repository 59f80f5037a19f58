// Curves that only studies draw: their limits, refusals and defaults.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/curves/local_error.h"
#include "cromer/tasks/curves/method_map.h"
#include "cromer/tasks/curves/resonance.h"
#include "cromer/tasks/curves/work_precision.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;
using testing::IsEmpty;

ResonanceOptions driven() {
  ResonanceOptions options;
  options.simulate.damping = 0.5;
  options.simulate.drive_amplitude = 1;
  options.simulate.method = {"exact"};
  return options;
}

std::string refused(const ResonanceOptions& options) {
  const auto curves = resonance(options);
  return curves ? "" : in_words(curves.error());
}

TEST(ResonanceCurves, GoFromEndToEnd) {
  ResonanceOptions options = driven();
  options.points = 2;
  EXPECT_THAT(resonance(options)->curves.at(0).frequency, ElementsAre(0.1, 10));
  options.frequency_from = 1;
  options.frequency_to = 2;
  options.points = 5;
  const ResonanceCurve curve = resonance(options)->curves.at(0);
  EXPECT_THAT(curve.frequency, ElementsAre(1, 1.25, 1.5, 1.75, 2));
  EXPECT_EQ(curve.method, "exact");
  EXPECT_DOUBLE_EQ(curve.damping_ratio, 0.25);
  EXPECT_THAT(in_words(resonance(options)->notices), IsEmpty());
  EXPECT_EQ(resonance(driven())->curves.at(0).frequency.size(), 200u);
}

TEST(ResonanceCurves, SayHowFarTheyAre) {
  ResonanceOptions options = driven();
  options.simulate.damping.reset();
  options.damping_ratio = {0.1, 0.2};
  options.simulate.method = {"exact", "exact"};
  options.points = 3;
  std::vector<double> shares;
  ASSERT_TRUE(resonance(options, {nullptr, [&](double share) { shares.push_back(share); }}));
  EXPECT_THAT(shares, ElementsAre(0, 0.125, 0.25, 0.25, 0.375, 0.5, 0.5, 0.625, 0.75, 0.75, 0.875, 1));
  const std::atomic<bool> stop{true};
  EXPECT_EQ(in_words(resonance(options, {&stop, {}}).error()), "interrupted");
}

TEST(ResonanceCurves, RefuseWordForWord) {
  ResonanceOptions options = driven();
  options.frequency_from = 0;
  EXPECT_EQ(refused(options), "--frequency-from: it must be positive");
  options = driven();
  options.frequency_to = options.frequency_from;
  EXPECT_EQ(refused(options), "--frequency-to: it must be above --frequency-from");
  options = driven();
  options.points = 1;
  EXPECT_EQ(refused(options), "--points: at least 2");
  options = driven();
  options.simulate.drive_amplitude = 0;
  EXPECT_EQ(refused(options), "--drive-amplitude: a resonance curve needs a force");
  options = driven();
  options.simulate.law.drag = 1;
  options.simulate.method = {"rk4"};
  EXPECT_EQ(refused(options), "--drag: this resonance curve is for the linear law only");
  options = driven();
  options.simulate.damping = 0;
  EXPECT_EQ(refused(options),
            "--damping: without damping no transient dies down, and there is no steady amplitude");
  options = driven();
  options.simulate.stiffness = 0;
  EXPECT_EQ(refused(options), "--stiffness: without a spring there is no resonance");
  const std::string twice =
      "--damping-ratios: the damping is set by --damping, --damping-ratio or --quality-factor already; give "
      "one of "
      "them";
  for (int which = 0; which < 3; ++which) {
    options = driven();
    options.damping_ratio = {0.1};
    options.simulate.damping.reset();
    EXPECT_EQ(refused(options), "");
    if (which == 0) options.simulate.damping = 1;
    if (which == 1) options.simulate.damping_ratio = 1;
    if (which == 2) options.simulate.quality_factor = 1;
    EXPECT_EQ(refused(options), twice) << which;
  }
}

TEST(ResonanceCurves, AMethodSettlesWhereverTheSlowPartOfAnOverdampedLawHasDied) {
  // zeta = 5: the slow rate is w/(5 + sqrt(24)), a tenth of the natural one.
  ResonanceOptions options = driven();
  options.simulate.damping = 10;
  options.simulate.method = {"exact", "rk4"};
  options.frequency_from = 0.5;
  options.frequency_to = 1.5;
  options.points = 2;
  const auto curves = resonance(options)->curves;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(curves.at(1).amplitude[i] / curves.at(0).amplitude[i], 1, 1e-5);
    EXPECT_NEAR(curves.at(1).phase[i], curves.at(0).phase[i], 1e-5);
    EXPECT_NEAR(curves.at(1).transmitted[i] / curves.at(0).transmitted[i], 1, 1e-5);
  }
}

TEST(MethodMaps, GoFromEndToEndInEvenRatios) {
  MethodMapOptions options;
  EXPECT_EQ(method_map(options)->curves.at(0).wh.size(), 200u);
  EXPECT_DOUBLE_EQ(method_map(options)->curves.at(0).wh.back(), 2.5);
  options.from = 0.25;
  options.to = 4;
  options.points = 3;
  options.simulate.stiffness = 4;
  options.simulate.method = {"exact", "rk4"};
  const auto map = method_map(options);
  ASSERT_EQ(map->curves.size(), 2u);
  EXPECT_THAT(map->curves[0].wh, ElementsAre(0.25, 1, 4));
  EXPECT_EQ(map->curves[0].order, 0);
  EXPECT_EQ(map->curves[1].order, 4);
  EXPECT_EQ(map->natural_frequency, 2);
  // Beyond sqrt 8 the method grows: its energy goes up.
  EXPECT_GT(map->curves[1].at[2].energy_factor, 1);
  EXPECT_EQ(map->curves[0].at[2].energy_factor, 1);
}

TEST(MethodMaps, RefuseWordForWord) {
  const auto refusal = [](const MethodMapOptions& options) {
    const auto map = method_map(options);
    return map ? "" : in_words(map.error());
  };
  MethodMapOptions options;
  options.from = 0;
  EXPECT_EQ(refusal(options), "--from: it must be positive");
  options.from = options.to;
  EXPECT_EQ(refusal(options), "--to: it must be above --from");
  options = {};
  options.points = 1;
  EXPECT_EQ(refusal(options), "--points: at least 2");
  options = {};
  options.simulate.law.drag = 1;
  EXPECT_EQ(refusal(options), "--drag: only a linear law has one frequency and one decay rate");
  options = {};
  options.simulate.damping = 2;
  EXPECT_EQ(refusal(options), "--damping: this law does not oscillate");
  options.simulate.damping = 1.999;
  EXPECT_EQ(refusal(options), "");
}

TEST(LocalErrorCurves, BeginAnEighthOfAPeriodOnAndHalveTheirSteps) {
  LocalErrorOptions options;
  options.simulate.stiffness = 4 * M_PI * M_PI;
  options.simulate.method = {"verlet", "euler-cromer"};
  const auto errors = local_errors(options);
  ASSERT_TRUE(errors);
  const std::vector<double>& h = errors->curves.at(0).h;
  ASSERT_EQ(h.size(), 11u);
  EXPECT_DOUBLE_EQ(h.back(), 1.0 / 20);
  EXPECT_DOUBLE_EQ(h.front(), 1.0 / 20480);
  EXPECT_EQ(errors->curves.at(1).method, "euler-cromer");
  // x = cos u at u = pi/4: Euler-Cromer's x is wrong by h^2/2 x'', its v by h^2/2 x''' at first order.
  EXPECT_NEAR(errors->curves[1].x_over_predicted, 1, 2e-3);
  EXPECT_NEAR(errors->curves[1].v_over_predicted, 1, 2e-3);
  EXPECT_NEAR(errors->curves[1].x_error.front() / (h.front() * h.front() / 2 * 4 * M_PI * M_PI * M_SQRT1_2),
              1, 2e-3);
}

TEST(LocalErrorCurves, RefuseWordForWord) {
  const auto refusal = [](const SimulateOptions& simulate) {
    LocalErrorOptions options;
    options.simulate = simulate;
    const auto errors = local_errors(options);
    return errors ? "" : in_words(errors.error());
  };
  EXPECT_EQ(refusal({.drive = "step", .drive_amplitude = 1}),
            "--drive: the error of a step is measured on a smooth motion, free or under a harmonic drive");
  EXPECT_EQ(refusal({.law = {.drag = 1}}),
            "--drag: the error of a step is measured against the closed form, and this law has none");
  EXPECT_EQ(refusal({.stiffness = 0, .step = 1, .until = 1}),
            "--stiffness: the steps are parts of a natural period, and this law has none");
  EXPECT_EQ(refusal({.drive_amplitude = 1, .drive_frequency = {2}}), "");
}

TEST(WorkPrecisionCurves, HalveTheStepAndSayHowFarTheyAre) {
  WorkPrecisionOptions options;
  options.simulate.until = 20;
  options.simulate.method = {"verlet", "rk4"};
  options.longest = 1.0 / (2 * M_PI);  // a second
  options.halvings = 2;
  std::vector<double> shares;
  const auto work = work_precision(options, {nullptr, [&](double share) { shares.push_back(share); }});
  ASSERT_TRUE(work);
  EXPECT_THAT(shares, ElementsAre(0, 0.25, 0.5, 0.5, 0.75, 1));
  EXPECT_THAT(work->curves.at(1).evaluations, ElementsAre(80, 160, 320));
  EXPECT_EQ(work->curves.at(0).method, "verlet");
  const std::atomic<bool> stop{true};
  EXPECT_EQ(in_words(work_precision(options, {&stop, {}}).error()), "interrupted");
}

TEST(WorkPrecisionCurves, RefuseWordForWord) {
  const auto refusal = [](double longest, long long halvings) {
    WorkPrecisionOptions options;
    options.longest = longest;
    options.halvings = halvings;
    options.simulate.until = 0.25;
    options.simulate.method = {"exact"};
    const auto work = work_precision(options);
    return work ? "" : in_words(work.error());
  };
  EXPECT_EQ(refusal(0, 1), "--longest: it must be positive");
  EXPECT_EQ(refusal(0.1, 0), "--halvings: 1 to 30");
  EXPECT_EQ(refusal(0.1, 31), "--halvings: 1 to 30");
  EXPECT_EQ(refusal(0.1, 1), "");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
