#include "cromer/analysis/growth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cromer/analysis/local_error.h"
#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace {

const Oscillator<double> spring{.mass = 0.2, .stiffness = 16.6};
const double w = std::sqrt(16.6 / 0.2);

template <class M>
Trajectory free_motion(const M& method, const Oscillator<double>& o, double h) {
  KeepEvery keep(1, count_steps({0, 20}, h));
  with_terms(o, HarmonicDrive<double>{}, [&](const auto& system) {
    return solve(system, method, {0, 20}, State<double>{0.05, 0}, h, keep);
  });
  return keep.take();
}

TEST(Energy, ByHand) {
  EXPECT_DOUBLE_EQ(energy(Oscillator<double>{.mass = 2, .stiffness = 3, .cubic = 4}, State<double>{-1, 3}),
                   9 + 1.5 + 1);
}

TEST(EnergyGrowth, OfForwardEulerIsKnown) {
  // Each step multiplies the energy by exactly 1 + (w h)^2.
  const double h = 0.002;
  const auto growth = energy_growth(spring, free_motion(ForwardEuler{}, spring, h));
  const double rate = std::log1p(w * w * h * h) / h, period = 2 * std::numbers::pi / w;
  EXPECT_NEAR(growth.rate, rate, 1e-9 * rate);
  EXPECT_NEAR(growth.factor_per_cycle(period), std::exp(rate * period), 1e-9);
  EXPECT_NEAR(growth.doubling_time(), std::numbers::ln2 / rate, 1e-8);
}

TEST(EnergyGrowth, OfTheExactMotion) {
  EXPECT_NEAR(energy_growth(spring, free_motion(Exact{}, spring, 0.01)).rate, 0, 1e-15);
  // Decays with c/m; the swing within a cycle leaves a trace of its size over the number of cycles.
  const Oscillator<double> damped{.mass = 0.2, .stiffness = 16.6, .damping = 0.02};
  EXPECT_NEAR(energy_growth(damped, free_motion(Exact{}, damped, 0.01)).rate, -0.1, 1e-4);
}

TEST(LocalError, OfForwardEulerIsTheMissingTaylorTerm) {
  const DrivenOscillator<double, Terms{}> system({1, 9, 0, 0, 0, 0}, {});
  const State<double> y{0.4, 1.1};
  const std::vector<double> steps{1e-3, 5e-4, 2.5e-4, 1.25e-4};
  const LocalError error = local_error(system, ForwardEuler{}, 0, y, steps);
  EXPECT_NEAR(error.position_slope, 2, 0.01);
  EXPECT_NEAR(error.velocity_slope, 2, 0.01);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double half = steps[i] * steps[i] / 2;
    EXPECT_NEAR(error.position[i] / half, 9 * 0.4, 20 * steps[i]) << "h^2/2 a is missing in x";
    EXPECT_NEAR(error.velocity[i] / half, 9 * 1.1, 20 * steps[i]) << "h^2/2 da/dt is missing in v";
  }
}

TEST(LocalError, HasTheOrderOfEveryMethod) {
  const DrivenOscillator<double, Terms{.drive = true, .law = law_of("viscous")}> system({1, 9, 0.4, 0, 0, 0},
                                                                               {1, 2, 0.3});
  for_each_method({.newton = {.tolerance = 1e-15}}, [&](const auto& method) {
    if (method.info.order == 0) return;
    const double h = method.info.order >= 4 ? 0.02 : 1e-3;
    const LocalError error =
        local_error(system, method, 0.3, {0.4, 1.1}, std::vector<double>{h, h / 2, h / 4});
    // The acceleration that generalized-alpha carries belongs to a shifted time. Its first step begins with
    // the state's own and misses a term of second order; once only, so that the run keeps its order.
    using M = std::decay_t<decltype(method)>;
    constexpr bool carries = CarriesAcceleration<M, typename M::template Memory<double>>;
    EXPECT_NEAR(std::min(error.position_slope, error.velocity_slope), method.info.order + (carries ? 0 : 1),
                0.1)
        << method.info.name;
  });
}

TEST(FitLine, ThroughPointsOnALine) {
  const std::vector<double> x{1e9, 1e9 + 1, 1e9 + 3}, y{2, 2.5, 3.5};
  EXPECT_NEAR(fit_line(x, y).slope, 0.5, 1e-14);
}

TEST(FitLine, IsThatOfLeastSquares) {
  // About (3, 3.4): Sxx = 10, Sxy = 8.
  const Line line = fit_line(std::vector<double>{1, 2, 3, 4, 5}, std::vector<double>{2, 2, 4, 4, 5});
  EXPECT_NEAR(line.slope, 0.8, 1e-15);
  EXPECT_NEAR(line.intercept, 1, 1e-14);
  const Line two = fit_line(std::vector<double>{-1, 3}, std::vector<double>{5, -3});
  EXPECT_NEAR(two.slope, -2, 1e-15);
  EXPECT_NEAR(two.intercept, 3, 1e-15);
}

}  // namespace
}  // namespace cromer::core
