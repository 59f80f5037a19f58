// Frequency, damping ratio and their kin of every law, against closed forms and motions integrated in small
// steps.
#include "cromer/tasks/fit/fitted_quantities.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "cromer/base/pi.h"
#include "cromer/identify/motion/motion_model.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double w0 = 3, A = 0.4;

Estimate certain(double value) { return make_estimate(value, 0, 2); }

void set(LawFit& fit, const char* name, const Estimate& estimate) {
  fit.names.emplace_back(name);
  fit.estimates.push_back(estimate);
  fit.covariance.assign(fit.names.size() * fit.names.size(), 0);
}

/// Released at rest at A.
LawFit released(double decay_rate) {
  LawFit fit;
  set(fit, "angular_frequency", certain(w0));
  set(fit, "decay_rate", certain(decay_rate));
  set(fit, "position", certain(A));
  fit.student = 2;
  return fit;
}

double value(const LawFit& fit, std::string_view name) {
  for (const Parameter& number : derived_quantities(fit, "m", 0))
    if (number.name == name) return number.estimate.value;
  ADD_FAILURE() << name;
  return 0;
}

/// The viscous rate that takes as much in a cycle as the motion loses about the amplitude A: from the squares
/// of the turning points before and after it, A reached in the middle.
double rate_by_integration(const Motion& law, double period) {
  constexpr int points = 4000;
  std::vector<double> t;
  for (int i = 0; i <= points; ++i) t.push_back(1.3 * period * i / points);
  const Trajectory motion = free_motion(law, t, period / 600);
  // Turning points after half a period and after a whole one.
  std::vector<double> turns{law.position};
  for (std::size_t i = 1; i + 1 < motion.size(); ++i)
    if (motion.v[i] * motion.v[i + 1] < 0) {
      const double s = motion.v[i] / (motion.v[i] - motion.v[i + 1]), h = t[i + 1] - t[i];
      turns.push_back(motion.x[i] + 0.5 * s * h * motion.v[i]);
    }
  EXPECT_GE(turns.size(), 3u);
  return std::log(turns[0] / std::abs(turns[2])) / period;
}

TEST(DerivedQuantities, OfTheViscousLawAreTheTextbooks) {
  const LawFit fit = released(0.2);
  const double w = std::sqrt(9 - 0.04);
  EXPECT_NEAR(value(fit, "frequency"), w / (2 * pi), 1e-14);
  EXPECT_NEAR(value(fit, "period"), 2 * pi / w, 1e-14);
  EXPECT_NEAR(value(fit, "damping_ratio"), 0.2 / 3, 1e-15);
  EXPECT_NEAR(value(fit, "quality_factor"), 7.5, 1e-13);
  EXPECT_NEAR(value(fit, "logarithmic_decrement"), 0.2 * 2 * pi / w, 1e-14);
  EXPECT_NEAR(value(fit, "at_amplitude"), A, 1e-15);
}

TEST(DerivedQuantities, ASwingThatIsFedHasALimitCycleAndNoQuality) {
  LawFit fit = released(-0.1);
  fit.law = law_of("viscous+van-der-pol");
  set(fit, "van_der_pol", make_estimate(2.5, 0.1, 2));
  fit.estimates[1] = make_estimate(-0.1, 0.01, 2);
  fit.motion.law = fit.law;
  fit.motion.set_angular_frequency(w0);
  fit.motion.set_decay_rate(-0.1);
  fit.motion.per_mass.van_der_pol = 2.5;
  const std::size_t n = fit.names.size();
  fit.covariance[1 * n + 1] = 0.01 * 0.01;
  fit.covariance[3 * n + 3] = 0.1 * 0.1;
  const double limit = std::sqrt(8 * 0.1 / 2.5);
  bool found = false;
  for (const Parameter& number : derived_quantities(fit, "m", 0)) {
    EXPECT_NE(number.name, "quality_factor");
    if (number.name != "limit_cycle_amplitude") continue;
    found = true;
    // To the first order in the damping, whose root takes half of each relative error.
    EXPECT_NEAR(number.estimate.value, limit, 1e-3 * limit);
    EXPECT_NEAR(number.estimate.standard_error, limit / 2 * std::hypot(0.1, 0.04), 1e-3 * limit);
  }
  EXPECT_TRUE(found);
}

