// The energy stored in the oscillator.
#pragma once

#include "cromer/base/state.h"
#include "cromer/model/law_force.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

/// The energy at y of what has this mass, and coefficients as sum_of_forces takes them.
template <Law law, class Source, class Real>
Real energy(const Real& mass, const Source& coefficients, [[maybe_unused]] Law present,
            const State<Real>& y) {
  Real sum = mass * (y.v * y.v) / Real(2);
  for_each_term([&]<class T>() {
    if constexpr (terms_of_position.has<T>() && (law == any_terms || law.has<T>())) {
      if (law == any_terms && !present.has<T>()) return;
      sum = sum + T::energy(y.x, coefficient_of<T>(coefficients));
    }
  });
  return sum;
}

/// m v^2/2 and what each term stores, k x^2/2 + k3 x^4/4 + ... [J]; negative in a double well is right. What
/// hysteresis stores is left out: it is not of x and v.
template <class Real>
Real energy(const Oscillator<Real>& oscillator, const State<Real>& y) {
  return energy<any_terms>(oscillator.mass, oscillator, law_of(oscillator), y);
}

}  // namespace cromer::core
