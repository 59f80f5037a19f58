// What the whole law is like at one amplitude, in the words of the linear oscillator.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "cromer/identify/law_fit.h"
#include "cromer/tasks/fit/fitted_quantities.h"

namespace cromer::core {

/// Those that a goal may be set for, by name.
inline constexpr std::string_view derived_names[] = {"frequency",
                                                     "period",
                                                     "damping_ratio",
                                                     "quality_factor",
                                                     "logarithmic_decrement",
                                                     "limit_cycle_amplitude"};

/// frequency [Hz], period [s], damping_ratio, quality_factor, logarithmic_decrement and at_amplitude, the
/// amplitude at which they hold: that of the first sample, where viscous damping of this ratio takes as much
/// energy in a cycle as all terms of the law. The frequency is that of the springs at this amplitude, lowered
/// by the viscous term alone: drag and friction do not shift it to first order. Of the viscous law they do
/// not depend on the amplitude. Standard errors follow from the covariance of all parameters, start included.
/// Quantities that do not exist are NaN; of a hysteretic law, whose loops depend on how the motion came where
/// it is, there are none. `observed` and `derivative` as of law_parameters. Of a driven motion they are said
/// at the amplitude of a sinusoid as large as the law's motion `x` is on average (root mean square), which is
/// taken as given; of an overdamped law damping_ratio, quality_factor and at_amplitude alone. Of a swing that
/// negative damping feeds, limit_cycle_amplitude in place of the quality factor: where it keeps itself. Of a
/// body without a spring mass = 1/force_gain [unit of force per unit of acceleration] alone.
std::vector<Parameter> derived_quantities(const LawFit& fit, std::string_view observed, int derivative,
                                          const std::vector<double>& x = {},
                                          std::string_view force_unit = {});

}  // namespace cromer::core
