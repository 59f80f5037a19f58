// Drives other than the harmonic one: a step and pulses, a chirp, a recording; and all of them as one type,
// which with_terms tells apart once, outside every loop.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include "cromer/base/dual.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/friction.h"
#include "cromer/model/harmonic_force.h"
#include "cromer/model/propagate.h"
#include "cromer/model/sampled_drive.h"

namespace cromer::core {

/// Forces that begin, and end. Each is a few pieces, and each piece has a closed form.
enum class PulseShape { step, rectangular, half_sine, triangular };

/// Zero before start and, except for the step, from start + duration on. At a jump the value after it holds.
/// The triangle is symmetric.
template <class Real>
struct PulseDrive {
  PulseShape shape = PulseShape::step;
  Real amplitude = 0;  // [N] the largest force, any sign
  Real start = 0;      // [s] >= 0
  Real duration = 0;   // [s] > 0; not used by the step

  friend bool operator==(const PulseDrive&, const PulseDrive&) = default;
};

/// From begin to the next piece: level + slope u + sine sin(frequency u), u = t - begin.
template <class Real>
struct ForcePiece {
  Real begin = 0;      // [s]
  Real level = 0;      // of the force, or of the acceleration [m/s^2]
  Real slope = 0;      // the same per second
  Real sine = 0;       // the same as level
  Real frequency = 0;  // [rad/s]
};

/// A pulse as a function of time, per unit mass.
template <class Real>
class PulseForce {
 public:
  PulseForce(const PulseDrive<Real>& drive, const Real& mass) {
    const Real a = drive.amplitude / mass, end = drive.start + drive.duration;
    largest_ = std::abs(value_of(a));
    const bool bends = drive.shape == PulseShape::half_sine || drive.shape == PulseShape::triangular;
    steepest_ = bends ? std::numbers::pi * largest_ / value_of(drive.duration) : 0;
    switch (drive.shape) {
      case PulseShape::step:
        add({.begin = drive.start, .level = a});
        return;
      case PulseShape::rectangular:
        add({.begin = drive.start, .level = a});
        break;
      case PulseShape::half_sine:
        add({.begin = drive.start, .sine = a, .frequency = Real(std::numbers::pi) / drive.duration});
        break;
      case PulseShape::triangular: {
        const Real half = drive.duration / Real(2);
        add({.begin = drive.start, .slope = a / half});
        add({.begin = drive.start + half, .level = a, .slope = -a / half});
        break;
      }
    }
    add({.begin = end});
  }

  template <class Time>
  Real operator()(const Time& t) const {
    using std::sin;
    const ForcePiece<Real>* piece = at(value_of(t));
    if (!piece) return Real(0);
    const Real u = t - piece->begin;
    return piece->level + piece->slope * u +
           (value_of(piece->frequency) != 0 ? piece->sine * sin(piece->frequency * u) : Real(0));
  }

  /// The first time after t at which a piece begins, or the half sine is at its top.
  double next_turn(double t) const {
    for (std::size_t i = 0; i < size_; ++i) {
      const double begin = value_of(pieces_[i].begin), frequency = value_of(pieces_[i].frequency);
      if (begin > t) return begin;
      if (const double top = begin + std::numbers::pi / 2 / frequency; frequency != 0 && top > t) return top;
    }
    return std::numeric_limits<double>::infinity();
  }

  /// Bound on its error at times near t, from rounding of its values and of the times.
  double rounding(double t) const {
    return std::numeric_limits<double>::epsilon() * (largest_ + std::abs(t) * steepest_);
  }

  /// The first time after t at which a piece begins.
  double next_break(double t) const {
    for (std::size_t i = 0; i < size_; ++i)
      if (const double begin = value_of(pieces_[i].begin); begin > t * nearly) return begin;
    return std::numeric_limits<double>::infinity();
  }

  /// The piece that holds at t, extended to all times: smooth, and equal to the force until the next break.
  PulseForce within(double t) const {
    PulseForce one = *this;
    const ForcePiece<Real>* piece = at(t);
    one.pieces_[0] = piece ? *piece : ForcePiece<Real>{};
    one.size_ = 1;
    one.everywhere_ = true;
    return one;
  }

  /// The state at t >= t0 of the motion through y0 at t0.
  State<Real> propagate(const LinearLaw<Real>& law, const Real& t0, const Real& t,
                        const State<Real>& y0) const {
    State<Real> y = y0;
    Real now = t0;
    for (std::size_t i = 0; i <= size_ && value_of(now) < value_of(t); ++i) {
      const Real end = i < size_ && value_of(pieces_[i].begin) < value_of(t) ? pieces_[i].begin : t;
      if (!(value_of(end) > value_of(now))) continue;
      y = i == 0 ? cromer::core::propagate(without_drive(law), now, end, y)
                 : propagate_in(pieces_[i - 1], law, now, end, y);
      now = end;
    }
    return y;
  }

