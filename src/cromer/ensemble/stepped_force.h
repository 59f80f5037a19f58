// The harmonic drive of many oscillators, each at its own frequency, for one step after another.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "cromer/ensemble/step_time.h"
#include "cromer/model/harmonic_force.h"

namespace cromer {

/// f cos(w t + phi) at the nodes of steps, by Reinsch's form of the recurrence: of the second difference, so
/// that small angles lose nothing (J. Stoer & R. Bulirsch, Introduction to Numerical Analysis, 3rd
/// ed., 2.3.3). anchor() makes it exact again; between two anchors, a hundred steps apart, the error stays
/// below 1e-14 of f for every angle a step.
template <class Real, int divisions>
class SteppedForce {
 public:
  static_assert(divisions > 0);

  /// For steps of h [s].
  SteppedForce(const HarmonicForce<Real>& force, const Real& h) : force_(force) {
    const Real half = 0.5 / divisions * (force.frequency * h);
    half_sine_ = sin(half);
    half_cosine_ = cos(half);
    curvature_ = 4.0 * (half_sine_ * half_sine_);
  }

  /// Makes the step that begins at t [s] ready, exactly.
  void anchor(const Real& t) {
    // The difference from here to the next node: -2 sin(q/2) sin(a + q/2).
    const Real angle = force_.frequency * t + force_.phase;
    const Real c = cos(angle), s = sin(angle);
    value_[0] = force_.amplitude * c;
    difference_ = -2.0 * half_sine_ * (force_.amplitude * (s * half_cosine_ + c * half_sine_));
    fill();
  }

  /// Goes on to the next step.
  void move_on() {
    value_[0] = value_[divisions];
    difference_ -= curvature_ * value_[0];
    fill();
  }

  Real operator()(const StepTime<Real>& t) const {
    return value_[static_cast<std::size_t>(static_cast<int>(t.steps * divisions + 0.5))];
  }

 private:
  void fill() {
    value_[1] = value_[0] + difference_;
    for (std::size_t i = 2; i <= divisions; ++i) {
      difference_ -= curvature_ * value_[i - 1];
      value_[i] = value_[i - 1] + difference_;
    }
  }

  HarmonicForce<Real> force_;
  Real half_sine_, half_cosine_, curvature_, difference_{};
  std::array<Real, divisions + 1> value_{};
};

/// The same at any time, by a cosine each: for methods that do not ask at nodes.
template <class Real>
class SteppedForce<Real, 0> {
 public:
  SteppedForce(const HarmonicForce<Real>& force, const Real&) : force_(force) {}
  void anchor(const Real&) {}
  void move_on() {}
  Real operator()(const StepTime<Real>& t) const { return force_(t.seconds); }

 private:
  HarmonicForce<Real> force_;
};

/// No drive: nothing to make ready.
struct NoSteppedForce {
  template <class... T>
  explicit NoSteppedForce(const T&...) {}
};

/// cos(w t + phi) and sin(w t + phi) at the beginnings of steps: what a motion is measured against.
template <class Real>
class SteppedPhasor {
 public:
  SteppedPhasor(const HarmonicForce<Real>& force, const Real& h) : force_(force) {
    const Real angle = force.frequency * h;
    turn_cosine_ = cos(angle);
    turn_sine_ = sin(angle);
  }

  void anchor(const Real& t) {
    const Real angle = force_.frequency * t + force_.phase;
    cosine = cos(angle);
    sine = sin(angle);
  }

  void move_on() {
    const Real c = cosine * turn_cosine_ - sine * turn_sine_;
    sine = sine * turn_cosine_ + cosine * turn_sine_;
    cosine = c;
  }

  Real cosine{}, sine{};

 private:
  HarmonicForce<Real> force_;
  Real turn_cosine_, turn_sine_;
};

}  // namespace cromer
