// Laws without a closed form.
#include "cromer/identify/motion/motion_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "tests/identify/synthetic.h"
#include "tests/support/cases.h"

namespace cromer::core {
namespace CROMER_FILE {

const TrueSwing disc{.angular_frequency = 8.849,
                     .decay_rate = 0.0018,
                     .drag = 0.0939,
                     .cubic = 0,
                     .equilibrium = 0.2,
                     .position = 0.036,
                     .velocity = 0};

SyntheticRecord motion_record(const Motion& motion, const std::vector<double>& t, double noise,
                              double resolution = 0, unsigned seed = 1) {
  SyntheticRecord record{t, free_motion(motion, t, 5e-4).x, resolution};
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  for (double& y : record.y) {
    y += motion.equilibrium + (noise > 0 ? noise * normal(engine) : 0);
    if (resolution > 0) y = resolution * std::round(y / resolution);
  }
  return record;
}

TEST(FreeMotion, IsTheClosedFormWithoutDragAndCubic) {
  const ViscousTruth truth;
  const std::vector<double> t = even_times(3000, 0.01);
  const TrueSwing motion{.angular_frequency = truth.w0,
                         .decay_rate = truth.g,
                         .position = truth.position,
                         .velocity = truth.velocity};
  const Trajectory x = free_motion(motion, t, 5e-4);
  const SyntheticRecord exact = viscous_record(truth, t);
  for (std::size_t i = 0; i < t.size(); ++i) EXPECT_NEAR(x.x[i], exact.y[i] - truth.equilibrium, 1e-10);
}

TEST(FreeMotion, DragAloneLosesAmplitudeAsTheTurningPointsSay) {
  // From turning point to turning point (1 + 2 q x) e^{-2 q x} is conserved, x the displacement towards the
  // side it comes from: the energy equation of x'' + q x'|x'| + w² x = 0 integrated over half a swing.
  const TrueSwing motion{.angular_frequency = 3, .drag = 2, .position = 0.5};
  double t = 0;
  const Trajectory run = free_motion(motion, even_times(4000, 5e-4), 5e-4);
  std::size_t i = 10;
  while (run.v[i] < 0) ++i;
  t = run.t[i];
  ASSERT_GT(t, 0.5);
  const double share = run.v[i - 1] / (run.v[i - 1] - run.v[i]);
  const double x = run.x[i - 1] + share * (run.x[i] - run.x[i - 1]);  // negative: the far turning point
  const auto invariant = [&](double at) {
    return (1 + 2 * motion.drag * at) * std::exp(-2 * motion.drag * at);
  };
  EXPECT_NEAR(invariant(x), invariant(motion.position), 1e-6);
}

TEST(FreeMotion, StepKeepsTheMotionWithinItsError) {
  const std::vector<double> t{0, 100};
  for (double error : {1e-3, 1e-5, 1e-7}) {
    const double coarse = free_motion(disc, t, motion_step(8.849, 100, error)).x[1];
    const double fine = free_motion(disc, t, 5e-4).x[1];
    EXPECT_NEAR(coarse, fine, 2 * error * 0.036);
  }
}

TEST(FreeMotion, DerivativesAreThoseOfSmallChanges) {
  const Law law = law_of("viscous+drag+cubic");
  TrueSwing swing = disc;
  swing.cubic = 500;
  const Motion motion = swing;
  const FittedParameters fitted = fitted_parameters(law, DriveKind::none, {}, motion);
  const auto velocity = [&](const Motion& m) {
    return free_motion(m, std::vector<double>{0, 3.3}, 1e-3).v[1];
  };
  const VelocityGradient gradient = velocity_gradient(fitted, motion, 3.3, 1e-3);
  EXPECT_NEAR(gradient.velocity, velocity(motion), 1e-14);
  for (int i = 0; i < fitted.count; ++i) {
    Motion up = motion, down = motion;
    const double value = fitted.of[i].of(motion), step = 1e-5 * std::max(1e-2, std::abs(value));
    fitted.of[i].set(up, value + step);
    fitted.of[i].set(down, value - step);
    const double slope = (velocity(up) - velocity(down)) / (2 * step);
    EXPECT_NEAR(gradient.derivative[i], slope, 1e-6 * (std::abs(slope) + 1e-4)) << fitted.of[i].name;
  }
}

TEST(FreeMotion, AtItsStartTheVelocityIsItsOwn) {
  const Motion motion = disc;
  const FittedParameters fitted = fitted_parameters(motion.law, DriveKind::none, {}, motion);
  const VelocityGradient gradient = velocity_gradient(fitted, motion, 0, 1e-3);
  EXPECT_EQ(gradient.velocity, motion.velocity);
  for (int i = 0; i < fitted.count; ++i)
    EXPECT_EQ(gradient.derivative[i], fitted.of[i].name == "velocity" ? 1 : 0) << fitted.of[i].name;
}

TEST(FreeMotion, AtNoTimesIsNone) {
  EXPECT_TRUE(motion_states(disc, {}, {}, 1e-3).t.empty());
  EXPECT_TRUE(observed_motion(disc, {}, {}, 0, 1e-3).empty());
  const SyntheticRecord record = motion_record(disc, even_times(300, 0.05), 0);
  const Trajectory none = motion_of(fit_law(record.record(), {.law = law_of("viscous")}), {});
  EXPECT_TRUE(none.t.empty());
  EXPECT_TRUE(none.x.empty());
}

TEST(FreeMotion, RecoversDragAndCubicWithoutNoise) {
  TrueSwing motion = disc;
  motion.cubic = -600;
  const SyntheticRecord record = motion_record(motion, even_times(3000, 0.01), 0);
  const LawFit fit = fit_law(record.record(), {.law = law_of("viscous+drag+cubic")});
  ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  EXPECT_NEAR(fit.angular_frequency().value, motion.angular_frequency, 1e-8);
  EXPECT_NEAR(fit.decay_rate().value, motion.decay_rate, 1e-8);
  EXPECT_NEAR(fit["drag"].value, motion.drag, 1e-7);
  EXPECT_NEAR(fit["cubic"].value, motion.cubic, 1e-4);
  EXPECT_NEAR(fit.position().value, motion.position, 1e-9);
}

TEST(FreeMotion, RecoversAPendulumsLargeSwings) {
  // Released at 1.5 rad the frequency changes by a sixth along the record: no single sinusoid keeps count of
  // the periods.
  const TrueSwing motion{.angular_frequency = 4, .decay_rate = 0.03, .cubic = -16.0 / 6, .position = 1.2};
  const SyntheticRecord record = motion_record(motion, even_times(4000, 0.02), 1e-3);
  const LawFit fit = fit_law(record.record(), {.law = law_of("viscous+cubic")});
  ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
  EXPECT_NEAR(fit.residual.rms, 1e-3, 1e-4);
  EXPECT_NEAR(fit["cubic"].value, motion.cubic, 5 * fit["cubic"].standard_error);
}

TEST(FreeMotion, ASwingOutOfStepWithEverySinusoidIsStillAnOscillation) {
  const TrueSwing motion{.angular_frequency = 4, .decay_rate = 0.01, .cubic = -16.0 / 6, .position = 1.4};
  const SyntheticRecord record = motion_record(motion, even_times(8000, 0.02), 1e-3);
  const LawChoice choice = choose_law(record.record(), {});
  ASSERT_EQ(choice.chosen.status, FitStatus::converged) << in_words(choice.chosen.message);
  EXPECT_LT(choice.candidates[0].explained, 0.6);
  EXPECT_FALSE(in_words(choice.candidates[0].notices).empty());
  EXPECT_EQ(to_text(choice.chosen.law), "viscous+cubic");
  EXPECT_NEAR(choice.chosen.residual.rms, 1e-3, 1e-4);
}

// Springs that bend so much that the frequency changes by a sixth to a half along the record.
TEST(FreeMotion, StronglyBentSpringsAreFoundOverWholeRecords) {
  const auto bends = cases({std::pair{"viscous+quintic", 400.0},
                            {"viscous+quintic", -200},
                            {"viscous+cubic", 100},
                            {"viscous+cubic", 300},
                            {"viscous+cubic", -60},
                            {"viscous+odd-quadratic", 60},
                            {"viscous+odd-quadratic", -30}});
  for (const auto& [law, coefficient] : bends) {
    SCOPED_TRACE(testing::Message() << law << " " << coefficient);
    Motion motion{.law = law_of(law), .position = 0.5};
    motion.set_angular_frequency(6);
    motion.set_decay_rate(0.025);
    if (motion.law.has<Cubic>()) motion.per_mass.cubic = coefficient;
    if (motion.law.has<Quintic>()) motion.per_mass.quintic = coefficient;
    if (motion.law.has<OddQuadratic>()) motion.per_mass.odd_quadratic = coefficient;
    const SyntheticRecord record = motion_record(motion, even_times(3000, 0.02), 1e-3);
    const LawFit fit = fit_law(record.record(), {.law = motion.law});
    ASSERT_EQ(fit.status, FitStatus::converged) << in_words(fit.message);
    EXPECT_NEAR(fit.residual.rms, 1e-3, 1e-4);
    EXPECT_EQ(to_text(choose_law(record.record(), {}).chosen.law), law);
  }
}

TEST(ChooseLaw, TakesTheTermsThatAreThere) {
  TrueSwing drag = disc, viscous = disc, damped = disc, cubic = disc, all = disc;
  drag.decay_rate = 0;
  viscous.drag = cubic.drag = 0;
  viscous.decay_rate = damped.decay_rate = cubic.decay_rate = all.decay_rate = 0.02;
  cubic.cubic = all.cubic = 3000;
  const std::pair<TrueSwing, const char*> motions[] = {{viscous, "viscous"},
                                                       {drag, "drag"},
                                                       {damped, "viscous+drag"},
                                                       {cubic, "viscous+cubic"},
                                                       {all, "viscous+drag+cubic"}};
  for (const auto& [motion, law] : motions) {
    int right = 0, more = 0;
    for (unsigned seed = 1; seed <= cases(8u); ++seed) {
      const SyntheticRecord record = motion_record(motion, even_times(3000, 0.01), 3e-4, 1e-4, seed);
      const LawChoice choice = choose_law(record.record(), {});
      EXPECT_GE(choice.candidates.size(), 21u);
      const Law chosen = choice.chosen.law;
      // A second bend is tried beside the first.
      const int kin = 2 * (chosen.has<Drag>() + chosen.has<Cubic>()) + has_bent_spring(chosen);
      more += choice.candidates.size() > 21u + static_cast<unsigned>(kin);
      right += to_text(choice.chosen.law) == law;
    }
    EXPECT_GE(right, cases(8) - 1) << law;
    EXPECT_LE(more, 3) << "more terms are tried only where something may be left";
  }
}

TEST(ChooseLaw, DragIntervalsHold) {
  int covered = 0;
  constexpr int trials = 60;
  for (unsigned seed = 1; seed <= trials; ++seed) {
    const SyntheticRecord record = motion_record(disc, even_times(2000, 0.01), 3e-4, 1e-4, seed);
    const LawFit fit = fit_law(record.record(), {.law = law_of("viscous+drag")});
    covered += fit["drag"].low <= disc.drag && disc.drag <= fit["drag"].high;
  }
  EXPECT_GE(covered, 52);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
