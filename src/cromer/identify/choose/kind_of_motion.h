// Whether a recorded motion is a free one, a driven one, or two swings at once.
#pragma once

#include <optional>

#include "cromer/identify/choose/two_modes.h"
#include "cromer/identify/law_fit.h"

namespace cromer::core {

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
/// frequency: twice the logarithm of the number of frequencies that were searched, half the samples where the
/// drive's was not known. A smaller line at a multiple of the larger's frequency is its harmonic and no
/// mode, unless the drive's frequency is known.
MotionJudgement judge_motion(const Record& record, const LawFit& free, const LawFit& driven,
                             bool frequency_known);

}  // namespace cromer::core
