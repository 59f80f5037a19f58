// What a method integrates of a forced motion: acceleration and, along with it, the derivatives by all
// parameters (the variational equation).
#pragma once

#include <cmath>

#include "cromer/identify/forced_law.h"
#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/tangent.h"

namespace cromer {

/// N is the number of parameters, or 0 for the motion alone. Drive gives its part of the acceleration at a
/// stage: add_to(parameters, t, value, by_parameter).
template <class Drive, ForcedTerms terms, int N>
class ForcedSystem {
 public:
  static constexpr ForcedLayout at = forced_layout(Drive::parameters, terms);
  static_assert(N == 0 || N == at.size);
  using Real = Tangent<N>;

  /// `biased`: the parameter bias is part of the acceleration; else it is none of the motion's.
  ForcedSystem(const Parameters& parameters, const Drive& drive, bool biased)
      : p_(parameters), drive_(drive), biased_(biased) {}

  Real acceleration(double t, const Real& position, const Real& velocity) const {
    const double z = position.value, v = velocity.value;
    // Value, slopes and terms of the sum.
    double sum = (biased_ ? p_[at.bias] : 0) - 2 * p_[at.decay] * v - p_[at.stiffness] * z;
    double by_z = -p_[at.stiffness], by_v = -2 * p_[at.decay];
    if constexpr (terms.drag) {
      sum -= p_[at.drag] * v * std::abs(v);
      by_v -= 2 * p_[at.drag] * std::abs(v);
    }
    if constexpr (terms.curved) {
      sum -= z * z * (p_[at.quadratic] + p_[at.cubic] * z);
      by_z -= z * (2 * p_[at.quadratic] + 3 * p_[at.cubic] * z);
    }
    Real result;
    if constexpr (N > 0) {
      auto& term = result.derivative;
      drive_.add_to(p_, t, sum, term.data());
      term[at.bias] = biased_ ? 1 : 0;
      term[at.decay] = -2 * v;
      if constexpr (terms.drag) term[at.drag] = -v * std::abs(v);
      term[at.stiffness] = -z;
      if constexpr (terms.curved) {
        term[at.quadratic] = -z * z;
        term[at.cubic] = -z * z * z;
      }
      for (int i = 0; i < N; ++i) term[i] += by_z * position.derivative[i] + by_v * velocity.derivative[i];
    } else {
      drive_.add_to(p_, t, sum, nullptr);
    }
    result.value = sum;
    return result;
  }

 private:
  const Parameters& p_;
  const Drive& drive_;
  bool biased_;
};

}  // namespace cromer
