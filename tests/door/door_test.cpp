// The door as a stranger uses it, with known answers.
#include "cromer/cromer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace CROMER_FILE {

using testing::HasSubstr;
using testing::Not;

struct Swing {
  std::vector<double> t, y;
};

/// The sum of twelve uniform numbers less six: about a standard normal one.
double normal(unsigned long long& state) {
  double sum = 0;
  for (int k = 0; k < 12; ++k) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    sum += static_cast<double>(state >> 11) / 9007199254740992.0;
  }
  return sum - 6;
}

/// x = 5 cm e^(-0.05 t) cos(w t) about 0.2 m, with noise of 0.1 mm from a generator of its own.
Swing swing(int samples = 2000, double w = 3, double noise = 1e-4) {
  Swing made;
  unsigned long long state = 12345;
  for (int i = 0; i < samples; ++i) {
    const double t = 0.01 * i;
    made.t.push_back(t);
    made.y.push_back(0.2 + 0.05 * std::exp(-0.05 * t) * std::cos(w * t) + noise * normal(state));
  }
  return made;
}

TEST(DoorFit, FindsTheLawOfArrays) {
  const Swing made = swing();
  const auto fit = cromer::fit(made.t, made.y, {.law = "viscous", .mass = {0.2176, 0.0003}});
  ASSERT_TRUE(fit) << fit.error().message();
  ASSERT_TRUE(fit->succeeded()) << fit->message;
  EXPECT_EQ(fit->law, "viscous");
  EXPECT_EQ(fit->samples, 2000u);
  const auto rate = fit->find("decay_rate"), w = fit->find("angular_frequency"), k = fit->find("stiffness");
  ASSERT_TRUE(rate && w && k);
  EXPECT_NEAR(rate->value, 0.05, 3 * rate->standard_error);
  EXPECT_LT(rate->low, 0.05);
  EXPECT_GT(rate->high, 0.05);
  EXPECT_NEAR(w->value, std::hypot(3, 0.05), 3 * w->standard_error);
  // The mass is known to 0.14 %, which is what the spring constant is then known to.
  EXPECT_NEAR(k->value, 0.2176 * 9.0025, 1e-3);
  EXPECT_NEAR(k->standard_error / k->value, 0.0003 / 0.2176, 1e-4);
  EXPECT_EQ(fit->find("no such thing"), std::nullopt);
}

TEST(DoorFit, CovarianceBelongsToTheFittedParameters) {
  const Swing made = swing();
  const auto fit = cromer::fit(made.t, made.y, {.law = "viscous"});
  ASSERT_TRUE(fit);
  const std::size_t n = fit->fitted.size();
  ASSERT_EQ(fit->covariance.size(), n * n);
  for (std::size_t i = 0; i < n; ++i) {
    const double error = fit->find(fit->fitted[i])->standard_error;
    EXPECT_NEAR(fit->covariance[i * n + i], error * error, 1e-9 * error * error);
  }
}

TEST(DoorFit, TheLawMovesAsTheRecordDoes) {
  const Swing made = swing(2000, 3, 0);
  const auto fit = cromer::fit(made.t, made.y, {.law = "viscous"});
  ASSERT_TRUE(fit && fit->succeeded());
  const auto at = fit->at(std::vector<double>{1.234, 17.5, 60});
  ASSERT_TRUE(at) << at.error().message();
  ASSERT_EQ(at->size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = at->t[i];
    EXPECT_NEAR(at->x[i], 0.05 * std::exp(-0.05 * t) * std::cos(3 * t), 1e-8) << t;
  }
  const auto motion = fit->motion();
  ASSERT_TRUE(motion);
  ASSERT_EQ(motion->size(), 2000u);
  EXPECT_NEAR(motion->residual[1000], 0, 1e-9);
  EXPECT_NEAR(motion->measured[1000], made.y[1000], 0);
  EXPECT_EQ(fit->at(std::vector<double>{1e300}).error().argument, "t");
  const auto before = fit->at(std::vector<double>{-1});
  ASSERT_FALSE(before);
  EXPECT_EQ(before.error().argument, "t");
}

TEST(DoorFit, OscillatorIsWhatSimulateTakes) {
  const cromer::Oscillator truth{.mass = 2, .stiffness = 18, .damping = 0.1, .cubic = 40};
  const auto run =
      cromer::simulate(truth, {.method = "dormand-prince", .position = 0.5, .step = 0.02, .until = 60});
  ASSERT_TRUE(run && run->succeeded());
  const auto fit = cromer::fit(run->t, run->x, {.law = "viscous+cubic", .mass = 2});
  ASSERT_TRUE(fit && fit->succeeded()) << fit->message;
  const auto oscillator = fit->oscillator();
  ASSERT_TRUE(oscillator);
  EXPECT_NEAR(oscillator->mass, 2, 0);
  EXPECT_NEAR(oscillator->stiffness, 18, 1e-4);
  EXPECT_NEAR(oscillator->damping, 0.1, 1e-5);
  EXPECT_NEAR(oscillator->cubic, 40, 1e-2);
}

TEST(DoorFit, MissingValuesAreLeftOut) {
  Swing made = swing();
  for (const int i : {3, 500, 501, 1999}) made.y[i] = std::nan("");
  const auto fit = cromer::fit(made.t, made.y, {.law = "viscous"});
  ASSERT_TRUE(fit && fit->succeeded());
  EXPECT_EQ(fit->samples, 1996u);
}

TEST(DoorFit, VelocitiesAreFittedAsWhatTheyAre) {
  Swing made = swing(2000, 3, 0);
  for (std::size_t i = 0; i < made.t.size(); ++i)
    made.y[i] =
        0.05 * std::exp(-0.05 * made.t[i]) * (-0.05 * std::cos(3 * made.t[i]) - 3 * std::sin(3 * made.t[i]));
  const auto fit = cromer::fit(made.t, made.y, {.law = "viscous", .observed = cromer::Observed::velocity});
  ASSERT_TRUE(fit && fit->succeeded());
  EXPECT_NEAR(fit->find("position")->value, 0.05, 1e-6);
  EXPECT_NEAR(fit->find("decay_rate")->value, 0.05, 1e-8);
}

