// The harmonic drive for steps of a length that changes: ready at the nodes of each.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "cromer/base/dual.h"
#include "cromer/model/harmonic_force.h"

namespace cromer::core {

/// Slots, evenly spaced over a step, of which no two nodes share the nearest: at most 63. Nodes::nodes are
/// fractions of a step, from 0 to 1.
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

/// A harmonic force at the nodes of one step after another: while the step's length stays, the angles from
/// its start to the nodes do, and the next start is one turn on, cos(a + q) = cos a cos q - sin a sin q. A
/// cosine is asked for at every sixteenth step only, or where the length changes. Error: some twenty
/// roundings.
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
    // A start that is the last end but for rounding.
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
