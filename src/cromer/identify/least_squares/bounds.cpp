#include "cromer/identify/least_squares/bounds.h"

#include <fmt/format.h>

#include <algorithm>

#include "cromer/identify/diagnose/mean_decay.h"

namespace cromer {
namespace {

bool cannot_be_negative(double MotionParameters::*member) {
  return member == &MotionParameters::decay_rate || member == &MotionParameters::drag ||
         member == &MotionParameters::friction;
}

void move(Estimate& estimate, double to, bool bounded) {
  const double shift = to - estimate.value;
  estimate.low = std::min(estimate.low + shift, estimate.value);
  estimate.high = std::max(estimate.high + shift, estimate.value);
  if (!bounded) return;
  estimate.low = std::max(estimate.low, 0.0);
}

void warn(FreeDecay& fit, const Estimate& estimate, std::string_view what, std::string_view damping) {
  if (estimate.value <= 0)
    fit.warnings.push_back(fmt::format("the {} is on its bound 0: the record shows no {}", what, damping));
  else if (estimate.low <= 0)
    fit.warnings.push_back(fmt::format(
        "the 95 % interval of the {} is cut at its bound 0: the record does not show that there is any {}",
        what, damping));
}

}  // namespace

Parameters lower_bounds(const FittedParameters& fitted) {
  Parameters lower = LeastSquaresOptions::no_bounds();
  for (int i = 0; i < fitted.count; ++i)
    if (cannot_be_negative(fitted.member[i])) lower[i] = 0;
  return lower;
}

void set_intervals(FreeDecay& fit, const MotionParameters& free_minimum, const Record& record) {
  move(fit.angular_frequency, free_minimum.angular_frequency, false);
  if (fit.law.viscous) move(fit.decay_rate, free_minimum.decay_rate, true);
  if (fit.drag) move(*fit.drag, free_minimum.drag, true);
  if (fit.friction) move(*fit.friction, free_minimum.friction, true);
  if (fit.cubic) move(*fit.cubic, free_minimum.cubic, false);
  move(fit.equilibrium, free_minimum.equilibrium, false);
  move(fit.position, free_minimum.position, false);
  move(fit.velocity, free_minimum.velocity, false);

  const auto unsure = [](const Estimate& term) { return term.low <= 0; };
  const bool any_unsure = (fit.law.viscous && unsure(fit.decay_rate)) || (fit.drag && unsure(*fit.drag)) ||
                          (fit.friction && unsure(*fit.friction));
  if (any_unsure && dampings_are_collinear(fit)) {
    std::string cut;
    const auto add = [&](bool there, const Estimate& term, const char* name) {
      if (there && unsure(term)) cut += (cut.empty() ? "" : " and the ") + std::string(name);
    };
    const Estimate none;
    add(fit.law.viscous, fit.decay_rate, "decay rate");
    add(fit.drag.has_value(), fit.drag.value_or(none), "drag");
    add(fit.friction.has_value(), fit.friction.value_or(none), "friction");
    fit.warnings.push_back(fmt::format(
        "the damping terms of {} cannot be told apart here: their sum is known, {}, its parts are "
        "not, and the interval of the {} is cut at its bound 0",
        to_text(fit.law), to_text(mean_decay(fit, record)), cut));
    return;
  }
  if (fit.law.viscous) warn(fit, fit.decay_rate, "decay rate", "viscous damping");
  if (fit.drag) warn(fit, *fit.drag, "drag", "drag");
  if (fit.friction) warn(fit, *fit.friction, "friction", "dry friction");
}

}  // namespace cromer
