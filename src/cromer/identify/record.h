// A recorded motion and what drove it, as the estimator sees them.
#pragma once

#include <cstddef>
#include <span>

#include "cromer/model/between_samples.h"

namespace cromer::core {

/// Times [s], strictly increasing, and values of the same length in any unit; no NaN in either.
struct Record {
  std::span<const double> t;
  std::span<const double> y;
  double resolution = 0;  ///< rounding step of the values, 0 if unknown
  int derivative = 0;     ///< which of the displacement y is: 0 itself, 1 the velocity, 2 the acceleration

  /// So many samples from one on, or the first ones.
  Record part(std::size_t from, std::size_t samples) const {
    Record some = *this;
    some.t = t.subspan(from, samples);
    some.y = y.subspan(from, samples);
    return some;
  }
  Record first(std::size_t samples) const { return part(0, samples); }
};

/// A force that was recorded beside the motion, at even times, before and after it as well if there is more.
/// The motion's samples lie at times of the force's own.
struct ForceRecord {
  std::span<const double> samples;
  double begin = 0;    // [s] time of the first
  double spacing = 1;  // [s] > 0
  BetweenSamples between = BetweenSamples::linear;

  double time(std::size_t i) const { return begin + static_cast<double>(i) * spacing; }
};

}  // namespace cromer::core