TEST(ForceParameters, AnIntervalThatEndsAtItsBoundStaysThere) {
  LawFit fit;
  fit.law = law_with<Spring, Viscous>;
  set(fit, "angular_frequency", certain(w0));
  set(fit, "decay_rate", {.value = 0.01, .standard_error = 0.02, .low = 0, .high = 0.05});
  fit.student = 2;
  const Body body{.mass = Quantity{0.2, 0.05}};
  for (const Parameter& each : force_parameters(fit, body, "m"))
    if (each.name == "damping") {
      EXPECT_EQ(each.estimate.low, 0);
      EXPECT_NEAR(each.estimate.value, 0.004, 1e-15);
      return;
    }
  FAIL();
}

TEST(DerivedQuantities, IntervalsEndWhereTheQuantityEnds) {
  LawFit fit = released(0.002);
  fit.names = {"angular_frequency", "decay_rate", "position"};
  fit.covariance = {1e-6, 0, 0, 0, 0.01 * 0.01, 0, 0, 0, 1e-6};
  const auto find = [&](std::string_view name) {
    for (const Parameter& each : derived_quantities(fit, "m", 0))
      if (each.name == name) return each.estimate;
    return Estimate{};
  };
  // Damping that may be none leaves the quality factor without an upper end.
  EXPECT_LT(find("damping_ratio").low, 0);
  EXPECT_NEAR(find("quality_factor").low, 1 / (2 * find("damping_ratio").high), 1e-12);
  EXPECT_TRUE(std::isinf(find("quality_factor").high));
  EXPECT_GT(find("frequency").low, 0);
  // Where the law's damping is not negative, neither is its ratio.
  fit.estimates[1] = {0.002, 0.01, 0, 0.022};
  EXPECT_EQ(find("damping_ratio").low, 0);
  EXPECT_EQ(find("logarithmic_decrement").low, 0);
}

TEST(DerivedQuantities, WhatFollowsFromABoundHasItsUncertainty) {
  LawFit fit = released(0);
  fit.names = {"angular_frequency", "decay_rate", "position"};
  fit.covariance = {1e-10, 0, 0, 0, 0, 0, 0, 0, 1e-6};
  fit.estimates[1] = {0, 0.0012, 0, 0.003};
  for (const Parameter& each : derived_quantities(fit, "m", 0)) {
    const Estimate& e = each.estimate;
    if (each.name == "damping_ratio") {
      EXPECT_NEAR(e.standard_error, 0.0012 / w0, 1e-9);
      EXPECT_EQ(e.low, 0);
      EXPECT_NEAR(e.high, 0.003 / w0, 1e-9);
    }
    if (each.name == "quality_factor") {
      EXPECT_NEAR(e.low, w0 / (2 * 0.003), 1e-4);
      EXPECT_TRUE(std::isinf(e.high));
    }
  }
  EXPECT_NEAR(decay_rate_ends(fit, 10)[0].estimate.high, 0.003, 1e-9);
}

TEST(DerivedQuantities, IntervalsReachAsFarAsThoseOfTheParameters) {
  LawFit fit = released(0.1);
  fit.names = {"angular_frequency", "decay_rate", "position"};
  fit.covariance = {1e-10, 0, 0, 0, 0.01 * 0.01, 0, 0, 0, 1e-6};
  fit.estimates[1] = {0.1, 0.01, 0.07, 0.13};  // three standard errors
  for (const Parameter& each : derived_quantities(fit, "m", 0)) {
    if (each.name == "damping_ratio") {
      EXPECT_NEAR(each.estimate.high - each.estimate.value, 3 * each.estimate.standard_error, 1e-9);
    }
    if (each.name == "quality_factor") {
      EXPECT_NEAR(each.estimate.low, w0 / (2 * 0.13), 1e-6);
      EXPECT_NEAR(each.estimate.high, w0 / (2 * 0.07), 1e-6);
    }
  }
  const std::vector<Parameter> ends = decay_rate_ends(fit, 10);
  EXPECT_NEAR(ends[0].estimate.low, 0.07, 1e-12);
  EXPECT_NEAR(ends[0].estimate.high, 0.13, 1e-12);
}

