// A recorded motion and what drove it, and how large the motion and its noise are, whatever the law.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "cromer/model/between_samples.h"

namespace cromer::core {

/// Times [s], strictly increasing, and values of the same length in any unit; no NaN in either.
struct Record {
  std::span<const double> t;
  std::span<const double> y;
  double resolution = 0;   ///< rounding step of the values, 0 if unknown
  int derivative = 0;      ///< which of the displacement y is: 0 itself, 1 the velocity, 2 the acceleration
  double clock_error = 0;  ///< relative standard error of the unit of its times
  double scale_error = 0;  ///< the same of its values
  /// [s] The samples from then on may all be early or late: a slip of the times was taken out there (slip.h).
  double slips_at = HUGE_VAL;
  /// [s] So much of it at the beginning and at the end may not be free of a hand (undisturbed.h).
  double handled_first = 0, handled_last = 0;
  std::string unit{};  ///< of the values, for sentences; "" if it is not known

  /// `samples` samples from number `from` on.
  Record part(std::size_t from, std::size_t samples) const {
    Record some = *this;
    some.t = t.subspan(from, samples);
    some.y = y.subspan(from, samples);
    if (from > 0) some.handled_first = 0;
    if (from + samples < t.size()) some.handled_last = 0;
    return some;
  }
  Record first(std::size_t samples) const { return part(0, samples); }
};

/// A force that was recorded beside the motion at even times. It may begin before the motion and end after
/// it. The motion's samples lie at times of the force's samples.
struct ForceRecord {
  std::span<const double> samples;
  double begin = 0;    // [s] time of the first
  double spacing = 1;  // [s] > 0
  BetweenSamples between = BetweenSamples::linear;

  double time(std::size_t i) const { return begin + static_cast<double>(i) * spacing; }
};

/// Euclidean norm of the values about their mean.
double centred_norm(std::span<const double> y);

/// The amplitude of a lasting sinusoid as strong as the values: root two times their standard deviation.
double sinusoid_amplitude(std::span<const double> y);

/// Standard deviation of what is independent from sample to sample: a second difference has six times its
/// variance, and little of anything slow. 0 of fewer than three values.
double noise_of(std::span<const double> values);

struct AmplitudeWindow {
  double from, to;   // [s]
  double amplitude;  ///< sinusoid_amplitude() of the values within, in the record's unit
};

/// Windows of `length` [s] one after the other from the first sample. A rest that does not fill a window is
/// left out, and so are windows of fewer than `at_least` samples.
std::vector<AmplitudeWindow> amplitude_windows(const Record& record, double length, std::size_t at_least);

}  // namespace cromer::core
