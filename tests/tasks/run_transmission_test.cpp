#include "cromer/tasks/simulate/run_transmission.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/analysis/steady_state.h"
#include "cromer/methods/all.h"
#include "cromer/tasks/simulate/simulate.h"
#include "tests/support/simulated.h"

namespace cromer::core {
namespace {

/// What arrives, measured on the last cycles of a run.
MeasuredSteadyState measured(const SimulatedRun& run, double base) {
  Trajectory arriving = run.trajectory;
  for (std::size_t i = 0; i < arriving.size(); ++i) {
    const double t = arriving.t[i], x = run.trajectory.x[i], v = run.trajectory.v[i];
    arriving.x[i] = base > 0 ? x + base * std::cos(run.drive.frequency * t + run.drive.phase)
                             : run.oscillator.stiffness * x + run.oscillator.damping * v;
  }
  return measure_steady_state(arriving, run.drive).value();
}

SimulateOptions mount(double w) {
  SimulateOptions options{.mass = 3, .natural_frequency = 6.0, .damping_ratio = 0.15};
  options.drive_frequency = {w};
  options.step = 0.02;
  options.until = 60;
  for (const MethodInfo& info : method_infos)
    if (info.name != "forward-euler") options.method.emplace_back(info.name);
  return options;
}

/// Every method but forward Euler, which grows, for long: the steady state it is said to have is the one its
/// run gets to, and near the exact one.
void check(const SimulateOptions& options, double sent) {
  for (const SimulatedRun& run : simulated(options).runs) {
    ASSERT_TRUE(run.transmission) << run.method;
    const RunTransmission& found = *run.transmission;
    const bool base = options.base_displacement.has_value();
    EXPECT_EQ(found.of_motion, base);
    EXPECT_NEAR(found.sent / sent, 1, 1e-14);
    const double r = options.drive_frequency[0] / 6, damper = 2 * 0.15 * r;
    EXPECT_NEAR(found.frequency_ratio, r, 1e-15);
    EXPECT_NEAR(found.exact.amplitude, std::hypot(1, damper) / std::hypot(1 - r * r, damper), 1e-13);
    const auto last = measured(run, options.base_displacement.value_or(0));
    if (run.method == "dormand-prince") {
      EXPECT_FALSE(found.simulated) << "it chooses its own steps";
      EXPECT_NEAR(last.amplitude / sent, found.exact.amplitude, 1e-5);
      continue;
    }
    ASSERT_TRUE(found.simulated) << run.method;
    EXPECT_NEAR(last.amplitude / sent / found.simulated->amplitude, 1, 1e-9) << run.method;
    EXPECT_NEAR(last.phase_lag, found.simulated->phase_lag, 1e-9) << run.method;
    // The test tells methods apart: those of first order are off by far more than it allows.
    if (find_method(run.method)->order >= 4) {
      EXPECT_LT(std::abs(*found.error()), 1e-3) << run.method;
    }
    if (run.method == "implicit-euler") {
      EXPECT_GT(std::abs(*found.error()), 1e-3);
    }
  }
}

TEST(RunTransmission, IsWhatALongRunPassesOn) {
  for (const double w : {3.0, 6.0, 12.0}) {
    auto force = mount(w);
    force.drive_amplitude = 5;
    force.drive_phase = 0.4;
    check(force, 5);
    auto unbalance = mount(w);
    unbalance.drive = "unbalance";
    unbalance.unbalance_mass = 0.2;
    unbalance.eccentricity = 0.05;
    check(unbalance, 0.2 * 0.05 * w * w);
    auto base = mount(w);
    base.drive = "base";
    base.base_displacement = 0.003;
    base.drive_phase = 0.4;
    check(base, 0.003);
  }
}

TEST(RunTransmission, ThereIsNoneWhereNothingSettlesOrShakes) {
  SimulateOptions options{.natural_frequency = 3.0};
  options.until = 1;
  EXPECT_FALSE(simulated(options).runs[0].transmission) << "nothing drives";
  options.drive_amplitude = 1;
  options.drive_frequency = {3};
  options.method = {"exact", "forward-euler", "implicit-euler"};
  options.step = 0.01;
  const auto undamped = simulated(options);
  EXPECT_FALSE(undamped.runs[0].transmission->bounded());
  EXPECT_FALSE(undamped.runs[0].transmission->simulated);
  EXPECT_FALSE(undamped.runs[1].transmission->simulated) << "it grows";
  // Implicit Euler damps by itself: it settles where the law does not, and is off by more than any
  // percentage.
  EXPECT_TRUE(undamped.runs[2].transmission->simulated);
  EXPECT_FALSE(undamped.runs[2].transmission->error());
  options.method = {"rk4"};
  options.law.drag = 0.1;
  EXPECT_FALSE(simulated(options).runs[0].transmission) << "not linear";
  options.law.drag = 0;
  options.drive_frequency = {0};
  EXPECT_FALSE(simulated(options).runs[0].transmission) << "a constant force";
}

}  // namespace
}  // namespace cromer::core