TEST(CoefficientNames, AreThoseInSIWhereAMassGivesThem) {
  const auto names = [](const char* law, std::initializer_list<const char*> parameters) {
    std::vector<Parameter> all;
    for (const char* name : parameters) all.push_back({name, certain(1), ""});
    return coefficient_names(law_of(law), all);
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names("viscous+drag", {"decay_rate", "drag", "equilibrium", "angular_frequency", "velocity"}),
            (Names{"angular_frequency", "decay_rate", "drag"}));
  EXPECT_EQ(names("viscous+drag", {"angular_frequency", "decay_rate", "drag", "drag_coefficient", "stiffness",
                                   "damping", "drag_constant"}),
            (Names{"stiffness", "damping", "drag_constant", "drag_coefficient"}));
  // beta and gamma are no forces: they have one name.
  EXPECT_EQ(names("hysteresis", {"angular_frequency", "hysteresis_stiffness", "hysteresis_beta",
                                 "hysteresis_gamma", "stiffness", "hysteresis_force_stiffness"}),
            (Names{"stiffness", "hysteresis_force_stiffness", "hysteresis_beta", "hysteresis_gamma"}));
  EXPECT_EQ(names("pendulum+viscous", {"angular_frequency", "decay_rate"}),
            (Names{"decay_rate", "angular_frequency"}));
}

TEST(DerivedQuantities, OfDragAndFrictionTakeTheSameEnergyInACycle) {
  LawFit drag = released(0);
  drag.law = law_of("viscous+drag");
  set(drag, "drag", certain(0.05));
  // Drag takes 8 d w^2 A^3/3 in a cycle, viscous damping 2 pi zeta w^2 A^2.
  EXPECT_NEAR(value(drag, "damping_ratio"), 4 * 0.05 * A / (3 * pi), 1e-14);
  EXPECT_NEAR(value(drag, "frequency"), w0 / (2 * pi), 1e-14);
  LawFit friction = released(0);
  friction.law = law_of("viscous+friction");
  set(friction, "friction", certain(0.02));
  // Friction takes 4 f A.
  EXPECT_NEAR(value(friction, "damping_ratio"), 4 * 0.02 * A / (2 * pi * w0 * w0 * A * A), 1e-15);
  EXPECT_NEAR(value(friction, "quality_factor"), pi * w0 * w0 * A / (4 * 0.02), 1e-10);
}

TEST(DerivedQuantities, AreThoseOfTheMotionIntegrated) {
  // Damping so small that the amplitude hardly changes over the cycle that is looked at.
  for (const bool pendulum : {false, true}) {
    LawFit fit = released(1e-5);
    fit.law = law_of(pendulum ? "viscous+drag+friction+pendulum" : "viscous+drag+friction+cubic");
    set(fit, "drag", certain(2e-5));
    set(fit, "friction", certain(2e-6));
    if (!pendulum) set(fit, "cubic", certain(-1.5));
    TrueSwing law{.angular_frequency = w0,
                  .decay_rate = 1e-5,
                  .drag = 2e-5,
                  .friction = 2e-6,
                  .cubic = pendulum ? 0 : -1.5,
                  .position = A,
                  .pendulum = pendulum};
    const double measured = rate_by_integration(law, value(fit, "period"));
    // The rate is that of a harmonic swing; the springs' curvature changes what is lost by some of k3
    // A^2/w0^2 = 3 %.
    EXPECT_NEAR(value(fit, "logarithmic_decrement") / value(fit, "period") / measured, 1, 0.03) << pendulum;
    fit.law = law_of("viscous+drag+friction");
    law.pendulum = false;
    law.cubic = 0;
    EXPECT_NEAR(value(fit, "logarithmic_decrement") / value(fit, "period") /
                    rate_by_integration(law, value(fit, "period")),
                1, 1e-4);
  }
}