/// What is wrong, and whose fault it is.
void expect_refused(const cromer::Result<cromer::LawFit>& fit, const std::string& argument,
                    const std::string& words) {
  ASSERT_FALSE(fit) << argument;
  EXPECT_EQ(fit.error().argument, argument) << fit.error().message();
  EXPECT_THAT(fit.error().message(), HasSubstr(words));
  EXPECT_THAT(fit.error().message(), Not(HasSubstr("--")));
}

TEST(DoorFit, ErrorsNameTheArgument) {
  const Swing made = swing();
  const std::vector<double>&t = made.t, &y = made.y;
  const auto changed = [](std::vector<double> values, std::size_t i, double to) {
    values[i] = to;
    return values;
  };
  expect_refused(cromer::fit(std::vector<double>{}, std::vector<double>{}), "t", "no values");
  expect_refused(cromer::fit(t, std::vector<double>(7)), "y", "7 values and t has 2000");
  expect_refused(cromer::fit(changed(t, 5, 0.01), y), "t", "t[5] = 0.01 s follows 0.04");
  expect_refused(cromer::fit(changed(t, 5, std::nan("")), y), "t", "t[5] is nan");
  expect_refused(cromer::fit(t, changed(y, 8, std::numeric_limits<double>::infinity())), "y", "y[8] is inf");
  expect_refused(cromer::fit(t, y, {.mass = -1}), "mass", "positive");
  expect_refused(cromer::fit(t, y, {.mass = 0}), "mass", "positive");
  expect_refused(cromer::fit(t, y, {.mass = {1, -0.1}}), "mass", "its uncertainty must be zero or more");
  expect_refused(cromer::fit(t, y, {.mass = {1, std::nan("")}}), "mass", "its uncertainty");
  expect_refused(cromer::fit(t, y, {.observed = static_cast<cromer::Observed>(9)}), "observed",
                 "no enumerator 9");
  expect_refused(cromer::fit(t, std::vector<double>(t.size(), std::nan(""))), "y", "no values");
  expect_refused(cromer::fit(t, y, {.law = "viscos"}), "law", "viscous");
  expect_refused(cromer::fit(t, y, {.spring_mass = 0.1}), "spring_mass", "needs mass");
  expect_refused(cromer::fit(t, y, {.mass = 1, .disc_diameter = {0, 0}}), "disc_diameter", "positive");
  expect_refused(cromer::fit(t, y, {.force = std::span(y).first(3)}), "force", "3 values");
  expect_refused(cromer::fit(t, y, {.force = y, .between_samples = static_cast<cromer::BetweenSamples>(9)}),
                 "between_samples", "no enumerator 9");
  expect_refused(cromer::fit(t, y, {.force = y, .between_samples = static_cast<cromer::BetweenSamples>(3)}),
                 "between_samples", "no enumerator 3");
  expect_refused(cromer::fit(t, y, {.segment = -1.0}), "segment", "positive");
  expect_refused(cromer::fit(t, y, {.drive_frequency = -2}), "drive_frequency", "");
  expect_refused(cromer::fit(t, y, {.hold_out = 2}), "hold_out", "");
  expect_refused(cromer::fit(t, y, {.no_spring = true}), "no_spring", "force");
  expect_refused(cromer::fit(t, y, {.hysteresis_exponent = 0.5}), "hysteresis_exponent", "at least 1");
}

TEST(DoorFit, WhatCannotBeFittedIsAStatus) {
  const auto fit = cromer::fit(std::vector<double>{0, 1, 2}, std::vector<double>{1, 2, 1});
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->status, cromer::FitStatus::too_short);
  EXPECT_FALSE(fit->message.empty());
  EXPECT_TRUE(fit->parameters.empty());
  EXPECT_FALSE(fit->at(std::vector<double>{1}));
  EXPECT_FALSE(fit->motion());
  EXPECT_FALSE(fit->oscillator());
  EXPECT_FALSE(cromer::LawFit{}.oscillator());
  EXPECT_FALSE(cromer::LawFit{}.succeeded());
  EXPECT_EQ(cromer::json(cromer::LawFit{}), "");
}

TEST(DoorFit, RecordedForceDrives) {
  std::vector<double> force;
  for (int i = 0; i < 3000; ++i) force.push_back(std::sin(2e-6 * i * i) + 0.5 * std::sin(0.031 * i));
  const cromer::Oscillator truth{.mass = 2, .stiffness = 18, .damping = 0.4};
  const auto run = cromer::simulate(
      truth, {.method = "exact", .drive = cromer::SampledForce{force, 0.01}, .step = 0.01, .until = 29.99});
  ASSERT_TRUE(run) << run.error().message();
  const auto fit = cromer::fit(run->t, run->x, {.law = "viscous", .force = force});
  ASSERT_TRUE(fit) << fit.error().message();
  ASSERT_TRUE(fit->succeeded()) << fit->message;
  EXPECT_NEAR(fit->find("angular_frequency")->value, 3, 1e-6);
  EXPECT_NEAR(fit->find("decay_rate")->value, 0.1, 1e-6);
  EXPECT_NEAR(fit->find("force_gain")->value, 0.5, 1e-6);
  EXPECT_FALSE(fit->at(std::vector<double>{1}));
}

TEST(DoorCompare, AStepFitsIntoTheRecord) {
  const Swing made = swing();
  const auto fit = cromer::fit(made.t, made.y, {.law = "viscous"});
  ASSERT_TRUE(fit);
  for (const double step : {0.0, 1e3, std::numeric_limits<double>::infinity(), std::nan("")}) {
    const auto compared = cromer::compare(*fit, {.method = "rk4", .step = step});
    ASSERT_FALSE(compared) << step;
    EXPECT_EQ(compared.error().argument, "step");
  }
}

