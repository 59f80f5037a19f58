// A. K. Chopra, Dynamics of Structures, examples 5.2 to 5.4: the half-sine pulse by central difference,
// average and linear acceleration, to the digits printed.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "cromer/methods/newmark.h"
#include "cromer/model/general_drive.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double last_digits = 2e-4;  // two units of the last digit

/// The rows of the table; empty where it is not there.
std::vector<std::vector<double>> table() {
  std::ifstream file(CROMER_SOURCE_DIR "/../shared/data/tables/chopra_sdof_halfsine.csv");
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 't') continue;
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

const Oscillator<double> frame{.mass = 0.2533, .stiffness = 10, .damping = 0.1592};

double pulse(double t) { return t < 0.65 ? 10 * std::sin(std::numbers::pi * t / 0.6) : 0; }

Trajectory run_by(const Newmark& method) {
  std::vector<double> samples;
  for (int i = 0; i <= 11; ++i) samples.push_back(pulse(i * 0.1));
  const SampledDrive drive{std::make_shared<const std::vector<double>>(samples), 0.1, BetweenSamples::linear};
  const Interval interval{0, 1.1};
  KeepEvery keep(1, count_steps(interval, 0.1));
  with_terms(frame, GeneralDrive<double>(drive), [&](const auto& system) {
    return solve(system, method, interval, State<double>{0, 0}, 0.1, keep);
  });
  return keep.take();
}

class Chopra : public ::testing::Test {
 protected:
  void SetUp() override {
    rows = table();
    if (rows.empty()) GTEST_SKIP() << "no ../shared/data";
    ASSERT_EQ(rows.size(), 11u);
  }

  /// Displacement, velocity and acceleration from this column of the table on.
  void compare(const Trajectory& y, std::size_t column) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_NEAR(y.x[i], rows[i][column], last_digits) << i;
      EXPECT_NEAR(y.v[i], velocity(column, i), last_digits) << i;
      const double a =
          (pulse(static_cast<double>(i) * 0.1) - frame.damping * y.v[i] - frame.stiffness * y.x[i]) /
          frame.mass;
      EXPECT_NEAR(a, rows[i][column + 2], last_digits) << i;
    }
  }

  /// Three velocities are misprints.
  double velocity(std::size_t column, std::size_t i) const {
    if (column == 4 && i == 4) return 4.7260;
    if (column == 4 && i == 7) return -6.8182;
    if (column == 7 && i == 5) return 2.1082;
    return rows[i][column + 1];
  }

  std::vector<std::vector<double>> rows;
};

TEST_F(Chopra, CentralDifference) {
  const Trajectory y = run_by({.newton = {}, .beta = 0, .gamma = 0.5});
  // Printed one step ahead.
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_NEAR(y.x[i + 1], rows[i][3], last_digits) << i;
}

TEST_F(Chopra, AverageAcceleration) { compare(run_by({.newton = {}, .beta = 0.25, .gamma = 0.5}), 4); }

TEST_F(Chopra, LinearAcceleration) { compare(run_by({.newton = {}, .beta = 1.0 / 6, .gamma = 0.5}), 7); }

}  // namespace CROMER_FILE
}  // namespace cromer::core
