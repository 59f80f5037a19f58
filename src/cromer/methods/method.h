// What a method of integration is: its contract, what it carries from step to step, and its formula.
//
// A method is one struct in one header: `info`, `Memory<Real>`, `start` and `step`, over any scalar and any
// System. To add one, write that header and name it in methods/all.h; tests, tables and commands find it
// there.
#pragma once

#include <concepts>
#include <string_view>

#include "cromer/base/magnitude.h"
#include "cromer/base/state.h"

namespace cromer::core {

/// What is known of a method before it runs.
struct MethodInfo {
  std::string_view name;          ///< as typed: "euler-cromer"
  int order;                      ///< of the global error; 0 where there is none (exact)
  int error_order;                ///< of the embedded error estimate; > 0 for adaptive methods
  int evaluations;                ///< of the acceleration a step, besides those of Newton's iterations
  int iteration_evaluations = 1;  ///< of the acceleration a Newton iteration
  bool implicit;                  ///< a step solves an equation
  bool symplectic;                ///< of the undamped law
  bool reversible = false;        ///< a step back undoes a step
  bool a_stable = false;          ///< stable at any step where the linear law is
  int divisions;                  ///< a step asks for accelerations at t + i h/divisions only; 0: elsewhere
  std::string_view source;        ///< who published it

  /// A closed form of the motion.
  constexpr bool is_exact() const { return order == 0; }
  /// Chooses its steps by its error estimate.
  constexpr bool is_adaptive() const { return error_order > 0; }
  /// The position moves through a whole step with the velocity at its end, and no energy is lost.
  constexpr bool moves_with_last_velocity() const { return symplectic && order == 1; }
  /// Has a formula for one step of a given length.
  constexpr bool takes_fixed_steps() const { return !is_exact() && !is_adaptive(); }

  /// Of the acceleration, for so many steps with so many Newton iterations in all.
  constexpr long long evaluations_of(long long steps, long long newton_iterations) const {
    return steps * evaluations + newton_iterations * iteration_evaluations;
  }
};

/// What one step gives.
template <class Real>
struct Trial {
  State<Real> y;
  State<Real> error{};           ///< estimate, of adaptive methods
  int newton_iterations = 0;     ///< of implicit methods
  Truth<Real> converged = true;  ///< false: the iteration limit was reached, y is not a solution
};

/// For methods that carry nothing.
struct NoMemory {};

/// M integrates S: start makes the memory for a run from y at t, step goes from y at t to t + h.
template <class M, class S, class Real>
concept Method = requires(const M& method, const S& system, double t, double h, State<Real> y,
                          typename M::template Memory<Real> memory) {
  { M::info } -> std::convertible_to<MethodInfo>;
  { method.start(system, t, y) } -> std::convertible_to<typename M::template Memory<Real>>;
  { method.step(system, t, h, y, memory) } -> std::convertible_to<Trial<Real>>;
};

/// One step out of line, for where a call does not count: compiled once for each system and method.
template <class S, class M, class Real, class Memory>
[[gnu::noinline]] Trial<Real> one_step(const S& system, const M& method, double t, double h,
                                       const State<Real>& y, Memory& memory) {
  return method.step(system, t, h, y, memory);
}

/// A method that asks for accelerations at other times than t + i h/divisions, `start` apart: asked_at()
/// gives the fractions of a step, so that a drive can be made ready there. If there is more than one,
/// asked_at() is static.
template <class M>
concept AsksAtFractions = requires(const M& method) {
  method.asked_at()[0];
};

/// A method whose error estimate can choose the steps. info.error_order > 0: Trial.error is the embedded
/// estimate, of order h^(error_order + 1). dense_output(memory) is the last step, from t to t + h, as a
/// function: called with theta, 0 to 1, it gives the state at t + theta h. A method that names its nodes, the
/// fractions of a step at which it asks for accelerations, gets a drive that is ready there.
///
/// Memory is a value. To try a step, give `step` a copy: the copy of an accepted step is the new memory, that
/// of a rejected one is thrown away. Once the loop inlines them the copies cost nothing.
template <class M, class S, class Real>
concept AdaptiveMethod = Method<M, S, Real> && M::info.is_adaptive() &&
                         requires(const M& method, const typename M::template Memory<Real>& memory,
                                  double theta) {
  { method.dense_output(memory)(theta) } -> std::convertible_to<State<Real>>;
};

/// A method that carries an acceleration of its own, which is not that of the state, gives it as
/// carried(memory), a reference: a step then maps three numbers, not two.
template <class M, class Memory>
concept CarriesAcceleration = requires(const M& method, Memory& memory) {
  method.carried(memory);
};

/// False only where the system's type says so: methods then need not solve an equation for v'.
template <class S>
constexpr bool depends_on_velocity() {
  if constexpr (requires { S::depends_on_velocity; })
    return S::depends_on_velocity;
  else
    return true;
}

/// The same for systems that say at run time whether they resist.
template <class S>
constexpr bool depends_on_velocity([[maybe_unused]] const S& system) {
  if constexpr (requires { system.resists(); })
    return system.resists();
  else
    return depends_on_velocity<S>();
}

}  // namespace cromer::core
