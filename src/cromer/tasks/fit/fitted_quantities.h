// From a fitted law to the numbers people ask for: its own parameters, those that a mass gives, and what the
// law is like at one amplitude in the words of the linear oscillator. Each has its uncertainty by the law of
// propagation (JCGM 100:2008, 5.1 and 5.2).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/quantity.h"
#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// What oscillates, and what it moves through.
struct Body {
  std::optional<Quantity> mass{};           // [kg] > 0
  std::optional<Quantity> spring_mass{};    // [kg] >= 0
  std::optional<Quantity> disc_diameter{};  // [m] > 0
  Quantity temperature{293.15, 0};          // [K] > 0, of the air

  /// mass + spring_mass/3, [kg]; only with a mass.
  Quantity effective_mass() const;
};

/// "m" from "m", "m/s" or "m/s²", the unit of a record that is this derivative of the displacement.
std::string displacement_unit(std::string_view unit, int derivative);

/// Per unit mass, in the order of fitted_parameters(); `observed` is the unit of the record, which is this
/// derivative of the displacement, `force_unit` that of a recorded force, "" where there is none or it is not
/// known.
std::vector<Parameter> law_parameters(const LawFit& fit, std::string_view observed, int derivative,
                                      std::string_view force_unit = {});

/// With a mass and a record of lengths or its derivatives: each term's coefficient in SI (stiffness, damping,
/// drag_constant, …), the force of a harmonic drive, and with a disc drag_coefficient: C_d = 2 d/(rho S),
/// where S = pi D^2/4 and rho is dry air's density at the temperature. Averaged over a cycle that is 3 pi m
/// q/(2 rho S w), q the slope of the decay rate against amplitude.
std::vector<Parameter> force_parameters(const LawFit& fit, const Body& body);

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
