// What a method integrates of a fitted motion: its acceleration and, along with it, the derivatives by every
// number that a fit may adjust (the variational equation).
//
// Each term's own force gives its slopes: it is called with a dual number of one derivative in one place at a
// time and plain doubles in the others. Duals carried through every product of the law would compute each
// derivative several times over.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "cromer/base/coupled.h"
#include "cromer/base/dual.h"
#include "cromer/identify/motion/motion.h"
#include "cromer/model/law_force.h"

namespace cromer::core {

/// What code is compiled for: a law (a superset of those that share it), a kind of drive, and whether
/// derivatives are wanted.
template <Law law_, class Drive_, bool with_derivatives>
struct MotionCode {
  static constexpr Law law = law_;
  using Drive = Drive_;
  static constexpr bool hysteretic = law.template has<Hysteresis>();
  static constexpr bool rubs = law.template has<Friction>();
  /// Where so many terms share the code, each is asked whether it is there.
  static constexpr bool asks = law.size() > 6;

  static constexpr std::size_t coefficients = [] {
    std::size_t count = 0;
    for_each_term([&]<class T>() { count += law.template has<T>() ? coefficients_of<T> : 0; });
    return count;
  }();
  /// Columns: the coefficients in the registry's order, the drive's, position and velocity at the start.
  static constexpr std::size_t drive_column = coefficients, position_column = coefficients + Drive::count,
                               velocity_column = position_column + 1;
  static constexpr std::size_t columns = with_derivatives ? velocity_column + 1 : 0;

  template <class T>
  static constexpr std::size_t column_of = [] {
    std::size_t column = 0;
    for_each_term([&]<class Each>() {
      if (law.template has<Each>() && place_of_term<Each> < place_of_term<T>) column += coefficients_of<Each>;
    });
    return column;
  }();

  using Number = Dual<double, columns>;
  using Real = std::conditional_t<hysteretic, Coupled<Number>, Number>;
};

/// A value and its slope, of a term's force; the slope of what does not depend on the dual is 0.
constexpr double slope_of(double) { return 0; }
constexpr double slope_of(const Dual<double, 1>& y) { return y.derivative[0]; }

/// One way of sliding; without friction, any way.
template <class Code>
class MotionSystem {
 public:
  using Number = typename Code::Number;
  using Real = typename Code::Real;
  static constexpr bool depends_on_velocity = true;

  /// Keeps references to both. `direction` is the sign of the velocity.
  MotionSystem(const Motion& motion, const typename Code::Drive& drive, int direction = 0)
      : motion_(&motion), drive_(&drive), direction_(direction) {}

  MotionSystem sliding(int direction) const { return {*motion_, *drive_, direction}; }
  const typename Code::Drive& drive() const { return *drive_; }

  /// [unit/s^2] at s [s] from the first sample.
  Number acceleration(double s, const Number& position, const Number& velocity) const {
    const double x = position.value, v = velocity.value;
    double sum = 0, by_x = 0, by_v = 0;
    Number result;
    drive_->add(s, sum, Code::columns > 0 ? result.derivative.data() + Code::drive_column : nullptr);
    for_each_term([&]<class T>() {
      if constexpr (Code::law.template has<T>() && smooth_terms.has<T>()) {
        if (Code::asks && !motion_->law.has<T>()) return;
        add<T>(x, v, sum, by_x, by_v, result);
      }
    });
    if constexpr (Code::rubs) {
      sum -= direction_ * motion_->per_mass.friction;
      if constexpr (Code::columns > 0) result.derivative[Code::template column_of<Friction>] = -direction_;
    }
    for (std::size_t i = 0; i < Code::columns; ++i)
      result.derivative[i] += by_x * position.derivative[i] + by_v * velocity.derivative[i];
    result.value = sum;
    return result;
  }

  /// The same with the hysteretic force beside the velocity, and that force's own rate.
  Coupled<Number> acceleration(double s, const Coupled<Number>& position,
                               const Coupled<Number>& velocity) const requires(Code::hysteretic) {
    const Number& force = velocity.second;
    return {acceleration(s, position.first, velocity.first) - force, rate(velocity.first, force)};
  }

 private:
  using One = Dual<double, 1>;

  template <class T>
  void add(double x, double v, double& sum, double& by_x, double& by_v, Number& result) const {
    const double p = motion_->per_mass.*T::template members<double>[0];
    sum -= T::force(x, v, p);
    by_x -= slope_of(T::force(One::variable(x, 0), v, p));
    by_v -= slope_of(T::force(x, One::variable(v, 0), p));
    if constexpr (Code::columns > 0)
      result.derivative[Code::template column_of<T>] = -slope_of(T::force(x, v, One::variable(p, 0)));
  }

  Number rate(const Number& velocity, const Number& force) const {
    const Oscillator<double>& law = motion_->per_mass;
    const double v = velocity.value, z = force.value, n = law.hysteresis_exponent;
    const double A = law.hysteresis_stiffness, beta = law.hysteresis_beta, gamma = law.hysteresis_gamma;
    Number result(Hysteresis::rate(v, z, A, beta, gamma, n));
    if constexpr (Code::columns > 0) {
      constexpr std::size_t column = Code::template column_of<Hysteresis>;
      const double by_v = slope_of(Hysteresis::rate(One::variable(v, 0), z, A, beta, gamma, n));
      const double by_z = slope_of(Hysteresis::rate(v, One::variable(z, 0), A, beta, gamma, n));
      for (std::size_t i = 0; i < Code::columns; ++i)
        result.derivative[i] = by_v * velocity.derivative[i] + by_z * force.derivative[i];
      result.derivative[column] += slope_of(Hysteresis::rate(v, z, One::variable(A, 0), beta, gamma, n));
      result.derivative[column + 1] += slope_of(Hysteresis::rate(v, z, A, One::variable(beta, 0), gamma, n));
      result.derivative[column + 2] += slope_of(Hysteresis::rate(v, z, A, beta, One::variable(gamma, 0), n));
    }
    return result;
  }

  const Motion* motion_;
  const typename Code::Drive* drive_;
  int direction_;
};

}  // namespace cromer::core