TEST(DoorCompare, RefusesWhatSomethingDrives) {
  const cromer::Oscillator truth{.mass = 1, .stiffness = 9, .damping = 0.2};
  std::vector<double> force;
  for (int i = 0; i < 2000; ++i) force.push_back(std::sin(5e-6 * i * i));
  const auto forced = cromer::simulate(
      truth, {.method = "exact", .drive = cromer::SampledForce{force, 0.02}, .step = 0.02, .until = 39.98});
  const auto harmonic = cromer::simulate(
      truth, {.method = "exact", .drive = cromer::Harmonic{0.5, 2.3, 0.4}, .step = 0.02, .until = 80});
  ASSERT_TRUE(forced && harmonic);
  const auto by_force = cromer::fit(forced->t, forced->x, {.law = "viscous", .force = force});
  const auto by_sine = cromer::fit(harmonic->t, harmonic->x, {.law = "viscous", .find_drive = true});
  const auto refused_fit = cromer::fit(std::vector<double>{0, 1, 2}, std::vector<double>{1, 2, 1});
  ASSERT_TRUE(by_force && by_sine && refused_fit);
  for (const auto* fit : {&*by_force, &*by_sine}) {
    const auto compared = cromer::compare(*fit);
    ASSERT_FALSE(compared);
    EXPECT_THAT(compared.error().message(), HasSubstr("something drives this motion"));
  }
  EXPECT_EQ(cromer::compare(*refused_fit).error().argument, "fit");
}

TEST(DoorFit, NoiseIsNoHold) {
  // 15 mm of noise on 30 mm: nothing holds the mass at its start.
  for (unsigned long long seed = 1; seed <= 40; ++seed) {
    unsigned long long state = seed * 7919;
    std::vector<double> t, y;
    for (int i = 0; i < 1000; ++i) {
      t.push_back(0.01 * i);
      y.push_back(0.03 * std::exp(-0.05 * t.back()) * std::cos(9 * t.back()) + 0.015 * normal(state));
    }
    const auto fit = cromer::fit(t, y, {.law = "viscous"});
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->begin, 0) << seed;
    for (const cromer::Notice& notice : fit->notices)
      EXPECT_THAT(cromer::text(notice), Not(HasSubstr("held"))) << seed;
  }
}

TEST(DoorFit, AnOffsetChangesNoUncertainty) {
  const Swing made = swing();
  const double expected =
      cromer::fit(made.t, made.y, {.law = "viscous"})->find("angular_frequency")->standard_error;
  for (const double offset : {1e4, 1e5, 1e6, 1e7}) {
    std::vector<double> y = made.y;
    for (double& value : y) value += offset;
    const auto fit = cromer::fit(made.t, y, {.law = "viscous"});
    ASSERT_TRUE(fit && fit->succeeded()) << offset;
    EXPECT_NEAR(fit->find("angular_frequency")->standard_error / expected, 1, 0.02) << offset;
  }
}

TEST(DoorFit, HarmonicDriveIsFound) {
  const cromer::Oscillator truth{.mass = 1, .stiffness = 9, .damping = 0.2};
  const auto run = cromer::simulate(
      truth, {.method = "exact", .drive = cromer::Harmonic{0.5, 2.3, 0.4}, .step = 0.02, .until = 80});
  ASSERT_TRUE(run);
  for (const bool find : {true, false}) {
    cromer::FitOptions options{.law = "viscous", .mass = 1, .find_drive = find};
    if (!find) options.drive_frequency = 2.3;
    const auto fit = cromer::fit(run->t, run->x, options);
    ASSERT_TRUE(fit) << fit.error().message();
    ASSERT_TRUE(fit->succeeded()) << fit->message;
    EXPECT_NEAR(fit->find("drive_frequency")->value, 2.3, 1e-6);
    EXPECT_NEAR(fit->find("drive_force")->value, 0.5, 1e-5);
  }
}

TEST(DoorFit, ProgressEndsIt) {
  const Swing made = swing(20000);
  int calls = 0;
  const auto fit = cromer::fit(made.t, made.y, {.progress = [&](double done) {
                                 EXPECT_GE(done, 0);
                                 EXPECT_LE(done, 1);
                                 return ++calls < 2;
                               }});
  ASSERT_TRUE(fit);
  EXPECT_GE(calls, 1);
}

TEST(DoorFit, OneLawIsHeardOfAndEndedAsWell) {
  const Swing made = swing(20000);
  std::vector<double> shares;
  const auto fit = cromer::fit(made.t, made.y, {.law = "viscous+drag", .progress = [&](double done) {
                                                  shares.push_back(done);
                                                  return false;
                                                }});
  ASSERT_TRUE(fit);
  EXPECT_EQ(shares.size(), 1u);
  EXPECT_TRUE(fit->interrupted);
  EXPECT_FALSE(fit->succeeded());
  EXPECT_THAT(fit->message, testing::HasSubstr("interrupted"));
}

TEST(DoorFit, ThreadsDoNotDisturbEachOther) {
  const Swing made = swing();
  const std::string alone = cromer::json(*cromer::fit(made.t, made.y));
  std::vector<std::string> found(4);
  std::vector<std::thread> threads;
  for (std::string& each : found)
    threads.emplace_back([&] { each = cromer::json(*cromer::fit(made.t, made.y)); });
  for (std::thread& each : threads) each.join();
  for (const std::string& each : found) EXPECT_EQ(each, alone);
}

TEST(DoorSimulate, ExactIsTheClosedForm) {
  const auto run = cromer::simulate({.mass = 1, .stiffness = 4},
                                    {.method = "exact", .position = 0.1, .step = 0.1, .until = 10});
  ASSERT_TRUE(run) << run.error().message();
  ASSERT_EQ(run->size(), 101u);
  ASSERT_EQ(run->energy.size(), 101u);
  for (std::size_t i = 0; i < run->size(); ++i) {
    EXPECT_NEAR(run->x[i], 0.1 * std::cos(2 * run->t[i]), 1e-14);
    EXPECT_NEAR(run->energy[i], 0.02, 1e-15);
  }
  EXPECT_TRUE(run->succeeded());
}

