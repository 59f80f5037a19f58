// The numbers that fix one motion, and which of them a fit adjusts.
//
//   x'' = drive(t) - the forces of the law's terms per unit mass,   x = y - equilibrium
//
// The drive is none, harmonic with C cos(w s) + S sin(w s), s from the first sample, or recorded:
// force_gain (u(t) + force_offset). A record of velocities or accelerations is compared with x' or x'' + the
// equilibrium, which then is the sensor's offset; all else stays what it is of the displacement x, whose unit
// is that of the record times s or s^2.
#pragma once

#include <cmath>
#include <string_view>

#include "cromer/base/dual.h"
#include "cromer/identify/law.h"
#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/model/law.h"

namespace cromer::core {

enum class DriveKind { none, harmonic, recorded };

/// The page fits no motion under a recorded force, and does not carry what that takes.
#ifdef CROMER_PAGE
inline constexpr bool fits_recorded_forces = false;
#else
inline constexpr bool fits_recorded_forces = true;
#endif
constexpr bool is_recorded(DriveKind kind) { return fits_recorded_forces && kind == DriveKind::recorded; }

/// One motion; coefficients of terms that the law lacks are 0.
struct Motion {
  Law law = law_of("viscous");
  Oscillator<double> per_mass{.stiffness = 0};
  double cosine = 0, sine = 0;  // [unit/s^2] of a harmonic drive
  double drive_frequency = 0;   // [rad/s]
  double force_gain = 0;        // [unit/s^2 per unit of force]
  double force_offset = 0;      // [unit of force]
  double equilibrium = 0;       // [unit of the record]
  double position = 0;          // [unit] from the equilibrium, at the first time
  double velocity = 0;          // [unit/s] at the first time

  /// Of small swings, undamped [rad/s]; 0 without a spring.
  double angular_frequency() const {
    const double squared = per_mass.stiffness + per_mass.pendulum + per_mass.hysteresis_stiffness;
    return squared > 0 ? std::sqrt(squared) : 0;
  }
  /// Of the viscous term [1/s].
  double decay_rate() const { return per_mass.damping / 2; }
  /// Sets the spring, or the pendulum in its place.
  void set_angular_frequency(double w) {
    (law.has<Pendulum>() ? per_mass.pendulum : per_mass.stiffness) = w * w;
  }
  void set_decay_rate(double g) { per_mass.damping = 2 * g; }

  /// The same numbers under another law: coefficients of terms that it lacks are 0.
  Motion under(const Law& other) const;
};

/// A parameter of a law in a sentence: a clause whose code is its name, "decay rate" of "decay_rate"; beside
/// other terms that is the viscous part of it.
Notice parameter_named(std::string_view name, const Law& law);

/// Where the law is not linear the parameter of the viscous term is not the rate of the swing.
bool is_viscous_part(const Law& law, std::string_view parameter);

/// One number that a fit adjusts.
struct FittedParameter {
  std::string_view name;                              ///< as in JSON
  double Oscillator<double>::*coefficient = nullptr;  ///< of the law, or
  double Motion::*member = nullptr;                   ///< of the rest
  FittedAs as = FittedAs::itself;
  bool may_be_negative = true;
  bool lives_at_rest = false;  ///< at zero frequency, as an equilibrium: not at the swing's own

  /// A frequency is the root of a stiffness, which is never negative either.
  bool is_never_negative() const { return !may_be_negative || as == FittedAs::square_root; }

  double of(const Motion& motion) const {
    if (member) return motion.*member;
    return as_fitted(as, motion.per_mass.*coefficient);
  }
  void set(Motion& motion, double value) const {
    if (member)
      motion.*member = value;
    else
      motion.per_mass.*coefficient = from_fitted(as, value);
  }
  /// The derivative of the coefficient by the parameter.
  double slope(double value) const {
    return from_fitted(as, Dual<double, 1>::variable(value, 0)).derivative[0];
  }
};

/// A parameter that says where the motion begins, and nothing of its law.
constexpr bool is_of_the_start(std::string_view name) { return name == "position" || name == "velocity"; }

/// All that a fit adjusts, in the order of fitted_parameters(); what is not fitted keeps the value of `held`.
struct FittedParameters {
  int count = 0;
  FittedParameter of[max_parameters]{};
  Motion held{};

  Parameters pack(const Motion& motion) const {
    Parameters parameters{};
    for (int i = 0; i < count; ++i) parameters[i] = of[i].of(motion);
    return parameters;
  }
  Motion unpack(const Parameters& parameters) const {
    Motion motion = held;
    for (int i = 0; i < count; ++i) of[i].set(motion, parameters[i]);
    return motion;
  }
  /// -1 where it is not fitted.
  int place_of(std::string_view name) const {
    for (int i = 0; i < count; ++i)
      if (of[i].name == name) return i;
    return -1;
  }
  /// 0 for what cannot be negative and for roots, -inf for all else.
  Parameters lower_bounds() const;
};

/// What is known beforehand and therefore not fitted.
struct HeldParameters {
  bool equilibrium = false;
  bool force_offset = false;
  bool position = false;
};

/// What a fit of `law` under a drive adjusts, in the order of the law's terms, the drive's numbers, then
/// offset or equilibrium, position, velocity; the angular frequency first. Parameters marked in `held` keep
/// their value from `values`; the motion's law becomes `law`. `growing` as in may_be_negative().
FittedParameters fitted_parameters(const Law& law, DriveKind drive = DriveKind::none,
                                   HeldParameters held = {}, const Motion& values = {}, bool growing = false);

}  // namespace cromer::core
