// The forces that act on the mass, term by term.
#pragma once

#include <algorithm>
#include <cmath>

#include "cromer/analysis/energy_balance.h"
#include "cromer/base/state.h"
#include "cromer/model/law_force.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

/// [N] As they act: their sum is mass times acceleration.
struct Forces {
  double spring = 0;           ///< of all terms of the position
  OfResistances resistance{};  ///< of each of them
  double drive = 0;

  double sum() const { return spring + resistance.sum() + drive; }
};

/// Of the law's terms that are `present`, under the drive's force [N]. At rest friction balances the others
/// as far as it can, else it acts against the way they pull. Of a law without hysteresis, whose force is no
/// function of the state.
inline Forces forces_on(const Oscillator<double>& law, Law present, double drive, const State<double>& y) {
  Forces forces{.spring = -restoring_force<any_terms>(law, present, y.x), .drive = drive};
  for_each_resistance([&]<class T>() {
    if (present.has<T>()) forces.resistance.of<T>() = -T::force(y.x, y.v, coefficient_of<T>(law));
  });
  if (y.v == 0 && present.has<Friction>()) {
    const double pull = forces.sum(), holding = std::max(law.friction, law.static_friction);
    forces.resistance.of<Friction>() = std::abs(pull) <= holding ? -pull : -std::copysign(law.friction, pull);
  }
  return forces;
}

}  // namespace cromer::core