TEST(DoorSimulate, DefaultsNeverFail) {
  const auto run = cromer::simulate({});
  ASSERT_TRUE(run);
  EXPECT_TRUE(run->succeeded());
  EXPECT_NEAR(run->t.back(), 20 * 2 * std::numbers::pi, 1e-9);
  EXPECT_EQ(run->x.front(), 1);
}

TEST(DoorSimulate, TheMethodsShareIsThere) {
  const auto run =
      cromer::simulate(cromer::with_frequency(3, 0), {.method = "forward-euler", .step = 0.05, .until = 1});
  ASSERT_TRUE(run && run->effect);
  EXPECT_NEAR(*run->effect->decay_rate, -std::log(1 + 0.0225) / 2 / 0.05, 1e-12);
  EXPECT_FALSE(run->effect->stable);
}

TEST(DoorSimulate, DivergenceIsAStatus) {
  const auto run = cromer::simulate({.stiffness = -1, .damping = 0, .cubic = -1},
                                    {.method = "rk4", .position = 5, .step = 0.01, .until = 50});
  ASSERT_TRUE(run);
  EXPECT_EQ(run->status, cromer::Status::not_finite);
  EXPECT_FALSE(run->succeeded());
  EXPECT_THAT(run->message, HasSubstr("not finite"));
}

TEST(DoorSimulate, EveryDriveRuns) {
  const std::vector<double> samples(500, 1.0);
  const cromer::Drive drives[] = {cromer::Harmonic{1, 2},
                                  cromer::Unbalance{.mass = 0.1, .eccentricity = 0.05, .frequency = 2},
                                  cromer::ShakingBase{.displacement = 0.01, .frequency = 2},
                                  cromer::Pulse{.amplitude = 1},
                                  cromer::Pulse{cromer::Pulse::Shape::rectangular, 1, 0.1, 0.5},
                                  cromer::Pulse{cromer::Pulse::Shape::half_sine, 1, 0.1, 0.5},
                                  cromer::Pulse{cromer::Pulse::Shape::triangular, 1, 0.1, 0.5},
                                  cromer::Chirp{.amplitude = 1, .from = 1, .to = 5},
                                  cromer::Chirp{.amplitude = 1, .from = 1, .to = 5, .logarithmic = true},
                                  cromer::SampledForce{samples, 0.01},
                                  cromer::GroundMotion{samples, 0.01, cromer::BetweenSamples::hold}};
  for (const cromer::Drive& drive : drives) {
    const auto run = cromer::simulate({.mass = 1, .stiffness = 9, .damping = 0.5},
                                      {.method = "rk4", .drive = drive, .step = 0.01, .until = 4});
    ASSERT_TRUE(run) << drive.index() << ": " << run.error().message();
    EXPECT_TRUE(run->succeeded());
    EXPECT_EQ(run->x.front(), 0) << drive.index();
    EXPECT_NE(run->x.back(), 0) << drive.index();
  }
  // A constant force of 1 N and ground that accelerates by 1 m/s^2 push a mass of 1 kg opposite ways.
  const cromer::Oscillator law{.mass = 1, .stiffness = 9};
  const auto force =
      cromer::simulate(law, {.method = "exact", .drive = cromer::SampledForce{samples, 0.01}, .until = 4});
  const auto ground =
      cromer::simulate(law, {.method = "exact", .drive = cromer::GroundMotion{samples, 0.01}, .until = 4});
  ASSERT_TRUE(force && ground);
  EXPECT_NEAR(force->x.back(), -ground->x.back(), 1e-14);
  EXPECT_NEAR(force->x.back(), (1 - std::cos(12.0)) / 9, 1e-12);
}

TEST(DoorSimulate, ErrorsNameTheArgument) {
  const auto refused = [](const cromer::Oscillator& law, const cromer::SimulateOptions& options,
                          const char* argument) {
    const auto run = cromer::simulate(law, options);
    ASSERT_FALSE(run) << argument;
    EXPECT_EQ(run.error().argument, argument) << run.error().message();
    EXPECT_THAT(run.error().message(), Not(HasSubstr("--")));
  };
  refused({.mass = 0}, {}, "mass");
  refused({.mass = std::nan("")}, {}, "mass");
  refused({.damping = std::nan("")}, {}, "damping");
  refused({}, {.method = "rk5"}, "method");
  refused({}, {.step = 0.0}, "step");
  refused({}, {.position = 1e200}, "position");
  refused({}, {.velocity = 1e200}, "velocity");
  refused({}, {.step = 1e-12, .until = 1e9}, "step");
  refused({}, {.until = -1}, "until");
  refused({}, {.every = 0}, "every");
  refused({}, {.drive = cromer::Harmonic{-1, 2}}, "drive_amplitude");
  refused({}, {.drive = cromer::SampledForce{{}, 0.1}}, "force");
  refused({}, {.drive = cromer::Pulse{static_cast<cromer::Pulse::Shape>(9), 1, 1, 1}}, "shape");
  const std::vector<double> short_force(10, 1.0);
  refused({}, {.drive = cromer::SampledForce{short_force, 0.1}, .until = 50}, "force");
  const std::vector<double> bad{1, std::nan("")};
  refused({}, {.drive = cromer::GroundMotion{bad, 0.1}}, "acceleration");
  refused({}, {.drive = cromer::SampledForce{bad, 0}}, "spacing");
}

TEST(DoorSimulate, ProgressEndsIt) {
  double last = 0;
  const auto run = cromer::simulate(
      cromer::with_frequency(10, 0),
      {.method = "rk4", .step = 1e-4, .until = 2000, .every = 1000, .progress = [&](double done) {
         last = done;
         return done < 0.3;
       }});
  ASSERT_TRUE(run);
  EXPECT_TRUE(run->interrupted);
  EXPECT_FALSE(run->succeeded());
  EXPECT_GE(last, 0.3);
  EXPECT_LT(run->t.back(), 2000);
  EXPECT_GT(run->size(), 100u);
}

