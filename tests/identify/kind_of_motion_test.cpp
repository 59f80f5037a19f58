#include "cromer/identify/choose/kind_of_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cromer/identify/choose/choose_law.h"
#include "tests/identify/synthetic.h"
#include "tests/support/cases.h"

namespace cromer::core {
namespace CROMER_FILE {

// Two lines of amplitude 0.03 with decay rates g and f.
SyntheticRecord two_lines(double g, double f, double apart, unsigned seed) {
  SyntheticRecord record =
      viscous_record({.w0 = 8, .g = g, .equilibrium = 0, .position = 0.03, .velocity = 0},
                     even_times(1500, 0.02), 3e-4, 0, seed);
  for (std::size_t i = 0; i < record.t.size(); ++i)
    record.y[i] += 0.03 * std::exp(-f * record.t[i]) * std::cos((8 + apart) * record.t[i]);
  return record;
}

MotionJudgement judged(const SyntheticRecord& record) {
  const LawFit free = fit_law(record.record(), {});
  return judge_motion(record.record(), free, choose_law(record.record(), {.drive = Drive::harmonic()}).chosen,
                      false);
}

TEST(KindOfMotion, AFreeSwingIsNotDriven) {
  for (unsigned seed = 1; seed <= cases(20u); ++seed) {
    const SyntheticRecord record =
        viscous_record({.g = 0.01, .position = 0.05}, even_times(1500, 0.02), 1e-3, 0, seed);
    EXPECT_EQ(judged(record).kind, MotionKind::free) << seed;
  }
}

TEST(KindOfMotion, DampingTellsTwoModesFromADrive) {
  for (const double apart : {0.16, 0.5, 2.0, 8.3}) {
    const MotionJudgement coupled = judged(two_lines(0.01, 0.01, apart, 1));
    ASSERT_EQ(coupled.kind, MotionKind::two_modes) << apart;
    for (const Mode& mode : coupled.modes->modes) {
      EXPECT_NEAR(mode.decay_rate.value, 0.01, 4 * mode.decay_rate.standard_error);
      EXPECT_NEAR(mode.amplitude, 0.03, 4 * mode.amplitude_error);
    }
    EXPECT_EQ(judged(two_lines(0.01, 0, apart, 2)).kind, MotionKind::driven) << apart;
    EXPECT_EQ(judged(two_lines(0, 0, apart, 3)).kind, MotionKind::driven_or_two_modes) << apart;
  }
}

TEST(KindOfMotion, AHarmonicIsNoModeUnlessTheDriveIsKnown) {
  for (const int multiple : {2, 3})
    for (const double g : {0.0, 0.01}) {
      SyntheticRecord record = viscous_record(
          {.w0 = 8, .g = g, .equilibrium = 0, .position = 0.03, .velocity = 0}, even_times(1500, 0.02), 3e-4);
      for (const double t : record.t)
        record.y[static_cast<std::size_t>(std::lround(t / 0.02))] +=
            0.005 * std::exp(-multiple * g * t) * std::cos(multiple * std::sqrt(64 - g * g) * t);
      EXPECT_EQ(judged(record).kind, MotionKind::free) << multiple << ' ' << g;
    }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
