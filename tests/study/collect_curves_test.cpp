// The named results of resonance curves, methods and spectra: every number of handmade ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/study/collected.h"

namespace cromer::core {
namespace CROMER_FILE {

using testing::ElementsAre;

TEST(CollectResonance, NamesThePeakOfEachColumn) {
  ResonanceCurve first{.method = "exact", .damping_ratio = 0.1};
  first.frequency = {1, 2, 3};
  first.frequency_ratio = {0.5, 1, 1.5};
  first.amplitude = {nothing, 4, 6};
  first.phase = {0.1, 0.2, 0.3};
  first.amplification = {7, 8, 9};
  first.transmissibility = {1, 5, 2};
  first.transmitted_phase = {0.4, 0.5, 0.6};
  first.transmitted = {3, 1, nothing};
  ResonanceCurve second = first;
  second.method = "rk4";
  second.amplitude = {6, 6, 5};
  second.transmitted = {1, 9, 2};
  ResonanceResult all{.of_motion = false, .curves = {first, second}, .notices = {}};
  Results results;
  collect("r", all, results);
  EXPECT_EQ(fact(results, "r.points"), "3");
  EXPECT_EQ(fact(results, "r.1.label"), "exact");
  EXPECT_EQ(fact(results, "r.2.label"), "rk4");
  EXPECT_EQ(fact(results, "r.1.damping_ratio"), "0.1");
  EXPECT_EQ(fact(results, "r.1.peak"), "6 m");
  EXPECT_EQ(fact(results, "r.1.peak_frequency"), "3 rad/s");
  EXPECT_EQ(fact(results, "r.2.peak_frequency"), "1 rad/s");
  EXPECT_EQ(fact(results, "r.1.peak_transmissibility"), "5");
  EXPECT_EQ(fact(results, "r.1.peak_transmissibility_ratio"), "1");
  EXPECT_EQ(fact(results, "r.1.last_transmissibility"), "2");
  EXPECT_EQ(fact(results, "r.1.peak_transmitted"), "3 N");
  EXPECT_EQ(fact(results, "r.2.peak_transmitted"), "9 N");
  EXPECT_EQ(fact(results, "r.2.last_transmitted"), "2 N");
  EXPECT_THAT(column(results, "r.2.amplitude").values, ElementsAre(6, 6, 5));
  EXPECT_THAT(column(results, "r.1.transmitted_phase").values, ElementsAre(0.4, 0.5, 0.6));
  EXPECT_EQ(column(results, "r.1.transmitted").name, "force on the ground");
  all.of_motion = true;
  collect("r", all, results);
  EXPECT_EQ(fact(results, "r.2.last_transmitted"), "2 m");
  EXPECT_EQ(column(results, "r.1.transmitted").name, "amplitude of the mass");
}

TEST(CollectLocalError, HasACurveForEachMethod) {
  LocalErrorCurve first{.method = "verlet", .h = {1, 2}, .x_error = {3, 4}, .v_error = {5, 6}};
  first.x_slope = 7;
  first.v_slope = 8;
  first.x_over_predicted = 9;
  first.v_over_predicted = 10;
  LocalErrorCurve second = first;
  second.method = "rk4";
  Results results;
  collect("e", LocalErrorResult{{first, second}}, results);
  EXPECT_EQ(fact(results, "e.1.label") + fact(results, "e.2.label"), "verletrk4");
  EXPECT_EQ(fact(results, "e.2.x_slope"), "7");
  EXPECT_EQ(fact(results, "e.2.v_slope"), "8");
  EXPECT_EQ(fact(results, "e.2.x_over_predicted"), "9");
  EXPECT_EQ(fact(results, "e.2.v_over_predicted"), "10");
  EXPECT_THAT(column(results, "e.1.h").values, ElementsAre(1, 2));
  EXPECT_THAT(column(results, "e.1.x_error").values, ElementsAre(3, 4));
  EXPECT_THAT(column(results, "e.1.v_error").values, ElementsAre(5, 6));
}

TEST(CollectMethodMap, SaysOrderAndLimitOrThatThereIsNone) {
  MethodMapCurve exact{
      .method = "exact", .wh = {0.1, 0.2}, .at = {{1, 2, 3, 4}, {5, 6, 7, 8}}, .at_a_tenth = {9, 10, 11, 12}};
  MethodMapCurve rk4 = exact;
  rk4.method = "rk4";
  rk4.order = 1;
  rk4.stable_up_to = 2.5;
  Results results;
  collect("m", MethodMapResult{6, 0.5, {exact, rk4}}, results);
  EXPECT_EQ(fact(results, "m.natural_frequency"), "6 rad/s");
  EXPECT_EQ(fact(results, "m.decay_rate"), "0.5 1/s");
  EXPECT_EQ(fact(results, "m.1.order"), "–");
  EXPECT_EQ(fact(results, "m.2.order"), "1");
  EXPECT_EQ(fact(results, "m.1.stable_up_to"), "any");
  EXPECT_EQ(fact(results, "m.2.stable_up_to"), "2.5");
  EXPECT_EQ(fact(results, "m.2.label"), "rk4");
  EXPECT_EQ(fact(results, "m.2.at_a_tenth.decay_rate"), "9 1/s");
  EXPECT_EQ(fact(results, "m.2.at_a_tenth.frequency_error"), "10");
  EXPECT_EQ(fact(results, "m.2.at_a_tenth.energy_factor"), "12");
  EXPECT_THAT(column(results, "m.2.wh").values, ElementsAre(0.1, 0.2));
  EXPECT_THAT(column(results, "m.2.decay_rate").values, ElementsAre(1, 5));
  EXPECT_THAT(column(results, "m.2.frequency_error").values, ElementsAre(2, 6));
  EXPECT_THAT(column(results, "m.2.decay_error").values, ElementsAre(3, 7));
}

TEST(CollectWorkPrecision, FindsTheWorkForAMillionth) {
  // Linear between the logarithms: 1e-6 is midway between 1e-5 and 1e-7, and 200 between 100 and 400.
  const WorkPrecisionCurve crosses{"a", {10, 100, 400, 1600}, {1e-3, 1e-5, 1e-7, 1e-9}, 2};
  const WorkPrecisionCurve meets{"b", {10, 100, 300}, {1e-3, 1e-6, 1e-7}, 3};
  const WorkPrecisionCurve never{"c", {10, 100}, {1e-3, 1e-5}, 4};
  const WorkPrecisionCurve twice{"d", {10, 100, 400, 500, 600}, {1e-4, 1e-5, 1e-7, 1e-5, 1e-6}, 5};
  const WorkPrecisionCurve rises{"e", {5, 100, 400}, {1e-7, 1e-5, 1e-7}, 6};
  const WorkPrecisionCurve all_below{"f", {5, 10}, {1e-6, 1e-7}, 7};
  Results results;
  collect("w", WorkPrecisionResult{{crosses, meets, never, twice, rises, all_below}}, results);
  EXPECT_NEAR(value(results, "w.5.evaluations_for_a_millionth"), 200, 1e-9);
  EXPECT_TRUE(std::isnan(value(results, "w.6.evaluations_for_a_millionth")));
  EXPECT_NEAR(value(results, "w.1.evaluations_for_a_millionth"), 200, 1e-9);
  EXPECT_NEAR(value(results, "w.2.evaluations_for_a_millionth"), 100, 1e-9);
  EXPECT_TRUE(std::isnan(value(results, "w.3.evaluations_for_a_millionth")));
  EXPECT_NEAR(value(results, "w.4.evaluations_for_a_millionth"), 200, 1e-9);
  EXPECT_EQ(fact(results, "w.3.label"), "c");
  EXPECT_EQ(fact(results, "w.3.slope"), "4");
  EXPECT_THAT(column(results, "w.2.evaluations").values, ElementsAre(10, 100, 300));
  EXPECT_THAT(column(results, "w.2.error").values, ElementsAre(1e-3, 1e-6, 1e-7));
}

SpectrumResult spectra() {
  SpectrumResult all;
  all.periods = {2, 1, 0.5};
  all.components.resize(1);
  all.components[0].peak = 3;
  all.components[0].intensity = {.arias = 4, .duration = 5};
  ResponseSpectrum one{.damping_ratio = 0.05, .displacement = {{2, 1, 0.125}}};
  all.spectra = {one, one};
  all.spectra[1].damping_ratio = 0.1;
  return all;
}

TEST(CollectSpectrum, TurnsDisplacementsIntoAccelerations) {
  const double w2 = 4 * std::numbers::pi * std::numbers::pi;
  Results results;
  collect("s", spectra(), results);
  EXPECT_EQ(fact(results, "s.peak_acceleration"), "3 m/s²");
  EXPECT_EQ(fact(results, "s.arias_intensity"), "4 m/s");
  EXPECT_EQ(fact(results, "s.duration_5_95"), "5 s");
  EXPECT_EQ(fact(results, "s.1.damping_ratio"), "0.05");
  EXPECT_EQ(fact(results, "s.2.damping_ratio"), "0.1");
  EXPECT_EQ(fact(results, "s.2.loss_factor"), "none");
  EXPECT_THAT(column(results, "s.2.period").values, ElementsAre(2, 1, 0.5));
  EXPECT_THAT(column(results, "s.2.frequency").values, ElementsAre(0.5, 1, 2));
  EXPECT_THAT(column(results, "s.1.SD").values, ElementsAre(2, 1, 0.125));
  EXPECT_NEAR(column(results, "s.1.PSV").values[1], 2 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(column(results, "s.1.PSA").values[2], w2 / 2, 1e-12);
  EXPECT_NEAR(value(results, "s.1.peak"), w2, 1e-12);
  EXPECT_EQ(fact(results, "s.1.peak_period"), "1 s");
}

TEST(CollectSpectrum, OfTwoComponentsTheMedianRotationIsTheMainOne) {
  SpectrumResult all = spectra();
  all.options.loss_factor = {"0.1"};
  all.spectra.resize(1);
  ResponseSpectrum& both = all.spectra[0];
  both.displacement.push_back({4, 4, 4});
  both.geometric_mean = {5, 5, 5};
  both.rotd50 = {64, 2, 2};
  both.rotd100 = {7, 7, 7};
  Results results;
  collect("s", all, results);
  EXPECT_EQ(fact(results, "s.1.loss_factor"), "0.05");
  EXPECT_THAT(column(results, "s.1.SD_1").values, ElementsAre(2, 1, 0.125));
  EXPECT_THAT(column(results, "s.1.SD_2").values, ElementsAre(4, 4, 4));
  EXPECT_THAT(column(results, "s.1.SD_geometric_mean").values, ElementsAre(5, 5, 5));
  EXPECT_THAT(column(results, "s.1.SD_RotD100").values, ElementsAre(7, 7, 7));
  EXPECT_THAT(column(results, "s.1.SD").values, ElementsAre(64, 2, 2));
  EXPECT_EQ(fact(results, "s.1.peak_period"), "2 s");
}

TEST(CollectSpectrum, OfAShockHasItsFourAccelerations) {
  SpectrumResult all = spectra();
  all.spectra.resize(1);
  all.spectra[0].shock = {{1, 2, 3, 4}, {5, 6, 9, 8}, {9, 10, 7, 8}};
  Results results;
  collect("s", all, results);
  EXPECT_THAT(column(results, "s.1.primary").values, ElementsAre(1, 5, 9));
  EXPECT_THAT(column(results, "s.1.residual").values, ElementsAre(2, 6, 10));
  EXPECT_THAT(column(results, "s.1.positive").values, ElementsAre(3, 9, 7));
  EXPECT_THAT(column(results, "s.1.negative").values, ElementsAre(4, 8, 8));
  EXPECT_THAT(column(results, "s.1.maximax").values, ElementsAre(4, 9, 8));
  EXPECT_EQ(fact(results, "s.1.peak"), "9 m/s²");
  EXPECT_EQ(fact(results, "s.1.peak_period"), "1 s");
  EXPECT_FALSE(results.column("s.1.SD"));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