TEST(DoorMethods, TheRegistryAndItsEffects) {
  const auto all = cromer::methods();
  ASSERT_GE(all.size(), 13u);
  EXPECT_EQ(all.front().name, "forward-euler");
  EXPECT_FALSE(all.front().effect);
  const auto effects = cromer::methods({.natural_frequency = 2, .damping_ratio = 0, .step = 0.1});
  ASSERT_TRUE(effects);
  for (const auto& each : *effects) {
    if (each.name == "euler-cromer") {
      EXPECT_NEAR(*each.effect->stability_limit, 1, 1e-9);
    }
  }
  const auto wrong = cromer::methods({.natural_frequency = 2, .step = 0});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().argument, "step");
}

TEST(DoorSpectrum, HalfSineHasItsClosedForm) {
  // Undamped, during a half sine of duration d = T: the largest response is known from Chopra, Dynamics of
  // Structures, 4.8.
  std::vector<double> acceleration;
  for (int i = 0; i <= 4000; ++i)
    acceleration.push_back(i <= 1000 ? std::sin(std::numbers::pi * i / 1000) : 0);
  const std::vector<double> periods{0.5};  // d = 0.5 s
  const auto spectrum =
      cromer::response_spectrum(acceleration, 5e-4, {.damping_ratio = 0, .periods = periods});
  ASSERT_TRUE(spectrum) << spectrum.error().message();
  // x'' + w^2 x = sin(W t), W = w/2: x = (sin W t - (W/w) sin w t)/(w^2 - W^2), largest at t = 2 pi/(w + W).
  const double w = 4 * std::numbers::pi, W = w / 2, t = 2 * std::numbers::pi / (w + W);
  const double largest = (std::sin(W * t) - W / w * std::sin(w * t)) / (w * w - W * W);
  EXPECT_NEAR(spectrum->displacement[0] / largest, 1, 2e-6);
  EXPECT_NEAR(spectrum->pseudo_acceleration[0], w * w * spectrum->displacement[0], 1e-14);
  EXPECT_NEAR(spectrum->peak_acceleration, 1, 1e-12);
  const auto two =
      cromer::response_spectrum(acceleration, 5e-4, {.periods = periods, .second = acceleration});
  ASSERT_TRUE(two);
  EXPECT_NEAR(two->rotd100[0] / two->displacement[0], std::sqrt(2), 1e-9);
  // Undamped, the mass's absolute acceleration is w^2 x, and w x its pseudo-velocity.
  for (const auto& [of, scale] : {std::pair{cromer::ShockResponse::absolute_acceleration, w * w},
                                  std::pair{cromer::ShockResponse::pseudo_velocity, w}}) {
    const auto shock =
        cromer::response_spectrum(acceleration, 5e-4, {.damping_ratio = 0, .shock = of, .periods = periods});
    ASSERT_TRUE(shock) << shock.error().message();
    ASSERT_EQ(shock->shock.size(), 1u);
    EXPECT_NEAR(shock->shock[0].maximax() / (scale * largest), 1, 2e-6);
    EXPECT_TRUE(shock->displacement.empty() && shock->pseudo_velocity.empty());
  }
}

TEST(DoorSpectrum, ASpringYieldsAtItsDuctility) {
  // A step of the ground's acceleration, undamped: the elastic spring reaches 2 a/w^2. One that yields at u_y
  // does the step's work: a u = w^2 (u_y u - u_y^2/2), so u_y = a/w^2 2 mu/(2 mu - 1) for a ductility mu.
  const std::vector<double> step(2001, 1.0), periods{1};
  const double w = 2 * std::numbers::pi, ductility = 4;
  const auto spectrum =
      cromer::response_spectrum(step, 1e-3, {.damping_ratio = 0, .ductility = ductility, .periods = periods});
  ASSERT_TRUE(spectrum) << spectrum.error().message();
  EXPECT_NEAR(spectrum->displacement[0] * w * w, 2 * ductility / (2 * ductility - 1), 1e-6);
}

TEST(DoorSpectrum, ErrorsNameTheArgument) {
  const std::vector<double> a(100, 1.0), negative{-1}, short_one(3);
  const auto refused = [](const auto& result, const char* argument) {
    ASSERT_FALSE(result) << argument;
    EXPECT_EQ(result.error().argument, argument) << result.error().message();
  };
  refused(cromer::response_spectrum({}, 0.01), "acceleration");
  refused(cromer::response_spectrum(a, 0), "spacing");
  refused(cromer::response_spectrum(a, 0.01, {.peaks = static_cast<cromer::Peaks>(9)}), "peaks");
  refused(cromer::response_spectrum(a, 0.01, {.damping_ratio = -1}), "damping_ratio");
  refused(cromer::response_spectrum(a, 0.01, {.periods = negative}), "periods");
  refused(cromer::response_spectrum(a, 0.01, {.second = short_one}), "second");
  refused(cromer::response_spectrum(a, 0.01, {.ductility = 0.5}), "ductility");
  refused(cromer::response_spectrum(a, 0.01, {.ductility = 2, .second = a}), "ductility");
  refused(cromer::response_spectrum(a, 0.01, {.shock = static_cast<cromer::ShockResponse>(5)}), "shock");
  refused(cromer::response_spectrum(a, 0.01, {.shock = cromer::ShockResponse{}, .second = a}), "shock");
}

TEST(DoorSweep, TheResonanceCurveIsKnown) {
  const cromer::Oscillator law{.mass = 2, .stiffness = 18, .damping = 0.6};
  const std::vector<double> frequencies{1, 2.9, 3, 3.1, 10};
  const auto swept = cromer::sweep(law, frequencies, {.method = "exact", .drive_amplitude = 0.5});
  ASSERT_TRUE(swept) << swept.error().message();
  ASSERT_EQ(swept->amplitude.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const double w = frequencies[i], real = 18 - 2 * w * w, imaginary = 0.6 * w;
    EXPECT_EQ(swept->frequency[i], w);
    EXPECT_NEAR(swept->amplitude[i], 0.5 / std::hypot(real, imaginary), 1e-12);
    EXPECT_NEAR(swept->phase[i], std::atan2(imaginary, real), 1e-12);
  }
  const auto one = cromer::sweep(law, std::vector<double>{3}, {.method = "exact"});
  ASSERT_TRUE(one) << one.error().message();
  ASSERT_EQ(one->amplitude.size(), 1u);
  EXPECT_EQ(one->frequency[0], 3);
}

