// The energy stored in the oscillator.
#pragma once

#include "cromer/base/state.h"
#include "cromer/model/oscillator.h"

namespace cromer {

/// m v^2/2 + k x^2/2 + k3 x^4/4 [J]; negative in a double well is right.
template <class Real>
constexpr Real energy(const Oscillator<Real>& oscillator, const State<Real>& y) {
  const Real x2 = y.x * y.x;
  return oscillator.mass * (y.v * y.v) / Real(2) +
         (oscillator.stiffness / Real(2) + oscillator.cubic * x2 / Real(4)) * x2;
}

}  // namespace cromer
