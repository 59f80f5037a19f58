// How much work a fit takes, counted in steps of motions, which are the same on every machine: worse start
// values still lead to the minimum, and only this test shows it.
#include <gtest/gtest.h>

#include <string>

#include "tests/identify/forced_truth.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

Motion swing_of(const std::string& law) {
  Motion motion{.law = law_of(law), .equilibrium = 0.2, .position = 0.5, .velocity = 0.3};
  motion.set_angular_frequency(6);
  if (motion.law.has<Viscous>()) motion.set_decay_rate(0.04);
  if (motion.law.has<Drag>()) motion.per_mass.drag = 0.2;
  if (motion.law.has<Friction>()) motion.per_mass.friction = 0.1;
  if (motion.law.has<Cubic>()) motion.per_mass.cubic = 20;
  if (motion.law.has<OddQuadratic>()) motion.per_mass.odd_quadratic = -5;
  if (motion.law.has<Quintic>()) motion.per_mass.quintic = 20;
  if (motion.law.has<Hysteresis>()) {
    motion.per_mass.hysteresis_stiffness = 12;
    motion.per_mass.hysteresis_beta = 1.5;
    motion.per_mass.hysteresis_gamma = -0.5;
  }
  return motion;
}

const std::vector<double> times = even_times(1500, 0.02);

/// Steps, in thousands, that a fit or a choice of the law takes.
template <class Fit>
double thousands_of_steps(const Fit& fit) {
  constexpr double many = 1e9;
  Watch watch;
  watch.steps_left = std::make_shared<std::atomic<double>>(many);
  fit(watch);
  return (many - *watch.steps_left) / 1000;
}

TEST(Effort, OfAFreeFit) {
  const std::pair<const char*, double> most[] = {
      {"viscous+drag", 10.5},          {"drag+friction", 35},      {"viscous+cubic", 11.5},
      {"viscous+odd-quadratic", 10.5}, {"viscous+quintic", 10.8},  {"viscous+pendulum", 10},
      {"viscous+friction+cubic", 30},  {"viscous+hysteresis", 385}};
  for (const auto& [law, thousands] : most) {
    const std::vector<double> y = noisy(observed_motion(swing_of(law), {}, times, 0, 0.002), 1e-3);
    const double took = thousands_of_steps([&, &law = law](const Watch& watch) {
      const LawFit fit = fit_law({times, y}, {.law = law_of(law)}, watch);
      EXPECT_EQ(fit.status, FitStatus::converged) << law;
    });
    EXPECT_LE(took, thousands) << law;
  }
}

TEST(Effort, OfAHarmonicallyDrivenFit) {
  const std::pair<const char*, double> most[] = {
      {"viscous", 21}, {"viscous+drag", 23}, {"viscous+cubic", 26}, {"friction", 23}};
  for (const auto& [law, thousands] : most) {
    Motion motion = swing_of(law);
    motion.cosine = 8;
    motion.sine = 3;
    motion.drive_frequency = 4.7;
    const std::vector<double> y = noisy(observed_motion(motion, Drive::harmonic(), times, 0, 0.002), 1e-3);
    const double took = thousands_of_steps([&, &law = law](const Watch& watch) {
      const LawFit fit = fit_law({times, y}, {.law = law_of(law), .drive = Drive::harmonic()}, watch);
      EXPECT_EQ(fit.status, FitStatus::converged) << law;
    });
    EXPECT_LE(took, thousands) << law;
  }
}

TEST(Effort, OfAForcedFit) {
  const std::pair<const char*, double> most[] = {
      {"viscous", 56.5}, {"viscous+drag", 38}, {"viscous+cubic", 79}, {"viscous+quadratic", 56.5}};
  const auto acting = multisine(15, 3);
  std::vector<double> force;
  for (const double each : times) force.push_back(acting(each));
  const Drive drive = Drive::recorded({force, 0, 0.02, BetweenSamples::linear});
  for (const auto& [law, thousands] : most) {
    Motion motion = swing_of(law);
    motion.force_gain = 5;
    const std::vector<double> y = noisy(observed_motion(motion, drive, times, 0, 0.002), 1e-3);
    const double took = thousands_of_steps([&, &law = law](const Watch& watch) {
      const LawFit fit = fit_law({times, y}, {.law = law_of(law), .drive = drive}, watch);
      EXPECT_EQ(fit.status, FitStatus::converged) << law;
    });
    EXPECT_LE(took, thousands) << law;
  }
}