TEST(DoorSweep, SaysOfEachPointHowItEnded) {
  const std::vector<double> frequencies{1, 2};
  const auto undamped = cromer::sweep({.stiffness = 4}, frequencies, {.method = "exact"});
  ASSERT_TRUE(undamped);
  ASSERT_EQ(undamped->status.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(std::isnan(undamped->amplitude[i]), undamped->status[i] != "settled");
  const std::vector<double> never{1e-300};
  const auto hopeless = cromer::sweep({.damping = 0.1, .cubic = 1}, never, {.method = "rk4"});
  EXPECT_TRUE(!hopeless || std::isnan(hopeless->amplitude[0]));
}

TEST(DoorSweep, ErrorsNameTheArgument) {
  const auto wrong = static_cast<cromer::SweepOptions::Direction>(4);
  EXPECT_EQ(cromer::sweep({}, std::vector<double>{1}, {.direction = wrong}).error().argument, "direction");
  EXPECT_EQ(cromer::sweep({}, {}).error().argument, "drive_frequency");
  const std::vector<double> one{1};
  EXPECT_EQ(cromer::sweep({}, one, {.drive_amplitude = 0}).error().argument, "drive_amplitude");
  EXPECT_EQ(cromer::sweep({}, one, {.method = "rk5"}).error().argument, "method");
  EXPECT_EQ(cromer::sweep({.mass = -1}, one).error().argument, "mass");
  EXPECT_EQ(cromer::sweep({}, std::vector<double>{0}).error().argument, "drive_frequency");
  const cromer::Oscillator loop{.hysteresis_stiffness = 5, .hysteresis_beta = 3, .hysteresis_gamma = 1};
  EXPECT_EQ(cromer::sweep(loop, one).error().argument, "hysteresis_stiffness");
}

TEST(DoorRead, ColumnsComeWithTheirUnits) {
  const std::string text = "Time (s);Ort (mm)\n0,0;1,5\n0,1;2,5\n0,2;\n0,3;4,5\n";
  const auto recording = cromer::read(std::as_bytes(std::span(text.data(), text.size())), "lab.csv");
  ASSERT_TRUE(recording) << recording.error().message();
  ASSERT_EQ(recording->columns.size(), 2u);
  EXPECT_EQ(recording->columns[1].unit, "mm");
  EXPECT_EQ(recording->columns[1].values[1], 2.5);
  EXPECT_TRUE(std::isnan(recording->columns[1].values[2]));
  const cromer::Column* found = recording->find("Ort");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->values.size(), 4u);
  EXPECT_EQ(recording->find("Masse"), nullptr);
  // The values stay where they are as long as a copy is alive.
  cromer::Recording copy;
  {
    const auto again = cromer::read(std::as_bytes(std::span(text.data(), text.size())));
    copy = *again;
  }
  EXPECT_EQ(copy.columns[1].values[0], 1.5);
}

TEST(DoorRead, AFileIsFittedAndCompared) {
  const std::string folder = CROMER_SOURCE_DIR "/data/";
  const auto recording = cromer::read_file(folder + "recording1.csv");
  ASSERT_TRUE(recording) << recording.error().message();
  const auto fits = cromer::fit(*recording, {.mass = {0.2176, 0.0003}, .to = 20.0});
  ASSERT_TRUE(fits) << fits.error().message();
  ASSERT_FALSE(fits->empty());
  EXPECT_TRUE(fits->front().succeeded()) << fits->front().message;
  EXPECT_THAT(fits->front().file, HasSubstr("recording1.csv"));
  const auto compared = cromer::compare(fits->front(), {.method = "rk4"});
  ASSERT_TRUE(compared) << compared.error().message();
  ASSERT_FALSE(compared->curves.empty());
  EXPECT_TRUE(compared->complete);
  EXPECT_FALSE(compared->explanation.empty());
  EXPECT_LT(compared->curves.back().rms, 0.01);
  EXPECT_EQ(cromer::compare(fits->front(), {.method = "rk5"}).error().argument, "method");
  EXPECT_EQ(cromer::compare(cromer::LawFit{}).error().argument, "fit");
  EXPECT_EQ(cromer::fit(cromer::Recording{}).error().argument, "recording");
  EXPECT_FALSE(cromer::read_file(folder + "no such file.csv"));
  EXPECT_EQ(cromer::read_file(folder + "recording1.csv", {.rate = -1}).error().argument, "rate");
}

/// The notice of that code; nullptr where there is none.
const cromer::Notice* find(const std::vector<cromer::Notice>& notices, std::string_view code) {
  for (const cromer::Notice& each : notices)
    if (each.code == code) return &each;
  return nullptr;
}

TEST(DoorNotices, HaveCodesSeveritiesAndSentences) {
  const auto run =
      cromer::simulate(cromer::with_frequency(3, 0), {.method = "forward-euler", .step = 0.05, .until = 1});
  ASSERT_TRUE(run) << run.error().message();
  const cromer::Notice* grows = find(run->notices, "unstable_at_any_step");
  ASSERT_NE(grows, nullptr);
  EXPECT_EQ(severity(*grows), cromer::Severity::wrong_if_ignored);
  EXPECT_EQ(text(*grows), "forward-euler is unstable for this law whatever the step: the motion will grow");
  EXPECT_EQ(text(*grows, cromer::Language::german),
            "forward-euler ist bei diesem Gesetz mit jedem Schritt instabil: die Bewegung wird wachsen");
  const auto too_long = cromer::simulate(cromer::with_frequency(3, 0), {.step = 1.0, .until = 10});
  ASSERT_TRUE(too_long) << too_long.error().message();
  const cromer::Notice* step = find(too_long->notices, "step_beyond_stability");
  ASSERT_NE(step, nullptr);
  EXPECT_THAT(text(*step), testing::StartsWith("step: 1 s is beyond the stability limit"));
  EXPECT_THAT(text(*step, cromer::Language::german), HasSubstr("liegt über der Stabilitätsgrenze"));
}

