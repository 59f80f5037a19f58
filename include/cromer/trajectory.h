// States of an oscillator: one, and those that a run keeps.
#pragma once

#include <cstddef>
#include <vector>

namespace cromer {

/// Position and velocity of one oscillator; of an angle in rad and rad/s.
template <class Real>
struct State {
  Real x;  // [m]
  Real v;  // [m/s]

  friend bool operator==(const State&, const State&) = default;
};

/// Kept states in order of time; the three columns have the same length. Of an angle x is in rad, v in rad/s.
struct Trajectory {
  std::vector<double> t;  // [s]
  std::vector<double> x;  // [m]
  std::vector<double> v;  // [m/s]

  std::size_t size() const { return t.size(); }
};

}  // namespace cromer
