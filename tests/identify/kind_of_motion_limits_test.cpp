// Which kind of motion a record shows, by fits made by hand: at, below and above each limit.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/identify/choose/kind_of_motion.h"
#include "tests/identify/synthetic.h"

namespace cromer::core {
namespace CROMER_FILE {

constexpr double strong = 6, hair = 1e-6;

struct Line {
  double w = 8, g = 0.1, amplitude = 0.03;
};

/// Two lines, 30 s at 20 samples a second.
SyntheticRecord lines(const Line& one, const Line& other, double noise = 1e-6, std::size_t n = 601) {
  SyntheticRecord record{even_times(n, 0.05), {}, 0};
  for (const double t : record.t) {
    double y = 0.2;
    for (const Line& line : {one, other})
      y += line.amplitude * std::exp(-line.g * t) * std::cos(line.w * t + 0.5);
    record.y.push_back(y);
  }
  record.y = noisy(record.y, noise);
  return record;
}

/// A free fit of four parameters and a driven one of seven that begins the two modes at these lines. What
/// they leave is large: to be told.
struct Fits {
  LawFit free, driven;

  explicit Fits(const Line& one = {}, const Line& other = {10}) {
    free.fitted = 4;
    free.residual.rms = 1;
    free.independent_samples = 50;
    driven.fitted = 7;
    driven.residual.rms = 2;
    driven.independent_samples = 100;
    driven.motion.set_angular_frequency(std::hypot(one.w, one.g));
    driven.motion.set_decay_rate(one.g);
    driven.motion.drive_frequency = other.w;
  }
  /// The driven fit leaves so much that its criterion lies this far below the free one's; they are told by N
  /// independent samples, and the search cost `searched`.
  Fits& driven_below(double evidence, double searched, double N = 100) {
    driven.residual.rms = free.residual.rms * std::exp(-(evidence + 3 * std::log(N) + searched) / (2 * N));
    return *this;
  }
  /// The same of two modes and the free fit, of the modes' independent samples.
  Fits& modes_below(double evidence, const TwoModes& modes, std::size_t n) {
    const double N = modes.independent_samples;
    const double searched = 2 * std::log(0.5 * static_cast<double>(n));
    free.residual.rms = modes.residual.rms * std::exp((evidence + 5 * std::log(N) + searched) / (2 * N));
    driven.residual.rms = 2 * free.residual.rms;
    return *this;
  }
  MotionJudgement judged(const SyntheticRecord& record, bool frequency_known = false) const {
    return judge_motion(record.record(), free, driven, frequency_known);
  }
};

/// No two modes can be begun with these.
Fits overdamped() {
  Fits fits;
  fits.driven.motion.set_angular_frequency(3);
  fits.driven.motion.set_decay_rate(3);
  return fits;
}

TEST(KindOfMotionLimits, ADriveMustBeWorthItsSearch) {
  const SyntheticRecord record = lines({}, {10, 0}, 1e-6, 64);
  const auto kind = [&](Fits fits, bool known) {
    const MotionJudgement judgement = fits.judged(record, known);
    EXPECT_FALSE(judgement.modes);
    return judgement.kind;
  };
  // Half of 64 frequencies. For one that was named nothing was searched, and the free law must be worth more.
  const double all = 2 * std::log(32.0);
  EXPECT_EQ(kind(overdamped().driven_below(strong - hair, all), false), MotionKind::free);
  EXPECT_EQ(kind(overdamped().driven_below(strong + hair, all), false), MotionKind::driven);
  EXPECT_EQ(kind(overdamped().driven_below(-strong - hair, 0), true), MotionKind::free);
  EXPECT_EQ(kind(overdamped().driven_below(-strong + hair, 0), true), MotionKind::driven);
  // Two samples are taken for independent at least.
  for (const double independent : {1.0, 2.0}) {
    Fits fits = overdamped();
    fits.driven.independent_samples = independent;
    EXPECT_EQ(kind(fits.driven_below(strong - hair, all, 2), false), MotionKind::free);
    EXPECT_EQ(kind(fits.driven_below(strong + hair, all, 2), false), MotionKind::driven);
  }
  // One that did not converge is worth nothing, unless it was named and has come so far.
  Fits failed = overdamped().driven_below(1000, all);
  failed.driven.status = FitStatus::iteration_limit;
  EXPECT_EQ(failed.judged(record).kind, MotionKind::free);
  EXPECT_EQ(failed.judged(record, true).kind, MotionKind::free);
  failed.driven.estimates.emplace_back();
  EXPECT_EQ(failed.judged(record).kind, MotionKind::free);
  EXPECT_EQ(failed.judged(record, true).kind, MotionKind::driven);
}

TEST(KindOfMotionLimits, WhatIsBelowTheRoundingIsWorthNothing) {
  SyntheticRecord record = lines({}, {10, 0}, 1e-6, 64);
  const Fits fits = overdamped().driven_below(10, 2 * std::log(32.0));
  EXPECT_EQ(fits.judged(record).kind, MotionKind::driven);
  record.resolution = std::sqrt(12.0);
  EXPECT_EQ(fits.judged(record).kind, MotionKind::free);
}

TEST(KindOfMotionLimits, AnOverdampedSwingHasNoLine) {
  const SyntheticRecord record = lines({}, {10, 0});
  Fits fits;
  fits.driven.motion.set_angular_frequency(8);
  fits.driven.motion.set_decay_rate(8);
  EXPECT_FALSE(fits.judged(record).modes);
  fits.driven.motion.set_decay_rate(0.1);
  EXPECT_TRUE(fits.judged(record).modes);
}

TEST(KindOfMotionLimits, ThirtyTwoSamples) {
  EXPECT_TRUE(Fits().judged(lines({}, {10, 0}, 1e-6, 32)).modes);
  EXPECT_FALSE(Fits().judged(lines({}, {10, 0}, 1e-6, 31)).modes);
}

TEST(KindOfMotionLimits, NothingIsAskedWhereTheFreeLawLeavesNothing) {
  Fits fits;
  fits.free.residual.rms = 0;
  EXPECT_FALSE(fits.judged(lines({}, {10, 0})).modes);
}

// Where the driven fit failed, the lines are those of the record's spectrum; where that has none, there are
// no modes.
TEST(KindOfMotionLimits, ADrivenFitThatFailed) {
  const SyntheticRecord record = lines({8, 0.1}, {10, 0.05});
  Fits fits({3}, {5});
  fits.driven.status = FitStatus::iteration_limit;
  const MotionJudgement judgement = fits.judged(record);
  EXPECT_EQ(judgement.kind, MotionKind::two_modes);
  ASSERT_TRUE(judgement.modes);
  EXPECT_NEAR(judgement.modes->modes[0].angular_frequency.value, 8, 1e-3);
  EXPECT_NEAR(judgement.modes->modes[1].angular_frequency.value, 10, 1e-3);
  SyntheticRecord rest = record;
  rest.y.assign(rest.y.size(), 0.2);
  EXPECT_FALSE(fits.judged(rest).modes);
  EXPECT_EQ(fits.judged(rest).kind, MotionKind::free);
}

TEST(KindOfMotionLimits, TwoModesMustBeWorthTheirSearch) {
  const SyntheticRecord record = lines({8, 0.1}, {10, 0.05}, 1e-4);
  const MotionJudgement clear = Fits().judged(record);
  EXPECT_EQ(clear.kind, MotionKind::two_modes);
  ASSERT_TRUE(clear.modes);
  const auto kind = [&](double evidence) {
    return Fits().modes_below(evidence, *clear.modes, record.t.size()).judged(record).kind;
  };
  EXPECT_EQ(kind(strong + hair), MotionKind::two_modes);
  EXPECT_EQ(kind(strong - hair), MotionKind::free);
}

// A drive that leaves less than two decays of which neither lasts is none, nor are they two modes then
// unless they are worth it by themselves.
TEST(KindOfMotionLimits, TwoDecaysAreNoDrive) {
  const SyntheticRecord record = lines({8, 0.1}, {10, 0.05}, 1e-4);
  const TwoModes modes = Fits().judged(record).modes.value();
  Fits fits;
  fits.driven.residual.rms = 0.5 * modes.residual.rms;
  EXPECT_EQ(fits.judged(record).kind, MotionKind::two_modes);
  fits.free.residual.rms = modes.residual.rms;
  EXPECT_EQ(fits.judged(record).kind, MotionKind::free);
}

TEST(KindOfMotionLimits, ALawThatIsNotLinearMakesADriveOfTwoDecays) {
  const SyntheticRecord record = lines({8, 0.1}, {10, 0.05}, 1e-4);
  const TwoModes modes = Fits().judged(record).modes.value();
  // Nine parameters of the modes and seven; half of the samples' frequencies in both.
  const double N = 100;
  const auto kind = [&](double evidence, const char* law) {
    Fits fits;
    fits.driven.law = law_of(law);
    fits.driven.residual.rms = modes.residual.rms * std::exp((2 * std::log(N) - evidence) / (2 * N));
    // What is told by N samples must leave least of all.
    EXPECT_EQ(fits.driven.residual.rms<modes.residual.rms, evidence> 2 * std::log(N));
    return fits.judged(record).kind;
  };
  EXPECT_EQ(kind(20, "viscous+cubic"), MotionKind::driven);
  EXPECT_EQ(kind(20, "viscous"), MotionKind::two_modes);
  Fits fits;
  fits.driven.law = law_of("viscous+cubic");
  EXPECT_EQ(fits.judged(record).kind, MotionKind::two_modes);
  // At the limit: of the modes' independent samples, which leave least.
  const double M = modes.independent_samples;
  for (const double off : {-hair, hair}) {
    fits.driven.residual.rms = modes.residual.rms * std::exp((2 * std::log(M) - strong - off) / (2 * M));
    EXPECT_EQ(fits.judged(record).kind, off > 0 ? MotionKind::driven : MotionKind::two_modes) << off;
  }
}

/// The drive's fit is good, the free one bad.
MotionJudgement with_drive(const SyntheticRecord& record, const Line& one, const Line& other,
                           bool frequency_known = false) {
  Fits fits(one, other);
  fits.driven.residual.rms = 1e-3;
  return fits.judged(record, frequency_known);
}

// Of 30 s: what falls by less than a tenth, and twenty times slower than the swing beside it.
TEST(KindOfMotionLimits, WhatLastsMayFallALittle) {
  const auto kind = [](double g, double beside) {
    const Line one{8, beside}, other{10, g, 0.02};
    const MotionJudgement judgement = with_drive(lines(one, other), one, other);
    EXPECT_TRUE(judgement.modes && judgement.modes->modes[1].decays()) << g;
    // Whichever is the larger.
    const Line small{8, beside, 0.01};
    EXPECT_EQ(with_drive(lines(small, other), small, other).kind, judgement.kind) << g;
    return judgement.kind;
  };
  EXPECT_EQ(kind(0.0032, 0.1), MotionKind::driven);
  EXPECT_EQ(kind(0.0035, 0.1), MotionKind::two_modes);
  EXPECT_EQ(kind(0.0035, 0.05), MotionKind::two_modes);
  EXPECT_EQ(kind(0.0026, 0.05), MotionKind::two_modes);
  EXPECT_EQ(kind(0.0024, 0.05), MotionKind::driven);
}

TEST(KindOfMotionLimits, OneLineThatLastsIsADriveWhereTheDrivenLawIsWorthIt) {
  const Line one{8, 0.1}, other{10, 0, 0.02};
  const SyntheticRecord record = lines(one, other);
  EXPECT_EQ(with_drive(record, one, other).kind, MotionKind::driven);
  EXPECT_EQ(Fits(one, other).judged(record).kind, MotionKind::free);
  Fits failed(one, other);
  failed.driven.status = FitStatus::iteration_limit;
  EXPECT_EQ(failed.judged(record).kind, MotionKind::free);
}

TEST(KindOfMotionLimits, TwoLinesThatLastMayBeEither) {
  const Line one{8, 0}, other{10, 0, 0.02};
  for (const bool known : {false, true})
    EXPECT_EQ(with_drive(lines(one, other), one, other, known).kind, MotionKind::driven_or_two_modes);
  // The smaller one is hardly seen.
  const Line faint{10, 0, 1.2e-3};
  EXPECT_EQ(with_drive(lines(one, faint, 1e-3), one, faint).kind, MotionKind::driven_or_two_modes);
  const Line fainter{10, 0, 2e-4};
  EXPECT_EQ(with_drive(lines(one, fainter, 1e-3), one, fainter).kind, MotionKind::driven);
}

// An amplitude shows from four of its standard errors on.
TEST(KindOfMotionLimits, ALineShowsWhereItsAmplitudeIsKnown) {
  const Line one{8, 0};
  const auto judged = [&](double amplitude) {
    const Line faint{10, 0, amplitude};
    return with_drive(lines(one, faint, 1e-3), one, faint);
  };
  const auto faint_mode = [&](double amplitude) { return judged(amplitude).modes.value().modes[1]; };
  double amplitude = 1e-3;
  for (const double ratio : {4.2, 3.8}) {
    for (int i = 0; i < 5; ++i)
      amplitude += ratio * faint_mode(amplitude).amplitude_error - faint_mode(amplitude).amplitude;
    ASSERT_NEAR(faint_mode(amplitude).amplitude / faint_mode(amplitude).amplitude_error, ratio, 0.1);
    EXPECT_EQ(judged(amplitude).kind, ratio > 4 ? MotionKind::driven_or_two_modes : MotionKind::driven);
  }
}

// One surely decays and the other does not, but their rates are alike.
TEST(KindOfMotionLimits, LinesThatDecayAlikeMayBeEitherUnlessTheDriveIsKnown) {
  const Line one{8, 0.0035, 0.03}, other{10, 0.0029, 0.03};
  const SyntheticRecord record = lines(one, other, 4e-3);
  const MotionJudgement judgement = with_drive(record, one, other);
  ASSERT_TRUE(judgement.modes);
  const auto& [first, second] = judgement.modes->modes;
  ASSERT_NE(first.decays(), second.decays());
  ASSERT_LT(std::abs(first.decay_rate.value - second.decay_rate.value),
            2 * std::hypot(first.decay_rate.standard_error, second.decay_rate.standard_error));
  EXPECT_EQ(judgement.kind, MotionKind::driven_or_two_modes);
  EXPECT_EQ(with_drive(record, one, other, true).kind, MotionKind::driven);
}

// Half of what 30 s resolve is 0.105 rad/s.
TEST(KindOfMotionLimits, TwoDecaysAtOneFrequencyAreOneSwing) {
  const auto kind = [](double apart) {
    const Line one{8, 0.05}, other{8 + apart, 0.5};
    return Fits(one, other).judged(lines(one, other)).kind;
  };
  EXPECT_EQ(kind(0.12), MotionKind::two_modes);
  EXPECT_EQ(kind(-0.12), MotionKind::two_modes);
  EXPECT_EQ(kind(0.09), MotionKind::free);
  EXPECT_EQ(kind(-0.09), MotionKind::free);
}

TEST(KindOfMotionLimits, AHarmonicIsNoModeUnlessTheDriveIsKnown) {
  for (const double multiple : {2.0, 3.0}) {
    const Line one{8, 0.1}, other{8 * multiple, 0.3, 0.01};
    const SyntheticRecord record = lines(one, other);
    EXPECT_EQ(Fits(one, other).judged(record).kind, MotionKind::free);
    EXPECT_EQ(Fits(one, other).judged(record, true).kind, MotionKind::two_modes);
    const Line half{8 / multiple, 0.1, 0.01};
    EXPECT_EQ(Fits(one, half).judged(lines(one, half)).kind, MotionKind::two_modes);
  }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