TEST(DoorNotices, AreOfSamplesWhereArraysWereGiven) {
  Swing made = swing();
  made.y[700] += 1;
  const auto fit = cromer::fit(made.t, made.y, {.law = "viscous"});
  ASSERT_TRUE(fit) << fit.error().message();
  const cromer::Notice* out = find(fit->notices, "samples_stick_out");
  ASSERT_NE(out, nullptr);
  EXPECT_EQ(severity(*out), cromer::Severity::worth_knowing);
  EXPECT_TRUE(out->of_arrays);
  EXPECT_EQ(text(*out), "1 sample sticks out alone, the first in sample 700");
  EXPECT_THAT(text(*out, cromer::Language::german), HasSubstr("in Messwert 700"));
  for (const cromer::Notice& each : fit->notices) {
    EXPECT_THAT(text(each), Not(HasSubstr("--")));
    EXPECT_THAT(text(each), Not(testing::ContainsRegex("line [0-9]")));
    EXPECT_FALSE(text(each, cromer::Language::german).empty());
    EXPECT_NE(text(each, cromer::Language::german), text(each));
  }
}

TEST(DoorNotices, OfFilesSayWhatWasDone) {
  const std::string text = "Time (s);Ort\n0,0;1,5\nbroken;row\n0,1;2,5\n0,2;3,5\n0,3;4,5\n";
  const auto recording =
      cromer::read(std::as_bytes(std::span(text.data(), text.size())), "lab.csv", {.skip_bad_rows = true});
  ASSERT_TRUE(recording) << recording.error().message();
  const cromer::Notice* rows = find(recording->notices, "bad_rows_left_out");
  ASSERT_NE(rows, nullptr);
  EXPECT_EQ(severity(*rows), cromer::Severity::detail);
  EXPECT_FALSE(rows->of_arrays);
  EXPECT_EQ(cromer::text(*rows), "1 bad row left out, the first in line 3");
  ASSERT_EQ(rows->values.size(), 2u);
  EXPECT_EQ(rows->values[0], cromer::NoticeValue("rows", 1));
  EXPECT_EQ(rows->values[1], cromer::NoticeValue("line", 3));
}

TEST(DoorErrors, AreData) {
  const Swing made = swing();
  const auto refused = cromer::fit(made.t, std::vector<double>(7));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().notice.code, "lengths_differ");
  EXPECT_EQ(refused.error().argument, "y");
  EXPECT_EQ(refused.error().message(), "y has 7 values and t has 2000: both need the same number");
  EXPECT_EQ(refused.error().message(cromer::Language::german),
            "y hat 7 Werte und t hat 2000: es müssen gleich viele sein");
  const auto mass = cromer::fit(made.t, made.y, {.mass = -1});
  ASSERT_FALSE(mass);
  EXPECT_EQ(mass.error().notice.code, "option_is_wrong");
  EXPECT_EQ(mass.error().argument, "mass");
  EXPECT_EQ(mass.error().message(), "mass: it must be positive, not -1 kg");
  EXPECT_THAT(mass.error().message(cromer::Language::german), testing::StartsWith("mass: das muss größer"));
  const auto before = cromer::fit(made.t, made.y, {.law = "viscous"})->at(std::vector<double>{-1.5});
  ASSERT_FALSE(before);
  EXPECT_EQ(
      before.error().message(),
      "t begins at -1.5 s, before the first used sample, 0 s: the law says nothing about earlier times");
  EXPECT_THAT(before.error().message(cromer::Language::german), HasSubstr("-1,5 s"));
}

TEST(DoorErrors, OfFitsThatAreEmptyOrFailedSayWhy) {
  EXPECT_EQ(cromer::LawFit{}.oscillator().error().notice.code, "fit_is_empty");
  EXPECT_EQ(cromer::compare(cromer::LawFit{}).error().notice.code, "fit_is_empty");
  const auto failed = cromer::fit(std::vector<double>{0, 1, 2}, std::vector<double>{1, 2, 1});
  ASSERT_TRUE(failed);
  const auto motion = failed->motion();
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error().argument, "fit");
  EXPECT_EQ(motion.error().message(), "the fit has no values: " + failed->message);
  EXPECT_THAT(motion.error().message(cromer::Language::german),
              testing::StartsWith("die Anpassung hat keine Werte: "));
  EXPECT_EQ(cromer::compare(*failed).error().message(),
            "the fit has no law to be compared: " + failed->message);
}

TEST(DoorDocument, SpeaksGermanWhereAsked) {
  const auto run =
      cromer::simulate(cromer::with_frequency(3, 0), {.method = "forward-euler", .step = 0.05, .until = 1});
  ASSERT_TRUE(run);
  const auto document = nlohmann::json::parse(cromer::json(*run, false, cromer::Language::german));
  ASSERT_EQ(document["warnings"].size(), run->notices.size());
  ASSERT_EQ(document["notices"].size(), run->notices.size());
  for (std::size_t i = 0; i < run->notices.size(); ++i) {
    EXPECT_EQ(document["warnings"][i], text(run->notices[i], cromer::Language::german));
    EXPECT_EQ(document["notices"][i]["code"], run->notices[i].code);
  }
  const auto english = nlohmann::json::parse(cromer::json(*run, false));
  for (std::size_t i = 0; i < run->notices.size(); ++i)
    EXPECT_EQ(english["notices"][i]["text"], text(run->notices[i]));
}

