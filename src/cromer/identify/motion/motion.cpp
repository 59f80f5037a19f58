#include "cromer/identify/motion/motion.h"

#include <utility>

#include "cromer/identify/least_squares/levenberg_marquardt.h"

namespace cromer::core {

bool is_viscous_part(const Law& law, std::string_view parameter) {
  return !is_linear(law) && parameter == Viscous::coefficients[0].parameter;
}

Notice parameter_named(std::string_view name, const Law& law) {
  return Notice{is_viscous_part(law, name) ? "viscous_part" : std::string(name)};
}

Motion Motion::under(const Law& other) const {
  Motion motion = *this;
  motion.law = other;
  for_each_term([&]<class T>() {
    if (other.has<T>()) return;
    for (const auto member : T::template members<double>) motion.per_mass.*member = 0;
  });
  return motion;
}

Parameters FittedParameters::lower_bounds() const {
  Parameters lower = LeastSquaresOptions::no_bounds();
  for (int i = 0; i < count; ++i)
    if (of[i].is_never_negative()) lower[i] = 0;
  return lower;
}

FittedParameters fitted_parameters(const Law& law, DriveKind drive, HeldParameters held, const Motion& values,
                                   bool growing) {
  FittedParameters fitted;
  fitted.held = values;
  fitted.held.law = law;
  for_each_term([&]<class T>() {
    if (!law.has<T>()) return;
    for (std::size_t i = 0; i < coefficients_of<T>; ++i) {
      const CoefficientInfo& info = T::coefficients[i];
      fitted.of[fitted.count++] = {.name = info.parameter,
                                   .coefficient = T::template members<double>[i],
                                   .as = info.fitted,
                                   .may_be_negative = may_be_negative(info, law, growing)};
    }
  });
  // A pendulum's frequency is listed where a spring's is.
  const int swing = fitted.place_of("angular_frequency");
  for (int i = swing; i > 0; --i) std::swap(fitted.of[i], fitted.of[i - 1]);
  const auto add = [&](std::string_view name, double Motion::*member, bool at_rest = false) {
    fitted.of[fitted.count++] = {.name = name, .member = member, .lives_at_rest = at_rest};
  };
  if (is_recorded(drive)) {
    add("force_gain", &Motion::force_gain);
    if (!held.force_offset) add("force_offset", &Motion::force_offset, true);
  } else if (drive == DriveKind::harmonic) {
    add("drive_cosine", &Motion::cosine);
    add("drive_sine", &Motion::sine);
    add("drive_frequency", &Motion::drive_frequency);
  }
  if (!held.equilibrium) add("equilibrium", &Motion::equilibrium, true);
  if (!held.position) add("position", &Motion::position);
  add("velocity", &Motion::velocity);
  return fitted;
}

}  // namespace cromer::core