TEST(DerivedQuantities, PropagateTheWholeCovariance) {
  LawFit fit = released(0.05);
  fit.law = law_of("viscous+drag+friction+cubic");
  set(fit, "drag", certain(0.3));
  set(fit, "friction", certain(0.01));
  set(fit, "cubic", certain(-2));
  set(fit, "velocity", certain(0.5));
  const std::size_t n = fit.names.size();
  // A covariance with correlations: L L^T.
  std::vector<double> L(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) L[i * n + j] = i == j ? 2e-4 : (i + j) % 3 == 0 ? -0.7e-4 : 0.9e-4;
  fit.covariance.assign(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k) fit.covariance[i * n + j] += L[i * n + k] * L[j * n + k];
  const auto moved = [&](std::size_t i, double by) {
    LawFit other = fit;
    other.estimates[i].value += by;
    return other;
  };
  for (const Parameter& number : derived_quantities(fit, "m", 0)) {
    std::vector<double> slope;
    for (std::size_t i = 0; i < n; ++i)
      slope.push_back((value(moved(i, 1e-6), number.name) - value(moved(i, -1e-6), number.name)) / 2e-6);
    double variance = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) variance += slope[i] * fit.covariance[i * n + j] * slope[j];
    EXPECT_GT(variance, 0) << number.name;
    EXPECT_NEAR(number.estimate.standard_error / std::sqrt(variance), 1, 1e-6) << number.name;
  }
}

TEST(DerivedQuantities, OfADrivenMotionHoldAtItsMeanAmplitude) {
  LawFit fit = released(0.05);
  fit.drive = Drive::harmonic();
  fit.law = law_of("viscous+drag");
  fit.motion.set_angular_frequency(w0);
  set(fit, "drag", certain(0.3));
  std::vector<double> x;
  for (int i = 0; i < 1000; ++i) x.push_back(7 + 0.2 * std::sin(2 * pi * i / 100));
  const std::vector<Parameter> list = derived_quantities(fit, "m", 0, x);
  ASSERT_EQ(list.back().name, "at_amplitude");
  EXPECT_NEAR(list.back().estimate.value, 0.2, 1e-12);
  EXPECT_NEAR(list[2].estimate.value, (0.05 + 4 * 0.3 * w0 / (3 * pi) * 0.2) / w0, 1e-12);
  fit.motion.set_decay_rate(4);  // overdamped
  EXPECT_EQ(derived_quantities(fit, "m", 0, x).size(), 3u);
}

TEST(DecayRateEnds, OfTheViscousLawAreItsDecayRate) {
  LawFit fit = released(0.2);
  fit.covariance = {0, 0, 0, 0, 0.01 * 0.01, 0, 0, 0, 0};
  for (const double long_after : {120.0, 1e4})
    for (const Parameter& end : decay_rate_ends(fit, long_after)) EXPECT_DOUBLE_EQ(end.estimate.value, 0.2);
  EXPECT_EQ(decay_rate_ends(fit, 1e4).size(), 2u);
  const std::vector<Parameter> ends = decay_rate_ends(fit, 12);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0].name, "decay_rate_start");
  EXPECT_EQ(ends[1].name, "decay_rate_end");
  for (const Parameter& end : ends) {
    EXPECT_EQ(end.unit, "1/s");
    EXPECT_DOUBLE_EQ(end.estimate.value, 0.2);
    EXPECT_NEAR(end.estimate.standard_error, 0.01, 1e-12);
  }
}

/// Viscous damping and drag: rate g + q A with q = 4 d w/(3 pi), whose amplitude has a closed form.
LawFit dragged(double g, double d) {
  LawFit fit = released(g);
  fit.law = law_of("viscous+drag");
  set(fit, "drag", certain(d));
  return fit;
}

double last_rate_of_drag(double w, double g, double a, double d, double t) {
  const double q = 4 * d * w / (3 * pi), fall = std::exp(-g * t);
  return g + q * a * g * fall / (g + q * a * (1 - fall));
}

