// How fast the energy of a free motion grows or decays.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/line.h"
#include "cromer/base/state.h"
#include "cromer/model/oscillator.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// E(t) = E0 exp(rate t), fitted.
struct EnergyGrowth {
  double rate = 0;  // [1/s] negative for decay

  /// E after a period over E before; period [s].
  double factor_per_cycle(double period) const { return std::exp(rate * period); }
  /// [s] in which E doubles; negative for decay (then its size is the time in which it halves), infinite for
  /// a constant.
  double doubling_time() const { return std::numbers::ln2 / rate; }
};

/// Least squares of ln E against t, over all states (at least two, with positive energy): swings within a
/// cycle average out over many.
inline EnergyGrowth energy_growth(const Oscillator<double>& oscillator, const Trajectory& trajectory) {
  std::vector<double> logarithm(trajectory.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    logarithm[i] = std::log(energy(oscillator, State<double>{trajectory.x[i], trajectory.v[i]}));
  return {fit_line(trajectory.t, logarithm).slope};
}

}  // namespace cromer::core