 private:
  static LinearLaw<Real> without_drive(LinearLaw<Real> law) {
    law.drive_amplitude = Real(0);
    return law;
  }

  static State<Real> propagate_in(const ForcePiece<Real>& piece, LinearLaw<Real> law, const Real& t0,
                                  const Real& t, const State<Real>& y0) {
    const Real from = t0 - piece.begin;
    if (value_of(piece.frequency) == 0)
      return propagate_ramp(law, piece.level + piece.slope * from, piece.slope, t - t0, y0);
    // sin(w u) = cos(w u - pi/2)
    law.drive_amplitude = piece.sine;
    law.drive_frequency = piece.frequency;
    law.drive_phase = Real(-std::numbers::pi / 2);
    return cromer::core::propagate(law, from, t - piece.begin, y0);
  }

  /// The piece that holds at t; nullptr before the first. A time within rounding of a start counts as that
  /// start.
  const ForcePiece<Real>* at(double t) const {
    if (everywhere_) return &pieces_[0];
    const ForcePiece<Real>* found = nullptr;
    for (std::size_t i = 0; i < size_ && value_of(pieces_[i].begin) <= t * nearly; ++i) found = &pieces_[i];
    return found;
  }

  void add(const ForcePiece<Real>& piece) { pieces_[size_++] = piece; }

  static constexpr double nearly = 1 + 4 * std::numeric_limits<double>::epsilon();

  std::array<ForcePiece<Real>, 3> pieces_{};
  std::size_t size_ = 0;
  double largest_ = 0, steepest_ = 0;  // the largest |value|, and the largest change in a second
  bool everywhere_ = false;            ///< the first piece holds at all times
};

/// A sweep through frequencies, as shakers do it: F cos(theta(t)) from start to start + duration, zero
/// outside. The frequency theta' runs from one end to the other: linear, w = from + (to - from) u/T;
/// logarithmic, w = from (to/from)^(u/T); u = t - start.
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

  /// Bound on its error at times near t, from rounding of its values and of the times.
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

  /// Sweep or silence, whichever holds at t, extended to all times.
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
  /// Time from the start until the angle has grown by this much [s].
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
  bool everywhere_ = false, on_ = false;  ///< everywhere_: on_ holds at all times
  Real amplitude_, log_ratio_ = Real(0);
};

/// Any of them.
template <class Real>
using GeneralDrive = std::variant<PulseDrive<Real>, ChirpDrive<Real>, SampledDrive>;

template <class Real>
PulseForce<Real> force_of(const PulseDrive<Real>& drive, const Real& mass) {
  return {drive, mass};
}
template <class Real>
ChirpForce<Real> force_of(const ChirpDrive<Real>& drive, const Real& mass) {
  return {drive, mass};
}
template <class Real>
SampledForce<Real> force_of(const SampledDrive& drive, const Real& mass) {
  return {drive, mass};
}

/// with_terms for one of these drives. It knows three sets of terms only (linear, any but friction, any),
/// since every set is compiled for every force.
template <class Real, class Drive, class F>
decltype(auto) with_terms_under(const Oscillator<Real>& oscillator, const Drive& drive, F&& f) {
  const Law present = law_of(oscillator);
  const Oscillator<Real> per_mass = divided_by_mass(oscillator);
  const auto force = force_of(drive, oscillator.mass);
  using Force = std::remove_const_t<decltype(force)>;
  const DrivenOscillator<Real, Terms{.drive = true, .law = any_terms}, Force> system(per_mass, force);
  if (present.has<Friction>())
    return std::forward<F>(f)(DryFriction(system, per_mass.friction, per_mass.static_friction));
  if (!is_linear(present)) return std::forward<F>(f)(system);
  return std::forward<F>(f)(
      DrivenOscillator<Real, Terms{.drive = true, .law = linear_terms}, Force>(per_mass, force));
}

/// The same for any of them.
template <class Real, class F>
decltype(auto) with_terms(const Oscillator<Real>& oscillator, const GeneralDrive<Real>& drive, F&& f) {
  return std::visit([&](const auto& one) -> decltype(auto) { return with_terms_under(oscillator, one, f); },
                    drive);
}

}  // namespace cromer::core
