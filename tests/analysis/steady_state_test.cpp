#include "cromer/analysis/steady_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"
#include "tests/support/problems.h"

namespace cromer {
namespace {

TEST(FrequencyResponse, MeetsThePublishedValues) {
  const auto truth_file = problems::read("steady_state.json");
  ASSERT_EQ(truth_file.size(), 18u);
  for (const auto& entry : truth_file) {
    const Oscillator<double> oscillator{.mass = problems::number(entry, "m"),
                                        .stiffness = problems::number(entry, "k"),
                                        .damping = problems::number(entry, "c")};
    const auto response =
        frequency_response(oscillator, problems::number(entry, "F"), problems::number(entry, "w"));
    EXPECT_NEAR(response.amplitude / problems::number(entry, "amplitude"), 1, 1e-13) << entry;
    EXPECT_NEAR(response.phase_lag / problems::number(entry, "phase_lag"), 1, 1e-13) << entry;
  }
}

TEST(FrequencyResponse, IsLargestAtTheResonanceFrequency) {
  const Oscillator<double> oscillator{.mass = 2, .stiffness = 18, .damping = 1.7};
  const double w = resonance_frequency(oscillator);
  const double peak = frequency_response(oscillator, 1, w).amplitude;
  EXPECT_GT(peak, frequency_response(oscillator, 1, w * 1.001).amplitude);
  EXPECT_GT(peak, frequency_response(oscillator, 1, w * 0.999).amplitude);
  EXPECT_EQ(resonance_frequency({.mass = 1, .stiffness = 1, .damping = 2}), 0);
}

Trajectory driven(const Oscillator<double>& o, const HarmonicDrive<double>& d, double until) {
  const Interval interval{0, until};
  KeepEvery keep(1, count_steps(interval, 0.01));
  with_terms(o, d, [&](const auto& system) {
    return solve(system, Exact{}, interval, State<double>{0, 0}, 0.01, keep);
  });
  return keep.take();
}

TEST(MeasuredSteadyState, FindsTheExactResponse) {
  const Oscillator<double> o{.mass = 1, .stiffness = 9, .damping = 0.5};
  for (const double w : {0.4, 2.9, 3.0, 7.3}) {
    const HarmonicDrive<double> d{.amplitude = 2, .frequency = w, .phase = 0.7};
    const auto measured = measure_steady_state(driven(o, d, 400), d);
    ASSERT_TRUE(measured.ok());
    const auto exact = frequency_response(o, 2, w);
    EXPECT_NEAR(measured->amplitude / exact.amplitude, 1, 1e-10) << w;
    EXPECT_NEAR(measured->phase_lag, exact.phase_lag, 1e-10) << w;
    EXPECT_NEAR(measured->mean, 0, 1e-10);
    EXPECT_LT(measured->residual, 1e-10);
    EXPECT_TRUE(measured->settled());
    EXPECT_EQ(measured->cycles, 10);
  }
}

TEST(MeasuredSteadyState, SaysThatAMotionHasNotSettled) {
  const HarmonicDrive<double> d{.amplitude = 1, .frequency = 3};
  const auto measured = measure_steady_state(driven({.mass = 1, .stiffness = 9}, d, 80), d);
  ASSERT_TRUE(measured.ok());
  EXPECT_FALSE(measured->settled()) << "undamped resonance grows without end";
  EXPECT_GT(measured->change, 0.05);
}

TEST(MeasuredSteadyState, UsesFewerCyclesWhereThereAreFewer) {
  const HarmonicDrive<double> d{.amplitude = 1, .frequency = 2 * std::numbers::pi / 10};
  const auto measured = measure_steady_state(driven({.mass = 1, .stiffness = 9, .damping = 6}, d, 55), d);
  ASSERT_TRUE(measured.ok());
  EXPECT_EQ(measured->cycles, 4);
  EXPECT_NEAR(measured->amplitude,
              frequency_response({.mass = 1, .stiffness = 9, .damping = 6}, 1, d.frequency).amplitude, 1e-9);
}

TEST(MeasuredSteadyState, LeavesOutAStateAfterAShorterStep) {
  const Oscillator<double> o{.mass = 1, .stiffness = 9, .damping = 1};
  const HarmonicDrive<double> d{.amplitude = 1, .frequency = 3};
  const auto settled_by = [&](double until) {
    const Interval interval{0, until};
    KeepEvery keep(1, count_steps(interval, 0.2));
    with_terms(o, d, [&](const auto& system) {
      return solve(system, ImplicitEuler{}, interval, State<double>{0, 0}, 0.2, keep);
    });
    return measure_steady_state(keep.take(), d);
  };
  const auto whole = settled_by(80), cut = settled_by(80.05);
  EXPECT_NEAR(cut->amplitude / whole->amplitude, 1, 1e-12);
  EXPECT_LT(cut->residual, 1e-12);
  EXPECT_TRUE(cut->settled());
}

TEST(MeasuredSteadyState, RefusesWhatCannotBeMeasured) {
  const HarmonicDrive<double> d{.amplitude = 1, .frequency = 0.1};
  const auto trajectory = driven({.mass = 1, .stiffness = 9, .damping = 1}, d, 100);
  EXPECT_FALSE(measure_steady_state(trajectory, d).ok()) << "1.6 periods";
  EXPECT_FALSE(measure_steady_state(trajectory, {}).ok()) << "no drive";
  EXPECT_FALSE(measure_steady_state({}, d).ok()) << "no states";
}

}  // namespace
}  // namespace cromer
