// Stage 8: the steps of a series' times: rate, jitter, gaps.
#pragma once

#include <span>
#include <vector>

#include "cromer/record/dialects/recording.h"

namespace cromer::dialects {

struct Steps {
  double rate = 0;    // [1/s] one over the median step; a round number where the times agree with it
  double jitter = 0;  ///< standard deviation of the steps over their median; 0 below the rounding of doubles
  std::vector<Gap> gaps;
};

/// The steps of strictly rising times; all zero for fewer than two. A rate has 12 significant digits at most.
/// A gap is a missing sample: a step of more than 1.5 medians behind which the times stay late by more than
/// half a median. A single late sample, and jitter, is none.
Steps describe_steps(std::span<const double> t);

}  // namespace cromer::dialects
