#pragma once

#include "cromer/methods/method.h"

namespace cromer::core {

/// The closed form, where the system has one. Every state is computed from the start of the run, so that no
/// error builds up; under a sampled drive it is computed from interval to interval.
struct Exact {
  static constexpr MethodInfo info{
      .name = "exact",
      .order = 0,
      .error_order = 0,
      .evaluations = 0,
      .implicit = false,
      .symplectic = true,
      .reversible = true,
      .a_stable = true,
      .divisions = 0,
      .source = "closed form; cromer/model/propagate.h",
  };

  /// Where the run began.
  template <class Real>
  struct Memory {
    Real t0;  // [s]
    State<Real> y0;
  };

  template <class S, class Time, class Real>
  requires ExactSystem<S, Real> Memory<Real> start(const S&, const Time& t, const State<Real>& y)
  const { return {Real(t), y}; }

  template <class S, class Time, class Real>
  requires ExactSystem<S, Real> Trial<Real> step(const S& system, const Time& t, const Time& h,
                                                 const State<Real>& y, Memory<Real>& memory)
  const {
    // With many pieces, each step would walk all the way from the start again.
    if constexpr (has_many_pieces<S>()) memory = {Real(t), y};
    return {.y = system.propagate(memory.t0, Real(t + h), memory.y0)};
  }

 private:
  template <class S>
  static constexpr bool has_many_pieces() {
    if constexpr (requires { S::has_many_pieces; })
      return S::has_many_pieces;
    else
      return false;
  }
};

}  // namespace cromer::core
