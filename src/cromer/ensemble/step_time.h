// Times as a method sees them inside a step: in seconds, and counted in steps from the step's start.
#pragma once

#include <cstddef>

#include "cromer/base/dual.h"

namespace cromer::core {

/// The `Time` of a step whose drive is ready at the step's nodes. The count is the same for all lanes and
/// known when the method is compiled, so that a drive finds its node without looking at the seconds.
template <class Real>
struct StepTime {
  Real seconds;  // [s]
  double steps = 0;

  friend StepTime operator+(const StepTime& a, const StepTime& b) {
    return {a.seconds + b.seconds, a.steps + b.steps};
  }
  friend StepTime operator*(double a, const StepTime& b) { return {a * b.seconds, a * b.steps}; }
  friend StepTime operator/(const StepTime& a, double b) { return {a.seconds / b, a.steps / b}; }

  /// A step's length as a factor.
  friend Real operator*(const StepTime& h, const Real& a) { return h.seconds * a; }
  template <std::size_t N>
  friend Dual<Real, N> operator*(const StepTime& h, const Dual<Real, N>& a) {
    return h.seconds * a;
  }
  friend Real operator*(const StepTime& a, const StepTime& b) { return a.seconds * b.seconds; }

  friend auto value_of(const StepTime& t) { return value_of(t.seconds); }
};

}  // namespace cromer::core
