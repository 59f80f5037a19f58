// Units of a recorded motion, whatever unit the column was written in.
#include "cromer/tasks/fit/fitted_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cromer/base/concat.h"
#include "cromer/tasks/simulate/simulate.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

/// Of a file whose second column is so named.
MotionUnits units_of(std::string_view column) {
  const auto recording = read_recording(concat({"Time (s),", column, "\n0,1\n1,2\n2,1\n"}), "lab.csv", {});
  EXPECT_TRUE(recording.ok());
  FittedRecording fitted;
  auto series = take_series(*recording, "", 1, {});
  EXPECT_TRUE(series.ok());
  fitted.series = std::move(*series);
  return motion_units(fitted);
}

void expect(std::string_view column, const MotionUnits& units) {
  const MotionUnits found = units_of(column);
  EXPECT_EQ(found.measured, units.measured) << column;
  EXPECT_EQ(found.displacement, units.displacement) << column;
  EXPECT_EQ(found.velocity, units.velocity) << column;
  EXPECT_EQ(found.energy, units.energy) << column;
}

TEST(MotionUnits, AreThoseOfTheDisplacementBehindTheColumn) {
  for (const char* column : {"Position (mm)", "x (in)", "x (m)", "x"})
    expect(column, {"m", "m", "m/s", "J/kg"});
  for (const char* column : {"Velocity (cm/s)", "Velocity (in/s)"})
    expect(column, {"m/s", "m", "m/s", "J/kg"});
  for (const char* column : {"Acceleration (g)", "Acceleration (m/s^2)", "Acceleration"})
    expect(column, {"m/s²", "m", "m/s", "J/kg"});
  for (const char* column : {"Angle (deg)", "Angle (°)"})
    expect(column, {"rad", "rad", "rad/s", "J/(kg m²)"});
  expect("Gyroscope x (deg/s)", {"rad/s", "rad", "rad/s", "J/(kg m²)"});
}

TEST(MotionUnits, AreThoseOfTheColumnWhereItIsNoMotion) {
  expect("Voltage (mV)", {"V", "V", "V/s", ""});
  expect("Position (px)", {"px", "px", "px/s", ""});
}

TEST(MotionUnits, HaveNoNameWhereTheSiUnitHasNone) { expect("Pressure (kPa)", {"", "", "", ""}); }

TEST(MotionUnits, HaveAnEnergyWithAMass) {
  FittedRecording fitted;
  fitted.series.quantity = "position";
  fitted.parameters.push_back({"stiffness", {}, "N/m"});
  EXPECT_EQ(motion_units(fitted).energy, "J");
}

// Two thirds of a turn to each side: far from a sinusoid, and a fifth slower than a small swing.
TEST(FittedMotion, TheVelocityOfAWidePendulumIsItsOwn) {
  SimulateOptions options;
  options.law.pendulum = 9;
  options.stiffness = 0;
  options.position = 2;
  options.damping = 0.02;
  options.method = {"rk4"};
  options.step = 0.01;
  options.until = 40;
  const auto run = simulate(options);
  ASSERT_TRUE(run.ok());
  const Trajectory& truth = run->runs[0].trajectory;
  std::string file = "Time (s),Angle (rad)\n";
  for (std::size_t i = 0; i < truth.size(); ++i)
    file += std::to_string(truth.t[i]) + "," + std::to_string(truth.x[i]) + "\n";
  for (const char* law : {"viscous+pendulum", "viscous+cubic"}) {
    FitOptions fit_options;
    fit_options.law = law;
    const auto fits = fit(file, "pendulum.csv", fit_options);
    ASSERT_TRUE(fits.ok() && fits->front().succeeded()) << law;
    const FittedMotion motion = fitted_motion(fits->front());
    int n = 0;
    for (std::size_t i = 0; i < motion.t.size(); ++i) {
      if (std::isnan(motion.local_velocity[i])) continue;
      EXPECT_NEAR(motion.local_velocity[i], truth.v[i], 0.02 * 5) << law << motion.t[i];
      ++n;
    }
    EXPECT_GT(n, 3000) << law;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
