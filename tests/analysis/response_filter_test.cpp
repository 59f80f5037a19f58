// The exact recurrence and its filter, against the closed form of the model and against each other.
#include "cromer/analysis/response_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "cromer/model/sampled_drive.h"

namespace cromer::core {
namespace CROMER_FILE {

std::vector<double> noise(std::size_t n) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> samples(n);
  for (double& sample : samples) sample = normal(random);
  return samples;
}

LinearLaw<double> law_of(double wh, double damping_ratio, double h) {
  const double w = wh / h;
  return {.decay_rate = damping_ratio * w, .stiffness = w * w};
}

TEST(IntervalMap, IsTheModelsOwnMotion) {
  const double h = 0.02;
  for (const double wh : {1e-4, 0.01, 0.3, 2.0, 40.0})
    for (const double damping_ratio : {0.0, 0.05, 1.0, 3.0})
      for (const bool hold : {false, true}) {
        const LinearLaw<double> law = law_of(wh, damping_ratio, h);
        const IntervalMap<double> map = interval_map(law, h, hold);
        const State<double> y0{0.3, -2}, y = map(y0, 1.5, -0.7);
        const State<double> exact = propagate_ramp(law, 1.5, hold ? 0 : -2.2 / h, h, y0);
        EXPECT_NEAR(y.x, exact.x, 1e-15) << wh << " " << damping_ratio;
        EXPECT_NEAR(y.v, exact.v, 1e-14 * (1 + law.stiffness * h)) << wh << " " << damping_ratio;
      }
}

TEST(ResponseFilter, WalksAsTheMapDoes) {
  const double h = 0.01;
  const auto force = noise(3000);
  for (const double wh : {0.01, 0.1, 0.62})
    for (const double damping_ratio : {0.0, 0.05, 1.0, 2.0})
      for (const bool hold : {false, true}) {
        const LinearLaw<double> law = law_of(wh, damping_ratio, h);
        const IntervalMap<double> map = interval_map(law, h, hold);
        for (const ResponseQuantity<double> quantity :
             {ResponseQuantity<double>{1, 0}, ResponseQuantity<double>{law.stiffness, 2 * law.decay_rate}}) {
          const ResponseFilter<double> filter = response_filter(map, quantity);
          const FilterToMotion<double> to_motion = filter_to_motion(map);
          FilterState<double> state = at_rest(map, force[0]);
          State<double> y{0, 0};
          double most = 0, off = 0, off_motion = 0;
          for (std::size_t n = 1; n < force.size(); ++n) {
            y = map(y, force[n - 1], force[n]);
            const State<double> arrived = to_motion.next(state, map, force[n]);
            const double q = filter.gain * filter.step(state, force[n]);
            const double expected = quantity.x * y.x + quantity.v * y.v;
            most = std::max(most, std::abs(expected));
            off = std::max(off, std::abs(q - expected));
            off_motion =
                std::max(off_motion, std::hypot(arrived.x - y.x, (arrived.v - y.v) * h / wh) * quantity.x);
          }
          EXPECT_LT(off, 2e-12 * most) << wh << " " << damping_ratio << " " << hold;
          EXPECT_LT(off_motion, 2e-12 * most) << wh << " " << damping_ratio << " " << hold;
        }
      }
}

// Long periods: the map's own coefficients are rounded near 1, and a walk with them turns at another
// frequency. In one stride over many samples it does not; the filter is held to that.
TEST(ResponseFilter, KeepsItsDigitsAtLongPeriods) {
  const double h = 0.005;
  const std::size_t n = 16384;
  const LinearLaw<double> law = law_of(3e-4, 0.05, h);  // 105 s
  const ResponseFilter<double> filter = response_filter(interval_map(law, h, false), {1, 0});
  const IntervalMap<double> whole = interval_map(law, h * static_cast<double>(n), false);
  FilterState<double> state = at_rest(interval_map(law, h, false), 1.0);
  double q = 0;
  for (std::size_t i = 1; i <= n; ++i)
    q = filter.gain * filter.step(state, 1 - 3 * static_cast<double>(i) / static_cast<double>(n));
  EXPECT_NEAR(q / whole({0, 0}, 1, -2).x, 1, 1e-11);
}

// A. K. Chopra, Dynamics of Structures, example 5.1: interpolation of the excitation.
TEST(IntervalMap, MeetsChopra) {
  std::ifstream file(CROMER_SOURCE_DIR "/../shared/data/tables/chopra_sdof_halfsine.csv");
  if (!file) GTEST_SKIP() << "no ../shared/data";
  const double mass = 0.2533;
  const LinearLaw<double> law{.decay_rate = 0.1592 / (2 * mass), .stiffness = 10 / mass};
  const IntervalMap<double> map = interval_map(law, 0.1, false);
  const auto pulse = [&](int i) { return i < 6 ? 10 * std::sin(std::numbers::pi * i / 6) / mass : 0; };
  State<double> y{0, 0};
  int row = 0;
  for (std::string line; std::getline(file, line);) {
    if (line[0] == '#' || line[0] == 't') continue;
    std::istringstream cells(line);
    std::string cell;
    for (int column = 0; column < 3; ++column) std::getline(cells, cell, ',');
    EXPECT_NEAR(y.x, std::stod(cell), 2e-4) << row;
    y = map(y, pulse(row), pulse(row + 1));
    ++row;
  }
  EXPECT_EQ(row, 11);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
