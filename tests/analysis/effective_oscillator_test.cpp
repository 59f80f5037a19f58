#include "cromer/analysis/effective_oscillator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/analysis/frequency_response.h"
#include "cromer/methods/all.h"
#include "cromer/run/solve.h"
#include "tests/support/every_method.h"
#include "tests/support/problems.h"

namespace cromer::core {
namespace CROMER_FILE {

LinearLaw<double> linear(double w0, double zeta) { return {.decay_rate = zeta * w0, .stiffness = w0 * w0}; }

EffectiveOscillator effective(std::string_view name, const LinearLaw<double>& law, double h) {
  return visit_method(name, {}, [&](const auto& method) { return effective_oscillator(method, law, h); });
}

std::optional<double> limit(std::string_view name, double w0, double zeta) {
  return visit_method(name, {},
                      [&](const auto& method) { return stability_limit(method, linear(w0, zeta)); });
}

TEST(EffectiveOscillator, MeetsThePublishedValues) {
  int oscillating = 0, others = 0;
  for (const auto& entry : problems::read("effective.json")) {
    const auto name = entry.at("method").get<std::string>();
    ASSERT_NE(find_method(name), nullptr) << name;
    const double w0 = problems::number(entry, "w0"), zeta = problems::number(entry, "zeta");
    const double h = problems::number(entry, "step");
    const auto found = effective(name, linear(w0, zeta), h);
    const std::string where = entry.dump();
    const double radius = problems::number(entry, "spectral_radius");
    EXPECT_NEAR(found.spectral_radius, radius, 1e-12 * radius) << where;
    if (entry.contains("decay_rate")) {
      ASSERT_TRUE(found.decay_rate && found.angular_frequency) << where;
      EXPECT_NEAR(*found.decay_rate, problems::number(entry, "decay_rate"), 1e-10 * w0) << where;
      EXPECT_NEAR(*found.angular_frequency, problems::number(entry, "angular_frequency"), 1e-10 * w0)
          << where;
      ++oscillating;
    } else {
      EXPECT_FALSE(found.decay_rate || found.angular_frequency || found.energy_factor()) << where;
      std::vector<double> values, expected;
      for (const auto& z : found.eigenvalues) values.push_back(z.re);
      for (const auto& z : entry.at("eigenvalues")) expected.push_back(problems::number(z));
      std::sort(values.begin(), values.end());
      std::sort(expected.begin(), expected.end());
      ASSERT_EQ(values.size(), expected.size());
      for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_NEAR(values[i], expected[i], 1e-12 * std::abs(expected[i])) << where;
      ++others;
    }
  }
  EXPECT_EQ(oscillating + others, 224);
  EXPECT_GT(others, 10);
}

TEST(EffectiveOscillator, EigenvaluesAreTheStabilityFunctionsOfTheTextbooks) {
  // Of z = h lambda: J. C. Butcher, Numerical Methods for Ordinary Differential Equations, section 238.
  using Z = std::complex<double>;
  const auto taylor = [](const Z& z, int order) {
    Z sum = 1, term = 1;
    for (int n = 1; n <= order; ++n) sum += term *= z / static_cast<double>(n);
    return sum;
  };
  const std::map<std::string_view, std::function<Z(Z)>> functions{
      {"forward-euler", [&](Z z) { return taylor(z, 1); }},
      {"heun", [&](Z z) { return taylor(z, 2); }},
      {"rk4", [&](Z z) { return taylor(z, 4); }},
      {"dormand-prince", [&](Z z) { return taylor(z, 5) + std::pow(z, 6) / 600.0; }},
      {"implicit-euler", [](Z z) { return 1.0 / (1.0 - z); }},
      {"implicit-midpoint", [](Z z) { return (2.0 + z) / (2.0 - z); }},
      {"newmark", [](Z z) { return (2.0 + z) / (2.0 - z); }},
      {"gauss-legendre4", [](Z z) { return (12.0 + 6.0 * z + z * z) / (12.0 - 6.0 * z + z * z); }},
      {"exact", [](Z z) { return std::exp(z); }},
  };
  for (const auto& [name, function] : functions)
    for (const double zeta : {0.0, 0.02, 0.6})
      for (const double wh : {0.03, 0.3, 1.1, 2.5}) {
        const Z expected = function(wh * Z(-zeta, std::sqrt(1 - zeta * zeta)));
        const auto z = effective(name, linear(6, zeta), wh / 6).eigenvalues.front();
        EXPECT_NEAR(z.re, expected.real(), 1e-13 * std::abs(expected)) << name << ' ' << zeta << ' ' << wh;
        EXPECT_NEAR(z.im, std::abs(expected.imag()), 1e-13 * std::abs(expected))
            << name << ' ' << zeta << ' ' << wh;
      }
}

TEST(EffectiveOscillator, Yoshida4IsThreeVerlets) {
  // H. Yoshida, Phys. Lett. A 150, 262 (1990): steps w1 h, w0 h, w1 h, undamped.
  const double w1 = 1 / (2 - std::cbrt(2.0)), w0 = 1 - 2 * w1;
  for (const double wh : {0.03, 0.3, 1.1}) {
    std::array<double, 4> product{1, 0, 0, 1};
    for (const double part : {w1, w0, w1}) {
      // Of x and v/w.
      const double u = part * wh, c = 1 - u * u / 2, s = u * (1 - u * u / 4);
      const auto [a, b, d, e] = product;
      product = {c * a + u * d, c * b + u * e, c * d - s * a, c * e - s * b};
    }
    const double angle = std::acos((product[0] + product[3]) / 2);
    EXPECT_NEAR(*effective("yoshida4", linear(6, 0), wh / 6).angular_frequency, 6 / wh * angle, 1e-11) << wh;
  }
}

TEST(EffectiveOscillator, GeneralizedAlphaDampsLongStepsByItsRhoInf) {
  for (const double rho_inf : {0.0, 0.3, 0.8, 1.0}) {
    const GeneralizedAlpha method{.newton = {}, .rho_inf = rho_inf};
    const auto far = effective_oscillator(method, linear(6, 0), 1e6);
    EXPECT_NEAR(far.spectral_radius, rho_inf, 2e-3) << rho_inf;
    EXPECT_NEAR(*effective_oscillator(method, linear(6, 0), 1e-3).angular_frequency, 6, 1e-4) << rho_inf;
  }
}

TEST(EffectiveOscillator, EveryMethodOfTheRegistryMeetsAnIndependentTruth) {
  std::set<std::string> known{"heun",  "dormand-prince", "gauss-legendre4",
                              "exact", "yoshida4",       "generalized-alpha"};
  for (const auto& entry : problems::read("effective.json"))
    known.insert(entry.at("method").get<std::string>());
  for (const auto name : method_names)
    EXPECT_TRUE(known.count(std::string(name))) << name << ": add one above";
}

TEST(EffectiveOscillator, SaysWhatTheTheorySays) {
  // docs/theory.md: w = 6, b = 0.15, h = 0.01.
  const LinearLaw<double> law{.decay_rate = 0.15, .stiffness = 36};
  EXPECT_NEAR(*effective("forward-euler", law, 0.01).decay_rate, -0.030, 5e-4);
  EXPECT_NEAR(*effective("euler-cromer", law, 0.01).decay_rate, 0.1502, 5e-5);
  EXPECT_NEAR(*effective("implicit-euler", law, 0.01).decay_rate, 0.329, 5e-4);
  EXPECT_NEAR(*effective("euler-cromer", law, 0.01).decay_rate, -std::log(1 - 2 * 0.15 * 0.01) / 0.02, 1e-13);
}

TEST(EffectiveOscillator, CriticalDampingDoesNotSwing) {
  // One double eigenvalue, whose rounding must not pass for an oscillation; Euler-Cromer's own is no longer
  // critical.
  const LinearLaw<double> law = linear(3, 1);
  for (const double h : {0.003, 0.1, 0.37})
    for (const char* method :
         {"implicit-euler", "implicit-midpoint", "newmark", "heun", "rk4", "gauss-legendre4", "exact"})
      EXPECT_FALSE(effective(method, law, h).angular_frequency) << method << ' ' << h;
  EXPECT_TRUE(effective("implicit-euler", linear(3, 1 - 1e-9), 0.1).angular_frequency);
}

TEST(EffectiveOscillator, ExactIsItsOwn) {
  const auto found = effective("exact", linear(6, 0.1), 0.02);
  EXPECT_NEAR(*found.decay_rate, 0.6, 1e-12);
  EXPECT_NEAR(*found.angular_frequency, 6 * std::sqrt(0.99), 1e-12);
  EXPECT_NEAR(*found.energy_factor(), std::exp(-4 * std::numbers::pi * 0.1 / std::sqrt(0.99)), 1e-12);
}

TEST(EffectiveOscillator, TheMotionIsThatOfTheEffectiveOne) {
  // Three states of a run of any oscillating map satisfy x2 = 2 rho cos(theta) x1 - rho^2 x0.
  const double h = 0.05;
  const LinearLaw<double> law = linear(9, 0.05);
  const DrivenOscillator<double, Terms{.law = linear_terms}> system({1, 81, 0.9, 0, 0, 0}, {});
  for_each_method({}, [&](const auto& method) {
    if (method.info.is_adaptive()) return;
    const auto found = effective_oscillator(method, law, h);
    ASSERT_TRUE(found.decay_rate) << method.info.name;
    // Far enough for roots that are not the motion's to have died.
    std::vector<double> x;
    solve(system, method, {0, 42 * h}, State<double>{1, 0}, h,
          [&](double, const State<double>& y) { x.push_back(y.x); });
    const double rho = std::exp(-*found.decay_rate * h), theta = *found.angular_frequency * h;
    const double predicted = 2 * rho * std::cos(theta) * x[41] - rho * rho * x[40];
    EXPECT_NEAR(x[42], predicted, 1e-12) << method.info.name;
  });
}

TEST(EffectiveOscillator, StabilityLimitsAreTheKnownOnes) {
  EXPECT_EQ(limit("forward-euler", 6, 0), 0.0);
  EXPECT_NEAR(*limit("forward-euler", 6, 0.05), 2 * 0.05 / 6, 1e-12);  // 2 b/w^2
  EXPECT_NEAR(*limit("forward-euler", 1, 1e-5), 2e-5, 1e-10);
  EXPECT_NEAR(*limit("euler-cromer", 6, 0), 2.0 / 6, 1e-12);
  EXPECT_NEAR(*limit("verlet", 6, 0), 2.0 / 6, 1e-12);
  EXPECT_NEAR(*limit("rk4", 1, 0), std::sqrt(8.0), 1e-9);
  EXPECT_NEAR(*limit("rk4", 1, 1e3), 2.785293563405282 / 2e3, 1e-8);  // the limit on the negative axis
  EXPECT_EQ(limit("implicit-euler", 6, 0), std::nullopt);
  EXPECT_EQ(limit("implicit-euler", 6, 2), std::nullopt);
  EXPECT_EQ(limit("exact", 6, 0), std::nullopt);
}

TEST(EffectiveOscillator, WhatClaimsAStabilityIsStableAtAnyStepAndNothingElseIs) {
  for (const double rho_inf : {0.8, 0.0, 0.5, 1.0})
    for_each_method(MethodSettings{.newton = {}, .rho_inf = rho_inf}, [&](const auto& method) {
      bool bounded = true;
      double most = 0;
      for (int decade = -3; decade <= 4; ++decade)
        for (const double part : {1.0, 1.7, 3.1, 5.9})
          for (const double zeta : {0.0, 1e-6, 0.01, 0.1, 0.5, 0.99, 1.0, 1.01, 2.0, 5.0, 10.0}) {
            const double wh = part * std::pow(10, decade);
            if (wh > 1e4) continue;
            const double radius = effective_oscillator(method, linear(6, zeta), wh / 6).spectral_radius;
            // A map with entries of the size of w h rounds by as much.
            bounded = bounded && radius <= 1 + 1e-12 + 1e-15 * wh;
            most = std::max(most, radius);
          }
      EXPECT_EQ(bounded, method.info.a_stable) << method.info.name << ": " << most;
      // Far beyond rounding, where it is not claimed.
      EXPECT_TRUE(method.info.a_stable || most > 100) << method.info.name << ": " << most;
    });
}

TEST(EffectiveOscillator, StepsJustBelowTheLimitAreStableAndJustAboveAreNot) {
  for (const double zeta : {0.0, 0.01, 0.05, 0.7, 1.0, 3.0}) {
    const LinearLaw<double> law = linear(6, zeta);
    for_each_method({}, [&](const auto& method) {
      if (method.info.is_adaptive()) return;
      const auto most = stability_limit(method, law);
      if (!most || *most == 0) return;
      EXPECT_TRUE(effective_oscillator(method, law, *most * (1 - 1e-3)).stable()) << method.info.name << zeta;
      EXPECT_FALSE(effective_oscillator(method, law, *most * (1 + 1e-3)).stable())
          << method.info.name << zeta;
    });
  }
}

TEST(EffectiveOscillator, ADrivenRunSettlesWhereItSays) {
  const double h = 0.05, W = 4;
  LinearLaw<double> law = linear(6, 0.1);
  law.drive_amplitude = 1.5;
  law.drive_frequency = W;
  const DrivenOscillator<double, Terms{.drive = true, .law = linear_terms}> system({1, 36, 1.2, 0, 0, 0},
                                                                                   {1.5, W, 0});
  for_each_method({}, [&](const auto& method) {
    if (method.info.is_adaptive()) return;
    const auto found = effective_oscillator(method, law, h);
    if (!found.stable()) return;
    ASSERT_TRUE(found.steady_state) << method.info.name;
    const auto [amplitude, lag] = *found.steady_state;
    const auto outcome = solve(system, method, {0, 4000 * h}, State<double>{1, 0}, h, KeepNone{});
    EXPECT_NEAR(outcome.y.x, amplitude * std::cos(W * outcome.t - lag), 1e-12) << method.info.name;
  });
  const auto exact = effective("exact", law, h).steady_state;
  const auto known = frequency_response({.mass = 1, .stiffness = 36, .damping = 1.2}, 1.5, W);
  EXPECT_NEAR(exact->amplitude, known.amplitude, 1e-13);
  EXPECT_NEAR(exact->phase_lag, known.phase_lag, 1e-13);
}

TEST(EffectiveOscillator, WhatNeverSettlesHasNoSteadyState) {
  LinearLaw<double> law = linear(6, 0);
  law.drive_amplitude = 1;
  law.drive_frequency = 4;
  EXPECT_FALSE(effective("euler-cromer", law, 0.01).steady_state);
  EXPECT_FALSE(effective("forward-euler", law, 0.01).steady_state);
  EXPECT_TRUE(effective("implicit-euler", law, 0.01).steady_state);  // its own damping makes it settle
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