TEST(DoorDocument, IsTheProgramsJson) {
  const auto run = cromer::simulate({.stiffness = 4}, {.step = 0.1, .until = 1});
  const auto document = nlohmann::json::parse(cromer::json(*run));
  EXPECT_EQ(document["runs"][0]["method"], "euler-cromer");
  EXPECT_TRUE(document["runs"][0].contains("states"));
  EXPECT_FALSE(nlohmann::json::parse(cromer::json(*run, false))["runs"][0].contains("states"));
  const Swing made = swing();
  const auto fit = cromer::fit(made.t, made.y);
  EXPECT_EQ(nlohmann::json::parse(cromer::json(*fit))["status"], "converged");
  const auto compared = cromer::compare(*fit);
  EXPECT_TRUE(nlohmann::json::parse(cromer::json(*compared)).contains("curves"));
}

/// The lines of a document.
std::vector<std::string> lines_of(const std::string& document) {
  std::vector<std::string> lines;
  std::istringstream stream(document);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(DoorModes, OfANetworkInAFile) {
  const std::string frame = std::string(CROMER_SOURCE_DIR) + "/data/networks/frame.toml";
  const auto found = cromer::modes(frame, {.method = {"newmark"}, .step = 0.02});
  ASSERT_TRUE(found) << found.error().message();
  EXPECT_THAT(found->names, testing::ElementsAre("floor 1", "floor 2", "roof"));
  ASSERT_EQ(found->modes.size(), 3u);
  double shares = 0;
  for (const cromer::Mode& mode : found->modes) {
    EXPECT_GT(mode.frequency.value, 2);
    EXPECT_EQ(mode.frequency.standard_error, 0);
    EXPECT_EQ(mode.shape.size(), 3u);
    ASSERT_EQ(mode.methods.size(), 1u);
    EXPECT_LT(*mode.methods[0].frequency, mode.frequency.value);
    EXPECT_TRUE(mode.methods[0].stable);
    shares += *mode.participation;
  }
  EXPECT_NEAR(shares, 1, 1e-3);
  EXPECT_THAT(cromer::json(*found), HasSubstr("\"participation\""));
  EXPECT_EQ(lines_of(cromer::csv(*found)).size(), 4u);
  EXPECT_EQ(cromer::json(cromer::Modes{}), "");
  const auto refused = cromer::modes(frame, {.method = {"newmark"}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message(), "method needs a step");
  EXPECT_FALSE(cromer::modes("nowhere.toml"));
}

TEST(DoorDocument, TablesBeginWithTheirHeader) {
  const auto run = cromer::simulate({.stiffness = 4}, {.step = 0.1, .until = 1});
  const auto states = lines_of(cromer::csv(*run));
  ASSERT_EQ(states.size(), run->size() + 1);
  EXPECT_EQ(states[0], "run,t (s),x (m),v (m/s),energy (J)");
  EXPECT_EQ(states[1], "1,0,1,0,2");
  const Swing made = swing();
  const auto fit = cromer::fit(made.t, made.y);
  const auto law = lines_of(cromer::csv(*fit));
  ASSERT_EQ(law.size(), 2u);
  EXPECT_THAT(law[0], testing::StartsWith("file,run,column,law,status,"));
  const auto compared = lines_of(cromer::csv(*cromer::compare(*fit)));
  EXPECT_THAT(compared.front(), testing::StartsWith("run,curve,t (s),"));
  const double frequencies[] = {1.0, 1.5};
  const auto response = lines_of(cromer::csv(*cromer::sweep({.damping = 0.1}, frequencies)));
  ASSERT_EQ(response.size(), 3u);
  EXPECT_EQ(response[0], "drive_frequency (rad/s),amplitude (m),phase (rad)");
  const double periods[] = {0.5, 1, 2};
  const auto spectrum = lines_of(cromer::csv(*cromer::response_spectrum(made.y, 0.01, {.periods = periods})));
  ASSERT_EQ(spectrum.size(), 4u);
  EXPECT_EQ(spectrum[0], "period (s),damping_ratio,SD (m),PSV (m/s),PSA (m/s²)");
}

TEST(DoorDocument, FiguresAreSvg) {
  const auto run = cromer::simulate({.stiffness = 4}, {.step = 0.1, .until = 1});
  const Swing made = swing();
  const auto fit = cromer::fit(made.t, made.y);
  const double frequencies[] = {0.5, 1.0, 1.5}, periods[] = {0.5, 1, 2};
  const std::string pictures[] = {
      cromer::svg(*run), cromer::svg(*fit), cromer::svg(*cromer::compare(*fit)),
      cromer::svg(*cromer::sweep({.damping = 0.1}, frequencies)),
      cromer::svg(*cromer::response_spectrum(made.y, 0.01, {.periods = periods}))};
  for (const std::string& each : pictures) {
    EXPECT_THAT(each, HasSubstr("<svg"));
    EXPECT_THAT(each, testing::EndsWith("</svg>\n"));
    EXPECT_THAT(each, HasSubstr("<path"));
  }
}

TEST(DoorDocument, OfNothingThereIsNone) {
  EXPECT_EQ(cromer::csv(cromer::LawFit{}), "");
  EXPECT_EQ(cromer::csv(cromer::Simulation{}), "");
  EXPECT_EQ(cromer::csv(cromer::FrequencyResponse{}), "");
  EXPECT_EQ(cromer::svg(cromer::LawFit{}), "");
  EXPECT_EQ(cromer::svg(cromer::Comparison{}), "");
  EXPECT_EQ(cromer::svg(cromer::ResponseSpectrum{}), "");
}

TEST(DoorQuantity, TextIsReadAndWritten) {
  const auto mass = cromer::parse_quantity("217.6 ± 0.3 g", "kg");
  ASSERT_TRUE(mass);
  EXPECT_DOUBLE_EQ(mass->value, 0.2176);
  EXPECT_DOUBLE_EQ(mass->uncertainty, 0.0003);
  EXPECT_THAT(cromer::format_quantity(*mass, "kg"), HasSubstr("0.2176"));
  EXPECT_THAT(cromer::parse_quantity("5 N", "kg").error().message(), HasSubstr("is a force"));
}

}  // namespace CROMER_FILE
