// Forces that begin, and end: a step and pulses. Each is a few pieces, and each piece has a closed form.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "cromer/base/dual.h"
#include "cromer/model/propagate.h"
#include "cromer/model/ramp_response.h"

namespace cromer::core {

enum class PulseShape { step, rectangular, half_sine, triangular };

/// Zero before start and, but for the step, from start + duration on; at a jump the value after it holds. The
/// triangle is symmetric.
template <class Real>
struct PulseDrive {
  PulseShape shape = PulseShape::step;
  Real amplitude = 0;  // [N] the largest force, any sign
  Real start = 0;      // [s] >= 0
  Real duration = 0;   // [s] > 0; not looked at by the step

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

  /// How far rounding, of its values and of times near t, may put it off.
  double rounding(double t) const {
    return std::numeric_limits<double>::epsilon() * (largest_ + std::abs(t) * steepest_);
  }

  /// The first time after t at which a piece begins.
  double next_break(double t) const {
    for (std::size_t i = 0; i < size_; ++i)
      if (const double begin = value_of(pieces_[i].begin); begin > t * nearly) return begin;
    return std::numeric_limits<double>::infinity();
  }

  /// The piece that holds at t, at all times: smooth, and the same until the next break.
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

  /// The piece that holds at t; nullptr before the first. A time that is a start to rounding is one.
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
  double largest_ = 0, steepest_ = 0;  // of its size, and of its change in a second
  bool everywhere_ = false;            ///< the first piece holds at all times
};

}  // namespace cromer::core
