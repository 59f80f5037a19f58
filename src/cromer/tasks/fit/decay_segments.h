// The decay rate, part by part.
#pragma once

#include <optional>
#include <vector>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

struct DecaySegment {
  double from, to;  // [s]
  Estimate rate;    // [1/s]
};

struct DecaySegments {
  std::vector<DecaySegment> segments;
  std::optional<Estimate> mean;  ///< of the rates; its error from theirs
  std::vector<Notice> notices;   ///< of segments that are left out
};

/// Fits the viscous law, with an equilibrium of its own, to each whole segment from the first sample on: of
/// `length` [s] > 0, or the record in `count` > 0 equal parts, or with both at most `count` segments of that
/// length. None where neither is given, and a notice where a segment would hold less than 1.5 periods or 8
/// samples. What fails is left out, and said in one notice.
DecaySegments fit_segments(const Record& record, double period, std::optional<double> length,
                           std::optional<int> count, const Watch& watch = {});

}  // namespace cromer::core
