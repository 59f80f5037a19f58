// A recorded force: evenly spaced samples, and what it did between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "cromer/base/dual.h"
#include "cromer/model/between_samples.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

/// Sample i acts at t = i * spacing, from the start of the run. A band-limited recording is refined first
/// (between_samples.h), then linear.
struct SampledDrive {
  std::shared_ptr<const std::vector<double>> force;  // [N] at least two; runs of one recording share it
  double spacing = 1;                                // [s] > 0
  BetweenSamples between = BetweenSamples::linear;

  /// Its end [s]: the last sample; one spacing later if samples are held.
  double duration() const {
    const std::size_t intervals = force->size() - (between == BetweenSamples::hold ? 0 : 1);
    return static_cast<double>(intervals) * spacing;
  }
};

/// The recording as a function of time, per unit mass; before and after it the first and the last value. It
/// finds the interval of a time directly, without a search.
template <class Real>
class SampledForce {
 public:
  SampledForce(const SampledDrive& drive, const Real& mass)
      : owner_(drive.force),
        samples_(drive.force->data()),
        last_(drive.force->size() - 1),
        spacing_(drive.spacing),
        per_spacing_(1 / drive.spacing),
        per_mass_(Real(1) / mass),
        hold_(drive.between == BetweenSamples::hold) {
    for (const double sample : *owner_) largest_ = std::max(largest_, std::abs(sample));
    largest_ *= std::abs(value_of(per_mass_));
  }

  template <class Time>
  Real operator()(const Time& t) const {
    const double u = value_of(t) * per_spacing_;
    if (pinned_) return pinned_value(u);
    if (hold_) return per_mass_ * samples_[interval(u)];
    const std::size_t i = std::min(interval(u), last_ - 1);
    const double part = std::clamp(u - static_cast<double>(i), 0.0, 1.0);
    return per_mass_ * (samples_[i] + part * (samples_[i + 1] - samples_[i]));
  }

  /// The next sample after t, where it may turn, or jump if it is held.
  double next_turn(double t) const {
    const double u = t * per_spacing_;
    if (!(u + nearly < static_cast<double>(last_))) return std::numeric_limits<double>::infinity();
    return static_cast<double>(interval(u) + 1) * spacing_;
  }

  /// Bound on its error at times near t, from rounding of its values and of the times.
  double rounding(double t) const {
    return std::numeric_limits<double>::epsilon() * (largest_ + std::abs(t) * 2 * largest_ * per_spacing_);
  }

  /// The next sample after t, where it jumps or bends.
  double next_break(double t) const { return next_turn(t); }

  /// The constant or ramp that holds at t, extended to all times.
  SampledForce within(double t) const {
    SampledForce one = *this;
    one.pinned_ = true;
    one.pin_ = interval(t * per_spacing_);
    return one;
  }

  /// Whether steps of this length [s] that begin on a sample meet samples only at their ends, and nothing
  /// jumps there.
  bool is_smooth_in_steps(double step) const {
    const double steps = spacing_ / step;
    return !hold_ && std::abs(steps - std::round(steps)) < 1e-9 * steps;
  }

  /// propagate goes from sample to sample: best asked step by step.
  static constexpr bool has_many_pieces = true;

  /// The state at t >= t0 of the motion through y0 at t0, by the map of each interval.
  State<Real> propagate(const LinearLaw<Real>& law, const Real& t0, const Real& t,
                        const State<Real>& y0) const {
    State<Real> y = y0;
    Real now = t0;
    for (std::size_t i = interval(value_of(t0) * per_spacing_); value_of(now) < value_of(t); ++i) {
      const double boundary = static_cast<double>(i + 1) * spacing_;
      // A boundary within rounding of the end is the end.
      const bool ends = i >= last_ || boundary + nearly * spacing_ >= value_of(t);
      const Real end = ends ? t : Real(boundary);
      const Real begin(static_cast<double>(i) * spacing_);
      const double here = samples_[std::min(i, last_)];
      const double slope = hold_ || i >= last_ ? 0 : (samples_[i + 1] - here) * per_spacing_;
      const Real level = per_mass_ * (Real(here) + Real(slope) * (now - begin));
      y = propagate_ramp(law, level, per_mass_ * Real(slope), end - now, y);
      now = end;
    }
    return y;
  }

 private:
  static constexpr double nearly = 1e-6;  ///< of a spacing: times t0 + n h fall on samples only nearly

  Real pinned_value(double u) const {
    const double here = samples_[pin_];
    if (hold_ || pin_ >= last_) return per_mass_ * here;
    return per_mass_ * (here + (u - static_cast<double>(pin_)) * (samples_[pin_ + 1] - here));
  }

  /// The interval in which the time of u spacings lies; at most the last sample.
  std::size_t interval(double u) const {
    const double shifted = u + nearly;
    if (!(shifted > 0)) return 0;
    return shifted >= static_cast<double>(last_) ? last_ : static_cast<std::size_t>(shifted);
  }

  std::shared_ptr<const std::vector<double>> owner_;
  const double* samples_;
  std::size_t last_;
  double spacing_, per_spacing_;
  Real per_mass_;
  bool hold_;
  double largest_ = 0;  ///< of its values, per mass
  bool pinned_ = false;
  std::size_t pin_ = 0;  ///< the interval that holds at all times
};

}  // namespace cromer::core