TEST(Effort, OfAChoiceOfTheLaw) {
  const std::pair<const char*, double> most[] = {
      {"viscous", 190}, {"viscous+drag", 440}, {"friction", 202}, {"viscous+cubic", 292}};
  for (const auto& [law, thousands] : most) {
    const std::vector<double> y = noisy(observed_motion(swing_of(law), {}, times, 0, 0.002), 1e-3);
    const double took = thousands_of_steps([&, &law = law](const Watch& watch) {
      EXPECT_EQ(choose_law({times, y}, {}, watch).chosen.law, law_of(law));
    });
    EXPECT_LE(took, thousands) << law;
  }
}

// More than the choice looks at.
TEST(Effort, OfAChoiceFromALongRecord) {
  const std::vector<double> t = even_times(60'000, 0.002);
  Motion motion = swing_of("viscous+drag");
  motion.per_mass.drag = 0.05;
  const std::vector<double> y = noisy(observed_motion(motion, {}, t, 0, 0.01), 1e-3);
  const double took = thousands_of_steps([&](const Watch& watch) {
    EXPECT_EQ(choose_law({t, y}, {}, watch).chosen.law, law_of("viscous+drag"));
  });
  EXPECT_LE(took, 8200);
}

TEST(Effort, OfAChoiceWithGapsAndUnevenTimes) {
  std::vector<double> t;
  for (std::size_t i = 0; i < 1500; ++i)
    if (i % 300 > 40) t.push_back(0.02 * static_cast<double>(i) + 0.004 * static_cast<double>(i % 3));
  const std::vector<double> y = noisy(observed_motion(swing_of("viscous+cubic"), {}, t, 0, 0.002), 1e-3);
  const double took = thousands_of_steps([&](const Watch& watch) {
    EXPECT_EQ(choose_law({t, y}, {}, watch).chosen.law, law_of("viscous+cubic"));
  });
  EXPECT_LE(took, 265);
}

TEST(Effort, OfAChoiceUnderADrive) {
  Motion motion = swing_of("viscous+cubic");
  motion.cosine = 8;
  motion.drive_frequency = 4.7;
  const std::vector<double> y = noisy(observed_motion(motion, Drive::harmonic(), times, 0, 0.002), 1e-3);
  const double took = thousands_of_steps([&](const Watch& watch) {
    EXPECT_EQ(choose_law({times, y}, {.drive = Drive::harmonic()}, watch).chosen.law,
              law_of("viscous+cubic"));
  });
  EXPECT_LE(took, 265);
}

TEST(Effort, OfAChoiceUnderARecordedForce) {
  const auto acting = multisine(15, 3);
  std::vector<double> force;
  for (const double each : times) force.push_back(acting(each));
  const Drive drive = Drive::recorded({force, 0, 0.02, BetweenSamples::linear});
  Motion motion = swing_of("viscous+cubic");
  motion.force_gain = 5;
  const std::vector<double> y = noisy(observed_motion(motion, drive, times, 0, 0.002), 1e-3);
  const double took = thousands_of_steps([&](const Watch& watch) {
    EXPECT_EQ(choose_law({times, y}, {.drive = drive}, watch).chosen.law, law_of("viscous+cubic"));
  });
  EXPECT_LE(took, 1650);
}

TEST(Effort, OfTheClosedFormIsAFewIterations) {
  const std::vector<double> y = noisy(observed_motion(swing_of("viscous"), {}, times, 0, 0.002), 1e-3);
  EXPECT_LE(fit_law({times, y}, {.law = law_of("viscous")}).iterations, 2);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
