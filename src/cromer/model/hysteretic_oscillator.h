// The law with a force that has memory: its inner state z rides beside the velocity (base/coupled.h).
#pragma once

#include "cromer/base/coupled.h"
#include "cromer/model/law.h"
#include "cromer/model/law_force.h"
#include "cromer/model/oscillator.h"

namespace cromer::core {

/// x'' = f(t) - z - the sum of the other smooth terms' forces, z' = the rate of the hysteresis; all per unit
/// mass. Force gives f(t) [m/s^2], with its breaks if it has any.
template <class Force>
class HystereticOscillator {
 public:
  HystereticOscillator(const Oscillator<double>& per_mass, const Force& force)
      : law_(per_mass), present_(law_of(per_mass)), force_(force) {}

  /// [m/s^2], and of z [m/s^3]. T is double, or a Dual over it.
  template <class Time, class T>
  Coupled<T> acceleration(const Time& t, const Coupled<T>& x, const Coupled<T>& v) const {
    const T& z = v.second;
    const T smooth = resisting_force<any_terms>(law_, present_, x.first, v.first) +
                     restoring_force<any_terms>(law_, present_, x.first);
    return {T(force_(t)) - z - smooth, rate(v.first, z)};
  }

  /// z' [m/s^3]
  template <class T>
  T rate(const T& v, const T& z) const {
    return Hysteresis::rate(v, z, law_.hysteresis_stiffness, law_.hysteresis_beta, law_.hysteresis_gamma,
                            law_.hysteresis_exponent);
  }

  /// The first time after t [s] at which the drive is not smooth.
  double next_break(double t) const requires(requires(const Force& f) { f.next_break(0.0); }) {
    return force_.next_break(t);
  }

  /// The law with the piece of the drive that holds at t, extended to all times.
  HystereticOscillator within(double t) const requires(requires(const Force& f) { f.within(0.0); }) {
    HystereticOscillator smooth = *this;
    smooth.force_ = force_.within(t);
    return smooth;
  }

  /// Whether steps of this length [s] from t = 0 on have no break inside and no jump at their ends.
  bool is_smooth_in_steps(double step) const {
    if constexpr (requires { force_.is_smooth_in_steps(step); }) return force_.is_smooth_in_steps(step);
    return false;
  }

 private:
  Oscillator<double> law_;  // its mass is not used
  Law present_;
  Force force_;
};

}  // namespace cromer::core
