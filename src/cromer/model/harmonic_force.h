// The harmonic drive as a function of time: by cosine, or from a table for times on a grid.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "cromer/base/dual.h"
#include "cromer/model/next_turn.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

/// f cos(w t + phi).
template <class Real>
struct HarmonicForce {
  Real amplitude = 0;  // of the force, or of the acceleration [m/s^2]
  Real frequency = 0;  // [rad/s]
  Real phase = 0;      // [rad]

  template <class Time>
  Real operator()(const Time& t) const {
    using std::cos;
    return amplitude * cos(frequency * t + phase);
  }

  /// The first time after t at which it turns; infinite for a constant.
  double next_turn(double t) const {
    return time_of_next_half_turn(
        t, [&](double at) { return value_of(frequency) * at + value_of(phase); },
        [&](double angle) { return (angle - value_of(phase)) / value_of(frequency); });
  }

  /// The state at t of the motion through y0 at t0.
  State<Real> propagate(LinearLaw<Real> law, const Real& t0, const Real& t, const State<Real>& y0) const {
    law.drive_amplitude = amplitude;
    law.drive_frequency = frequency;
    law.drive_phase = phase;
    return cromer::core::propagate(law, t0, t, y0);
  }
};

/// The same at the times of a grid, without a cosine each: cos(a + j q) = cos a cos jq - sin a sin jq, with
/// the cosines and sines of j q made once and those of a once a block. Unlike a recurrence no error builds up
/// (at most three roundings, whatever the number of steps), no entry waits for the one before, and the tables
/// (4 kB) stay in the first-level cache.
template <class Real>
class TabulatedForce {
 public:
  static constexpr int block = 128;  ///< spacings that one move_to covers

  /// For times spacing [s] > 0 apart. Out of line, as move_to: once a block needs no copy in every loop.
  [[gnu::noinline]] TabulatedForce(const HarmonicForce<Real>& force, double spacing)
      : force_(force), spacing_(spacing), per_spacing_(1 / spacing) {
    using std::cos, std::sin;
    for (std::size_t j = 0; j <= block; ++j) {
      const Real angle = force.frequency * (static_cast<double>(j) * spacing);
      cosine_[j] = cos(angle);
      sine_[j] = sin(angle);
    }
  }

  /// Makes the table for first, first + spacing, ..., first + block * spacing.
  [[gnu::noinline]] void move_to(double first) {
    using std::cos, std::sin;
    first_ = first - 0.5 * spacing_;
    const Real anchor = force_.frequency * first + force_.phase;
    const Real c = force_.amplitude * cos(anchor), s = force_.amplitude * sin(anchor);
    for (std::size_t j = 0; j <= block; ++j) table_[j] = c * cosine_[j] - s * sine_[j];
  }

  /// t must be one of the times move_to made, to half a spacing.
  Real operator()(double t) const {
    return table_[static_cast<std::size_t>(static_cast<int>((t - first_) * per_spacing_))];
  }

 private:
  HarmonicForce<Real> force_;
  double spacing_, per_spacing_, first_ = 0;
  alignas(64) std::array<Real, block + 1> table_{}, cosine_{}, sine_{};
};

}  // namespace cromer::core
