// Records of velocities and accelerations, and pendulums.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/analysis/swing.h"
#include "cromer/documents/words/words.h"
#include "cromer/identify/choose/choose_law.h"
#include "cromer/identify/motion/motion_model.h"
#include "cromer/identify/start/envelope_track.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

const TrueSwing disc{.angular_frequency = 6,
                     .decay_rate = 0.02,
                     .drag = 0.3,
                     .friction = 0.02,
                     .cubic = -100,
                     .equilibrium = 0.2,
                     .position = 0.08,
                     .velocity = 0.1};

// The record of a motion's derivative, with the sensor's offset disc.equilibrium.
SyntheticRecord derivative_record(const TrueSwing& motion, int derivative, double noise) {
  SyntheticRecord record{even_times(1500, 0.01), {}, 0};
  const std::vector<double> zeros(record.t.size());
  std::mt19937_64 engine(7);
  std::normal_distribution<double> normal;
  for (const double r : motion_residuals(motion, {}, {record.t, zeros, 0, derivative}, 1e-3))
    record.y.push_back(-r + (noise > 0 ? noise * normal(engine) : 0));
  return record;
}

TEST(Observed, TheDerivativesAreThoseOfTheMotion) {
  // Central differences of the position, away from the jumps of the acceleration at the turns.
  const SyntheticRecord x = derivative_record(disc, 0, 0), v = derivative_record(disc, 1, 0),
                        a = derivative_record(disc, 2, 0);
  for (std::size_t i = 1; i + 1 < x.t.size(); ++i) {
    const double offset = disc.equilibrium;
    EXPECT_NEAR(v.y[i] - offset, (x.y[i + 1] - x.y[i - 1]) / 0.02, 1e-3);
    if (std::abs(v.y[i] - offset) > 0.05) {
      EXPECT_NEAR(a.y[i] - offset, (v.y[i + 1] - v.y[i - 1]) / 0.02, 1e-2);
    }
  }
}

TEST(Observed, VelocitiesAndAccelerationsGiveTheLawOfTheDisplacement) {
  for (int derivative : {1, 2}) {
    for (const char* text : {"viscous", "viscous+drag+friction+cubic"}) {
      TrueSwing motion = disc;
      const Law law = *parse_law(text);
      if (!law.has<Drag>()) motion.drag = motion.friction = motion.cubic = 0;
      const SyntheticRecord made = derivative_record(motion, derivative, 0);
      const Record record{made.t, made.y, 0, derivative};
      const LawFit fit = fit_law(record, {.law = law});
      ASSERT_EQ(fit.status, FitStatus::converged) << text << ": " << in_words(fit.message);
      EXPECT_NEAR(fit.angular_frequency().value, 6, 1e-5) << text << derivative;
      EXPECT_NEAR(fit.decay_rate().value, 0.02, 1e-5) << text << derivative;
      EXPECT_NEAR(fit.position().value, 0.08, 1e-5) << text << derivative;
      EXPECT_NEAR(fit.velocity().value, 0.1, 1e-5) << text << derivative;
      EXPECT_NEAR(fit.equilibrium().value, 0.2, 1e-5) << text << derivative;
      EXPECT_NEAR(fit["drag"].value, motion.drag, 1e-3);
    }
  }
}

TEST(Observed, TheUncertaintiesAreThoseOfTheDisplacement) {
  // The closed form and the integrated motion must say the same of one record.
  TrueSwing motion = disc;
  motion.drag = motion.friction = motion.cubic = 0;
  const SyntheticRecord made = derivative_record(motion, 1, 5e-3);
  const Record record{made.t, made.y, 0, 1};
  const LawFit closed = fit_law(record, {.law = law_of("viscous")});
  LawFit general = fit_law(record, {.law = law_of("viscous+cubic")});
  EXPECT_NEAR(closed.decay_rate().standard_error, general.decay_rate().standard_error,
              0.05 * closed.decay_rate().standard_error);
  EXPECT_NEAR(closed.equilibrium().standard_error, general.equilibrium().standard_error,
              0.05 * closed.equilibrium().standard_error);
  EXPECT_NEAR(closed.position().value, 0.08, 4 * closed.position().standard_error);
  EXPECT_NEAR(closed.velocity().value, 0.1, 4 * closed.velocity().standard_error);
}

TEST(Pendulum, ReturnsAfterThePeriodOfTheEllipticIntegral) {
  const double w0 = 4, amplitude = 1.5;
  const double period = 4 * std::comp_ellint_1(std::sin(amplitude / 2)) / w0;
  const TrueSwing motion{.angular_frequency = w0, .position = amplitude, .pendulum = true};
  const Trajectory run = free_motion(motion, std::vector<double>{0, period}, 1e-3);
  EXPECT_NEAR(run.x[1], amplitude, 1e-9);
  EXPECT_NEAR(run.v[1], 0, 1e-8);
}

TEST(Pendulum, IsFittedAndPreferredToACubicSpring) {
  const TrueSwing motion{.angular_frequency = 4,
                         .decay_rate = 0.03,
                         .equilibrium = 0.1,
                         .position = 1.4,
                         .velocity = 0.3,
                         .pendulum = true};
  const SyntheticRecord record = derivative_record(motion, 0, 2e-3);
  const LawChoice choice = choose_law(record.record(), {.angle = true});
  EXPECT_EQ(to_text(choice.chosen.law), "viscous+pendulum");
  EXPECT_EQ(choice.candidates.size(), 28u);
  EXPECT_NEAR(choice.chosen.angular_frequency().value, 4,
              4 * choice.chosen.angular_frequency().standard_error);
  EXPECT_NEAR(choice.chosen.residual.rms, 2e-3, 2e-4);
  for (const LawFit& fit : choose_law(record.record(), {}).candidates) EXPECT_FALSE(fit.law.has<Pendulum>());
}

TEST(EnvelopeTrack, FindsTheLawsStartValues) {
  const SyntheticRecord record = derivative_record(disc, 0, 1e-4);
  const auto track = track_envelope(record.record(), 5.9, 0);
  ASSERT_TRUE(track.has_value());
  EXPECT_EQ(track->samples, record.t.size());
  const Motion start = motion_along(*track, law_of("viscous+drag+friction+cubic"), 0);
  EXPECT_NEAR(start.angular_frequency(), 6, 0.01);
  EXPECT_NEAR(start.position, 0.08, 0.004);
  EXPECT_NEAR(start.velocity, 0.1, 0.03);
  EXPECT_NEAR(start.per_mass.cubic, -100, 40);
  // A cycle loses what the three terms take together: s + bA + qA² at half the amplitude.
  const auto loss = [](const Motion& m) {
    return AmplitudeDecay{m.angular_frequency(), m.per_mass}.rate(0.04);
  };
  EXPECT_NEAR(loss(start), loss(disc), 0.1 * loss(disc));
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
