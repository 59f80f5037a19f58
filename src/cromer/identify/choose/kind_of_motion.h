// Whether a recorded motion is a free one, a driven one, or two swings at once.
#pragma once

#include <array>
#include <optional>

#include "cromer/identify/law_fit.h"
#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "cromer/identify/record.h"
#include "cromer/identify/start/two_lines.h"

namespace cromer::core {

/// One of two oscillations (start/two_lines.h).
struct Mode {
  Estimate angular_frequency;  // [rad/s] of the damped oscillation
  Estimate decay_rate;         // [1/s] not bounded: below 0 where it grows
  double amplitude = 0;        ///< at the first sample, in the unit of the record
  double amplitude_error = 0;  ///< its standard error

  /// True if the decay rate exceeds three standard errors.
  bool decays() const;
};

struct TwoModes {
  std::array<Mode, 2> modes;  ///< the larger first
  Residual residual;
  double independent_samples = 0;

  static constexpr int parameters = two_lines::decaying;
};

enum class MotionKind {
  free,                ///< the free law accounts for it as well as anything else, harmonics aside
  driven,              ///< one line lasts and the other decays, or the driven law is not linear
  two_modes,           ///< two lines, both of which decay
  driven_or_two_modes  ///< two lines, neither of which surely decays faster: the same signal either way
};

struct MotionJudgement {
  MotionKind kind = MotionKind::free;
  std::optional<TwoModes> modes;  ///< where they were fitted
};

/// Compares the free law, the driven one and two decaying modes, all fitted to `record`, by the Bayesian
/// information criterion of as many samples as the closest leaves independent. Anything but the free law must
/// be better by more than 6 (strong evidence, see criterion.h), after the price of the search for its
/// frequency: twice the logarithm of the number of frequencies that were searched, half the samples. Where
/// the drive's frequency is known, nothing was searched, and the free law must be better than the driven one
/// by as much. A smaller line at a multiple of the larger's frequency is its harmonic and no mode, unless the
/// drive's frequency is known.
MotionJudgement judge_motion(const Record& record, const LawFit& free, const LawFit& driven,
                             bool frequency_known);

}  // namespace cromer::core
