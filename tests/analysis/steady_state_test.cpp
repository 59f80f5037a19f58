#include "cromer/analysis/steady_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"
#include "tests/support/problems.h"

namespace cromer::core {
namespace CROMER_FILE {

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

// 66.67 samples a cycle: where in them a window begins and ends changes from cycle to cycle.
TEST(MeasuredSteadyState, OvertonesDoNotLeakIn) {
  const HarmonicDrive<double> drive{1, 0.3};
  for (const double until : {1000.0, 1021.0, 1042.0, 1063.0}) {
    Trajectory motion;
    for (double t = 0; t < until; t += 2 * std::numbers::pi / 0.3 / (200.0 / 3)) {
      motion.t.push_back(t);
      motion.x.push_back(0.2 + std::cos(0.3 * t - 1) + 0.2 * std::cos(0.9 * t) + 0.1 * std::cos(0.6 * t + 2));
    }
    for (const int cycles : {2, 8}) {
      const auto measured = measure_steady_state(motion, drive, cycles);
      ASSERT_TRUE(measured);
      EXPECT_NEAR(measured->amplitude, 1, cycles == 2 ? 1.5e-4 : 2e-6) << until;
      EXPECT_NEAR(measured->phase_lag, 1, cycles == 2 ? 1.5e-4 : 2e-6) << until;
    }
  }
}

TEST(MeasuredSteadyState, IsSettledWhereNeitherAmplitudeNorRestChanges) {
  const auto settled = [](double change, double growth) {
    return MeasuredSteadyState{.change = change, .growth = growth}.settled();
  };
  for (const double change : {-0.9e-3, 0.0, 0.9e-3}) {
    EXPECT_TRUE(settled(change, 0.9e-3));
    EXPECT_TRUE(settled(change, -1));
    EXPECT_FALSE(settled(change, 1.1e-3));
  }
  for (const double change : {-1.1e-3, 1.1e-3})
    for (const double growth : {-1.0, 0.0, 1.1e-3}) EXPECT_FALSE(settled(change, growth));
}

TEST(MeasuredSteadyState, WhatGrowsBesideTheDriveIsNotSettled) {
  const auto driven_beside = [](double rate) {
    Trajectory motion;
    for (double t = 0; t < 300; t += 0.05) {
      motion.t.push_back(t);
      motion.x.push_back(std::cos(2 * t) + 0.01 * std::exp(rate * (t - 300)) * std::cos(3.3 * t));
    }
    return *measure_steady_state(motion, {1, 2});
  };
  EXPECT_FALSE(driven_beside(0.02).settled());
  EXPECT_GT(driven_beside(0.02).growth, 1e-3);
  EXPECT_NEAR(driven_beside(0).growth, 0, 1e-4);
  EXPECT_TRUE(driven_beside(0).settled());
  EXPECT_LT(driven_beside(-0.02).growth, 0);
  EXPECT_TRUE(driven_beside(-0.02).settled());
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

/// x = mean + amplitude cos(u - lag), u = 2 t + 0.4, so many states a period from 5 s on.
Trajectory sinusoid(double mean, double amplitude, double lag, int per_period, int states) {
  Trajectory kept;
  for (int i = 0; i < states; ++i) {
    kept.t.push_back(5 + std::numbers::pi / per_period * i);
    kept.x.push_back(mean + amplitude * std::cos(2 * kept.t.back() + 0.4 - lag));
    kept.v.push_back(0);
  }
  return kept;
}
const HarmonicDrive<double> by_two{.amplitude = 1, .frequency = 2, .phase = 0.4};

TEST(MeasuredSteadyState, OfASinusoidIsThatSinusoid) {
  for (const double lag : {-1.5, -0.3, 0.0, 1.0, 3.0, 3.5, 4.6}) {
    const auto found = measure_steady_state(sinusoid(0.7, 3, lag, 8, 100), by_two);
    ASSERT_TRUE(found.ok());
    EXPECT_NEAR(found->amplitude, 3, 1e-13);
    EXPECT_NEAR(found->phase_lag, lag, 1e-13);
    EXPECT_NEAR(found->mean, 0.7, 1e-13);
    EXPECT_NEAR(found->residual, 0, 1e-13);
    EXPECT_NEAR(found->change, 0, 1e-13);
  }
}

TEST(MeasuredSteadyState, OvertonesAreTheResidual) {
  Trajectory kept = sinusoid(0.7, 3, 1, 16, 161);
  for (std::size_t i = 0; i < kept.size(); ++i) kept.x[i] += 0.2 * std::cos(3 * 2 * kept.t[i]);
  for (const int cycles : {10, 4}) {
    const auto found = measure_steady_state(kept, by_two, cycles);
    EXPECT_NEAR(found->residual, 0.2 / std::sqrt(2), 2e-3) << cycles;
    EXPECT_NEAR(found->amplitude, 3, 1e-2) << cycles;
  }
}

TEST(MeasuredSteadyState, TheChangeIsFromTheFirstHalfOfTheWindowToTheSecond) {
  // 8 periods of 3 m, then 2 of 4 m, of which the last 4 are looked at.
  Trajectory kept = sinusoid(0, 3, 1, 64, 641);
  for (std::size_t i = 513; i < kept.size(); ++i) kept.x[i] *= 4.0 / 3;
  const auto found = measure_steady_state(kept, by_two, 4);
  ASSERT_TRUE(found.ok());
  EXPECT_EQ(found->cycles, 4);
  EXPECT_NEAR(found->change, 0.25, 1e-2);
  EXPECT_NEAR(found->amplitude, 3.5, 2e-2);
  EXPECT_FALSE(found->settled());
  EXPECT_EQ(measure_steady_state(sinusoid(0, 0, 0, 8, 100), by_two)->change, 0) << "nothing moves";
}

TEST(MeasuredSteadyState, SettlesAtAPartInAThousand) {
  const auto settled = [](double change) { return MeasuredSteadyState{.change = change}.settled(); };
  EXPECT_FALSE(settled(1e-3));
  EXPECT_FALSE(settled(-1e-3));
  EXPECT_TRUE(settled(std::nextafter(1e-3, 0)));
  EXPECT_TRUE(settled(std::nextafter(-1e-3, 0)));
}

TEST(MeasuredSteadyState, TheWindowIsAnEvenNumberOfPeriodsTwoAtLeast) {
  const auto cycles = [](int wanted, int states) {
    const auto found = measure_steady_state(sinusoid(0, 1, 1, 8, states), by_two, wanted);
    return found.ok() ? found->cycles : 0;
  };
  EXPECT_EQ(cycles(10, 81), 10);
  EXPECT_EQ(cycles(10, 80), 8) << "a state short of ten periods";
  EXPECT_EQ(cycles(5, 81), 4);
  EXPECT_EQ(cycles(4, 81), 4);
  EXPECT_EQ(cycles(1, 81), 2);
  EXPECT_EQ(cycles(3, 81), 2);
  EXPECT_EQ(cycles(10, 17), 2);
  EXPECT_EQ(cycles(10, 16), 0);
}

TEST(MeasuredSteadyState, NeedsFourStatesAPeriodAndEightInAll) {
  const auto measures = [](int per_period, int states) {
    return measure_steady_state(sinusoid(0, 1, 1, per_period, states), by_two, 2).ok();
  };
  EXPECT_TRUE(measures(4, 50));
  EXPECT_FALSE(measures(3, 50));
  // In a window of two periods that both its ends belong to.
  EXPECT_TRUE(measures(4, 9));
  Trajectory seven = sinusoid(0, 1, 1, 4, 50);
  seven.t = {5, 6, 7, 8, 9, 10, 13};
  seven.x.resize(7);
  seven.v.resize(7);
  EXPECT_FALSE(measure_steady_state(seven, by_two, 2).ok());
}

TEST(MeasuredSteadyState, EightStatesOverTwoPeriodsAreEnough) {
  Trajectory eight;
  for (int i = 0; i < 8; ++i) {
    eight.t.push_back(5 + 2 * std::numbers::pi / 7 * i);
    eight.x.push_back(0.7 + 3 * std::cos(2 * eight.t.back() + 0.4 - 1.2));
    eight.v.push_back(0);
  }
  const auto found = measure_steady_state(eight, by_two);
  ASSERT_TRUE(found.ok());
  EXPECT_NEAR(found->amplitude, 3, 1e-12);
  EXPECT_NEAR(found->phase_lag, 1.2, 1e-12);
  EXPECT_NEAR(found->mean, 0.7, 1e-12);
  EXPECT_NEAR(found->residual, 0, 1e-12);
  EXPECT_NEAR(found->change, 0, 1e-12);
  EXPECT_NEAR(found->growth, 0, 1e-12);
  EXPECT_EQ(found->cycles, 2);
}

TEST(MeasuredSteadyState, OfWhatDoesNotPushThereIsNone) {
  const Trajectory kept = sinusoid(0, 1, 1, 8, 100);
  EXPECT_FALSE(measure_steady_state(kept, {.amplitude = 0, .frequency = 2}).ok());
  EXPECT_FALSE(measure_steady_state(kept, {.amplitude = 1, .frequency = 0}).ok());
  EXPECT_FALSE(measure_steady_state(kept, {.amplitude = 1, .frequency = -2}).ok());
  EXPECT_TRUE(measure_steady_state(kept, {.amplitude = -1, .frequency = 2}).ok());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
