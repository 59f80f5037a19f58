#include "cromer/tasks/fit/beside_pendulum.h"

#include <algorithm>
#include <cmath>

#include "cromer/base/quantity.h"
#include "cromer/identify/diagnose/doubts.h"
#include "cromer/model/terms/term.h"
#include "cromer/tasks/fit/fitted_quantities.h"

namespace cromer::core {

Notice arc_beside_pendulum(const FittedRecording& fitted) {
  const Estimate* w = fitted.find("angular_frequency");
  const double radius = fitted.series.arc_radius, error = radius * fitted.series.scale_error;
  if (!w || !(radius > 0) || is_linear(fitted.fit.law)) return {};
  const Estimate length = pendulum_length(*w).estimate;
  constexpr double gravity = 0.003;  // of g, over the Earth
  constexpr double agrees = 2;       // standard errors
  const double off = std::abs(length.value - radius);
  Notice told{off < agrees * std::hypot(error, length.standard_error, gravity * radius)
                  ? "arc_as_pendulum"
                  : "arc_beside_pendulum"};
  told.values = {{"length", format_quantity({length.value, length.standard_error}, "m")},
                 {"radius", format_quantity({radius, error}, "m")},
                 {"off", 100 * off / radius},
                 {"which", Notice{length.value > radius ? "longer" : "shorter"}}};
  return told;
}

Notice cubic_beside_pendulum(const FittedRecording& fitted) {
  constexpr Law other_odd_terms = law_with<OddQuadratic, Quintic, Pendulum>;
  const Law& law = fitted.fit.law;
  const Estimate *w = fitted.find("angular_frequency"), *cubic = fitted.find("cubic");
  if (!w || !cubic || fitted.driven || !fitted.series.quantity.starts_with("ang") ||
      law.shares(other_odd_terms) ||
      std::any_of(fitted.notices.begin(), fitted.notices.end(), is_of_no_law) || !(cubic->standard_error > 0))
    return {};
  const double pendulum = -w->value * w->value / 6;
  if (!(cubic->low <= pendulum && pendulum <= cubic->high)) return {};
  return Notice{"cubic_of_a_pendulum", {{"size", -pendulum}}};
}

}  // namespace cromer::core
