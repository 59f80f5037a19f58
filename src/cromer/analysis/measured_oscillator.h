// Frequency, decay and growth of a free motion, measured on its states.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "cromer/model/oscillator.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// A place where the motion turns.
struct TurningPoint {
  double t = 0;  // [s]
  double x = 0;  // [m]
};

/// Where the velocity changes sign, seen by three states before and three after: one nearer to an end of the
/// trajectory is left out. Error with h from state to state: about (w h)^5/6 of t in periods/2 pi, where
/// friction acts as well; (w h)^6/300 of x in amplitudes, (w h)^2/60 of what friction takes of them in half a
/// cycle. A mass that comes to rest turns there once.
std::vector<TurningPoint> turning_points(const Trajectory& trajectory);

/// A free motion's mean frequency and decay, from its turning points. Of any law; where the frequency changes
/// with the amplitude these are means over the run.
struct MeasuredOscillator {
  double angular_frequency = 0;  // [rad/s] half turns over the time they took
  double decay_rate = 0;         // [1/s] fitted to the logarithm of the amplitudes
  double first_amplitude = 0;    // [m] half the way from the first turning point to the second
  double last_amplitude = 0;     // [m] likewise at the end
  int half_cycles = 0;           ///< turning points less one
};

/// Empty with fewer than three turning points: no oscillation was seen.
std::optional<MeasuredOscillator> measure_oscillator(const Trajectory& trajectory);

/// Decay and frequency of the recurrence x[n+1] = p x[n] - q x[n-1] that equally spaced states of the linear
/// law obey exactly, whatever the method: by least squares over stretches of about a radian. `spacing` [s] of
/// the states, `angular_frequency` [rad/s] roughly. Error: 1e-14 of the frequency. Empty where the states do
/// not oscillate, or are fewer than three radians.
struct Recurrence {
  double angular_frequency = 0;  // [rad/s]
  double decay_rate = 0;         // [1/s]
};
std::optional<Recurrence> measure_recurrence(const std::vector<double>& x, double spacing,
                                             double angular_frequency);

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
EnergyGrowth energy_growth(const Oscillator<double>& oscillator, const Trajectory& trajectory);

}  // namespace cromer::core
