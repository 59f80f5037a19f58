// Start values by themselves: what the iteration makes of them hides how good they are.
#include <gtest/gtest.h>

#include "cromer/identify/motion/damped_phasor.h"
#include "cromer/identify/start/driven_start.h"
#include "cromer/identify/start/envelope_track.h"
#include "cromer/identify/start/start_values.h"
#include "tests/identify/forced_truth.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(Starts, OfASwingAreThoseOfItsFirstPart) {
  const TrueSwing swing{.angular_frequency = 6, .decay_rate = 0.05, .equilibrium = 0.2, .position = 0.5};
  for (const double h : {0.01, 0.07, 0.3}) {
    const std::vector<double> t = even_times(600, h);
    const std::vector<double> y = noisy(observed_motion(swing, {}, t, 0, 0.002), 1e-3);
    const auto start = find_start_values({t, y});
    ASSERT_TRUE(start) << h;
    EXPECT_NEAR(start->phasor[DampedPhasor::angular_frequency], std::sqrt(36 - 0.0025),
                5 * start->frequency_error)
        << h;
    EXPECT_NEAR(start->phasor[DampedPhasor::decay_rate], 0.05, 0.01) << h;
    EXPECT_NEAR(start->phasor[DampedPhasor::equilibrium], 0.2, 2e-3) << h;
    if (start->first == 0) {
      EXPECT_NEAR(start->phasor[DampedPhasor::cosine], 0.5, 0.01) << h;
    }
    EXPECT_LT(start->frequency_error, 0.01) << h;
  }
}

TEST(Starts, OfADrivenMotionAreWithinAFewPercent) {
  Motion motion{.equilibrium = 0.1, .position = 0.5, .velocity = 0.3};
  motion.set_angular_frequency(6);
  motion.set_decay_rate(0.1);
  motion.cosine = 8;
  motion.sine = 3;
  motion.drive_frequency = 4.7;
  const std::vector<double> t = even_times(1500, 0.02);
  const std::vector<double> y = noisy(observed_motion(motion, Drive::harmonic(), t, 0, 0.002), 1e-3);
  for (const std::optional<double> named : {std::optional<double>(), std::optional(4.68)}) {
    const auto start = driven_start({t, y}, named);
    ASSERT_TRUE(start);
    EXPECT_NEAR(start->angular_frequency(), 6, 0.03);
    EXPECT_NEAR(start->decay_rate(), 0.1, 0.05);
    EXPECT_NEAR(start->drive_frequency, 4.7, 0.01);
    EXPECT_NEAR(start->cosine, 8, 0.4);
    EXPECT_NEAR(start->sine, 3, 0.4);
    EXPECT_NEAR(start->equilibrium, 0.1, 0.01);
    EXPECT_NEAR(start->position, 0.5, 0.05);
    EXPECT_NEAR(start->velocity, 0.3, 0.3);
  }
}

TEST(Starts, UnderARecordedForceAreWithinAFewPercent) {
  const auto force = multisine(20, 3);
  const ForcedTruth truth{.w0 = 9, .g = 0.4, .quadratic = 6, .cubic = 40, .gain = 5, .offset = 0.2};
  const ForcedSynthetic record = forced_synthetic(truth, force, 2000, 0.02, 1e-4, 2);
  const auto start = forced_start(record.record(), record.recorded(BetweenSamples::linear),
                                  law_of("viscous+quadratic+cubic"));
  ASSERT_TRUE(start);
  EXPECT_NEAR(start->angular_frequency(), 9, 0.1);
  EXPECT_NEAR(start->decay_rate(), 0.4, 0.05);
  EXPECT_NEAR(start->force_gain, 5, 0.1);
  EXPECT_NEAR(start->per_mass.quadratic, 6, 1.5);
  EXPECT_NEAR(start->per_mass.cubic, 40, 8);
}

TEST(Starts, OfABodyWithoutASpringFollowTheForce) {
  const auto force = multisine(20, 3);
  const ForcedTruth truth{.w0 = 0, .g = 0.4, .gain = 5, .position = 0, .velocity = 0.2};
  const ForcedSynthetic record = forced_synthetic(truth, force, 2000, 0.02, 1e-4, 2, 1);
  Law law = law_of("viscous").without(law_with<Spring>);
  const auto start = forced_start(record.record(), record.recorded(BetweenSamples::linear), law);
  ASSERT_TRUE(start);
  EXPECT_EQ(start->angular_frequency(), 0);
  EXPECT_NEAR(start->decay_rate(), 0.4, 0.02);
  EXPECT_NEAR(start->force_gain, 5, 0.1);
}

struct Followed {
  const char* law;
  double decay_rate, drag, friction, cubic;
};

TEST(Starts, AlongAnEnvelopeAreThoseOfEachLaw) {
  for (const Followed& truth :
       {Followed{"viscous+drag", 0.02, 0.1, 0, 0}, Followed{"drag", 0, 0.2, 0, 0},
        Followed{"friction", 0, 0, 0.1, 0}, Followed{"viscous+friction", 0.03, 0, 0.05, 0},
        Followed{"viscous+cubic", 0.04, 0, 0, 8}}) {
    const TrueSwing swing{.angular_frequency = 6,
                          .decay_rate = truth.decay_rate,
                          .drag = truth.drag,
                          .friction = truth.friction,
                          .cubic = truth.cubic,
                          .equilibrium = 0.2,
                          .position = 0.5,
                          .velocity = 0.4};
    const std::vector<double> t = even_times(2000, 0.02);
    const std::vector<double> y = noisy(observed_motion(swing, {}, t, 0, 0.002), 1e-4);
    const auto track = track_envelope({t, y}, 6, 0.05);
    ASSERT_TRUE(track) << truth.law;
    const Motion start = motion_along(*track, law_of(truth.law), t.front());
    EXPECT_NEAR(start.angular_frequency(), 6, 0.01) << truth.law;
    EXPECT_NEAR(start.decay_rate(), truth.decay_rate, 0.005) << truth.law;
    EXPECT_NEAR(start.per_mass.drag, truth.drag, 0.02 * truth.drag + 1e-9) << truth.law;
    EXPECT_NEAR(start.per_mass.friction, truth.friction, 0.05 * truth.friction + 1e-9) << truth.law;
    EXPECT_NEAR(start.per_mass.cubic, truth.cubic, 0.1 * truth.cubic + 1e-9) << truth.law;
    EXPECT_NEAR(start.equilibrium, 0.2, 5e-3) << truth.law;
    EXPECT_NEAR(start.position, 0.5, 0.02) << truth.law;
    EXPECT_NEAR(start.velocity, 0.4, 0.2) << truth.law;
    EXPECT_EQ(track->samples, truth.friction > 0 ? track->samples : t.size()) << truth.law;
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