TEST(DecayRateEnds, OfDragFollowTheAmplitudeWithItsErrors) {
  constexpr double g = 0.02, d = 0.3, t = 40;
  LawFit fit = dragged(g, d);
  // Parameters: frequency, decay rate, position, drag.
  const double error[] = {1e-4, 2e-3, 3e-3, 2e-2}, correlation = -0.9;  // of decay rate and drag
  for (int i = 0; i < 4; ++i) fit.covariance[static_cast<std::size_t>(5 * i)] = error[i] * error[i];
  fit.covariance[4 + 3] = fit.covariance[12 + 1] = correlation * error[1] * error[3];
  const std::vector<Parameter> ends = decay_rate_ends(fit, t);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_NEAR(ends[0].estimate.value, g + 4 * d * w0 * A / (3 * pi), 1e-12);
  EXPECT_NEAR(ends[1].estimate.value, last_rate_of_drag(w0, g, A, d, t), 1e-6 * ends[1].estimate.value);
  const double at[] = {w0, g, A, d};
  double slope[4];
  for (int i = 0; i < 4; ++i) {
    double up[4], down[4];
    for (int k = 0; k < 4; ++k) up[k] = down[k] = at[k];
    up[i] *= 1 + 1e-5;
    down[i] *= 1 - 1e-5;
    slope[i] = (last_rate_of_drag(up[0], up[1], up[2], up[3], t) -
                last_rate_of_drag(down[0], down[1], down[2], down[3], t)) /
               (2e-5 * at[i]);
  }
  double variance = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) variance += slope[i] * fit.covariance[4 * i + k] * slope[k];
  EXPECT_NEAR(ends[1].estimate.standard_error, std::sqrt(variance), 1e-4 * std::sqrt(variance));
}

TEST(DecayRateEnds, WhatComesToRestHasNoLastRate) {
  LawFit fit = released(0.01);
  fit.law = law_of("viscous+friction");
  set(fit, "friction", certain(0.05));
  // Friction alone takes 4 f/w0^2 of the amplitude in each cycle: at rest within 18 cycles.
  EXPECT_EQ(decay_rate_ends(fit, 5 * two_pi / w0).size(), 2u);
  const std::vector<Parameter> stopped = decay_rate_ends(fit, 30 * two_pi / w0);
  ASSERT_EQ(stopped.size(), 1u);
  EXPECT_EQ(stopped[0].name, "decay_rate_start");
}

TEST(DecayRateEnds, OfBentSpringsAreThoseOfTheirMotion) {
  LawFit fit = dragged(0.02, 0.3);
  fit.law = law_of("viscous+drag+cubic");
  set(fit, "cubic", certain(20));
  TrueSwing law{.angular_frequency = w0, .decay_rate = 0.02, .drag = 0.3, .cubic = 20, .position = A};
  std::vector<double> t;
  for (int i = 0; i <= 20000; ++i) t.push_back(40.0 * i / 20000);
  const Trajectory motion = free_motion(law, t, 0.002);
  std::vector<double> when, top;
  for (std::size_t i = 1; i + 1 < motion.size(); ++i)
    if (motion.v[i] > 0 && motion.v[i + 1] <= 0) when.push_back(t[i]), top.push_back(motion.x[i]);
  ASSERT_GT(top.size(), 10u);
  const std::size_t n = top.size();
  const double last = std::log(top[n - 3] / top[n - 1]) / (when[n - 1] - when[n - 3]);
  const std::vector<Parameter> ends = decay_rate_ends(fit, when[n - 2]);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_NEAR(ends[1].estimate.value / last, 1, 0.01);
}

TEST(DecayRateEnds, NeitherOfHystereticNorOfDrivenMotions) {
  LawFit driven = released(0.2);
  driven.drive.kind = DriveKind::harmonic;
  EXPECT_TRUE(decay_rate_ends(driven, 10).empty());
  LawFit loops = released(0.2);
  loops.law = law_of("viscous+hysteresis");
  EXPECT_TRUE(decay_rate_ends(loops, 10).empty());
}

TEST(DerivedQuantities, ABodyWithoutASpringHasItsMass) {
  LawFit fit;
  fit.law = Law{};
  fit.student = 2;
  set(fit, "force_gain", make_estimate(4, 0.02, 2));
  const auto mass = [&](std::string_view observed, int derivative, std::string_view force) {
    const std::vector<Parameter> list = derived_quantities(fit, observed, derivative, {}, force);
    EXPECT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].name, "mass");
    EXPECT_EQ(list[0].estimate.value, 0.25);
    EXPECT_EQ(list[0].estimate.standard_error, 0.02 / 16);
    return list[0].unit;
  };
  EXPECT_EQ(mass("m", 0, "N"), "kg");
  EXPECT_EQ(mass("m/s", 1, "N"), "kg");
  EXPECT_EQ(mass("m", 0, "V"), "");
  EXPECT_EQ(mass("rad", 0, "N"), "");
  EXPECT_EQ(mass("", 0, "N"), "");
  EXPECT_TRUE(decay_rate_ends(fit, 10).empty());
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
