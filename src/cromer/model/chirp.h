// A sweep through frequencies, as shakers do it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/dual.h"
#include "cromer/model/next_turn.h"

namespace cromer::core {

/// F cos(theta(t)) from start to start + duration, zero outside. The frequency theta' runs from one end to
/// the other: linear, w = from + (to - from) u/T; logarithmic, w = from (to/from)^(u/T); u = t - start.
template <class Real>
struct ChirpDrive {
  Real amplitude = 0;  // [N]
  Real from = 0;       // [rad/s] >= 0; logarithmic: > 0
  Real to = 0;         // [rad/s] >= 0; logarithmic: > 0
  Real phase = 0;      // [rad] at the start
  Real start = 0;      // [s] >= 0
  Real duration = 0;   // [s] > 0
  bool logarithmic = false;

  friend bool operator==(const ChirpDrive&, const ChirpDrive&) = default;
};

/// A chirp as a function of time, per unit mass. Error: the rounding of its phase.
template <class Real>
class ChirpForce {
 public:
  ChirpForce(const ChirpDrive<Real>& drive, const Real& mass)
      : drive_(drive), amplitude_(drive.amplitude / mass) {
    using std::log;
    if (drive.logarithmic) log_ratio_ = log(drive.to / drive.from);
  }

  template <class Time>
  Real operator()(const Time& t) const {
    using std::cos;
    const Real u = t - drive_.start;
    const bool on = everywhere_ ? on_ : value_of(u) >= 0 && value_of(u) < value_of(drive_.duration);
    if (!on) return Real(0);
    return amplitude_ * cos(angle(u));
  }

  /// How far rounding, of its values and of times near t, may put it off.
  double rounding(double t) const {
    const double size = std::abs(value_of(amplitude_));
    return std::numeric_limits<double>::epsilon() *
           (size + std::abs(t) * size * std::max(value_of(drive_.from), value_of(drive_.to)));
  }

  /// The first time after t at which it begins or ends.
  double next_break(double t) const {
    const double start = value_of(drive_.start), end = start + value_of(drive_.duration);
    return t < start ? start : t < end ? end : std::numeric_limits<double>::infinity();
  }

  /// What it is at t, sweep or silence, at all times.
  ChirpForce within(double t) const {
    ChirpForce one = *this;
    const double start = value_of(drive_.start);
    one.everywhere_ = true;
    one.on_ = t >= start && t < start + value_of(drive_.duration);
    return one;
  }

  /// The first time after t at which it begins, turns or ends.
  double next_turn(double t) const {
    const double start = value_of(drive_.start), end = start + value_of(drive_.duration);
    if (t < start) return start;
    if (t >= end) return std::numeric_limits<double>::infinity();
    const double turn = time_of_next_half_turn(
        t, [&](double at) { return value_of(angle(Real(at) - drive_.start)); },
        [&](double angle) { return start + time_of(angle - value_of(drive_.phase)); });
    return std::min(turn, end);
  }

 private:
  /// Since the start, to this angle beyond the phase there [s].
  double time_of(double angle) const {
    const double from = value_of(drive_.from), to = value_of(drive_.to), length = value_of(drive_.duration);
    if (drive_.logarithmic) {
      const double l = value_of(log_ratio_);
      return l == 0 ? angle / from : length * std::log1p(l * angle / (from * length)) / l;
    }
    // from u + (to - from) u^2/2T
    const double bend = (to - from) / (2 * length);
    return 2 * angle / (from + std::sqrt(from * from + 4 * bend * angle));
  }

  Real angle(const Real& u) const {
    using std::expm1;
    const Real part = u / drive_.duration;
    if (!drive_.logarithmic)
      return drive_.phase + (drive_.from + (drive_.to - drive_.from) * part / Real(2)) * u;
    // from T (e^{L p} - 1)/L, L = log(to/from)
    if (value_of(log_ratio_) == 0) return drive_.phase + drive_.from * u;
    return drive_.phase + drive_.from * drive_.duration * expm1(log_ratio_ * part) / log_ratio_;
  }

  ChirpDrive<Real> drive_;
  bool everywhere_ = false, on_ = false;  ///< the same at all times
  Real amplitude_, log_ratio_ = Real(0);
};

}  // namespace cromer::core
