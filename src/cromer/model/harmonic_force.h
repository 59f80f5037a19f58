// The harmonic drive as a function of time: by cosine, from a table for times on a grid, or ready at the
// nodes of one step after another.
//
// Every force has next_turn(t), the first time after t [s] at which it may turn or jump; infinite where there
// is none. In between it only rises or only falls, so that its values at both ends bound it: that is what a
// mass held at rest by friction needs to know.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "cromer/base/dual.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

/// The first time after t at which cos(angle) turns, where the angle passes a multiple of pi: angle_at(t)
/// never falls, time_of(angle) is its inverse, and not a number or infinite for an angle that is never
/// reached.
template <class AngleAt, class TimeOf>
double time_of_next_half_turn(double t, const AngleAt& angle_at, const TimeOf& time_of) {
  const double passed = std::floor(angle_at(t) / std::numbers::pi);
  // The next multiple may be t itself, rounded.
  for (int i = 1; i <= 2; ++i)
    if (const double next = time_of((passed + i) * std::numbers::pi); next > t) return next;
  return std::numeric_limits<double>::infinity();
}

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

/// The fewest slots, evenly spaced over a step, so that no two nodes have the same nearest slot: at most 63,
/// or 0 if that is too few. Nodes::nodes are fractions of a step, from 0 to 1.
template <class Nodes>
constexpr std::size_t slots_for_nodes() {
  for (std::size_t slots = 1; slots < 64; ++slots) {
    std::array<bool, 65> taken{};
    bool alone = true;
    for (const double node : Nodes::nodes) {
      bool& slot = taken[static_cast<std::size_t>(node * static_cast<double>(slots) + 0.5)];
      alone = alone && !slot;
      slot = true;
    }
    if (alone) return slots;
  }
  return 0;
}

/// A harmonic force at the nodes of one step after another. While the step's length stays the same, so do
/// the angles from its start to its nodes, and the next start is one turn on: cos(a + q) = cos a cos q - sin
/// a sin q. Cosines are computed at every sixteenth step only, and where the length changes. Error: some
/// twenty roundings.
template <class Real, class Nodes>
class NodeForce {
 public:
  explicit NodeForce(const HarmonicForce<Real>& force) : force_(force) {}

  /// Makes the nodes of the step from t to t + h ready, h > 0 [s].
  void move_to(double t, double h) {
    if (h != length_) {
      turn_by(h);
      turns_ = most_turns;
    }
    // The start is the last end, but for rounding.
    const bool next = std::abs(t - (start_ + h)) <= 4 * std::numeric_limits<double>::epsilon() * std::abs(t);
    start_ = t;
    if (next && turns_ < most_turns) {
      ++turns_;
      const Real c = along_, s = across_;
      along_ = c * cosine_[slots] - s * sine_[slots];
      across_ = s * cosine_[slots] + c * sine_[slots];
    } else {
      using std::cos, std::sin;
      turns_ = 1;
      const Real angle = force_.frequency * t + force_.phase;
      along_ = force_.amplitude * cos(angle);
      across_ = force_.amplitude * sin(angle);
    }
    const Real c = along_, s = across_;
    for (const std::size_t i : used) value_[i] = c * cosine_[i] - s * sine_[i];
  }

  /// t must be at one of the nodes, to half a slot.
  Real operator()(double t) const {
    return value_[static_cast<std::size_t>(static_cast<int>((t - start_) * per_slot_ + 0.5))];
  }

 private:
  static constexpr std::size_t slots = slots_for_nodes<Nodes>();
  static constexpr int most_turns = 16;  ///< between two cosines
  static_assert(slots > 0, "nodes lie too close");
  static_assert(Nodes::nodes.back() == 1, "the end of a step is where the next one starts");

  static constexpr std::size_t slot_of(double node) {
    return static_cast<std::size_t>(node * static_cast<double>(slots) + 0.5);
  }
  static constexpr auto used = [] {
    std::array<std::size_t, Nodes::nodes.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = slot_of(Nodes::nodes[i]);
    return all;
  }();

  void turn_by(double h) {
    using std::cos, std::sin;
    length_ = h;
    per_slot_ = static_cast<double>(slots) / h;
    for (const double node : Nodes::nodes) {
      const Real angle = force_.frequency * (node * h);
      cosine_[slot_of(node)] = cos(angle);
      sine_[slot_of(node)] = sin(angle);
    }
  }

  HarmonicForce<Real> force_;
  double start_ = 0, length_ = 0, per_slot_ = 0;  // [s], [s], [1/s]
  int turns_ = most_turns;
  Real along_{}, across_{};  // amplitude times cosine and sine at the start
  std::array<Real, slots + 1> value_{}, cosine_{}, sine_{};
};

}  // namespace cromer::core
