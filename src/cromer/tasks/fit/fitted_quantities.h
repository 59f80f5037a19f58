// From a fitted law to the numbers people ask for: its own parameters, those that a mass gives, and what the
// law is like at one amplitude in the words of the linear oscillator. Each has its uncertainty by the law of
// propagation (JCGM 100:2008, 5.1 and 5.2).
#pragma once

#include <optional>
#include <span>
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

/// The law's parameters per unit mass, in the order of fitted_parameters(), with their units by
/// unit_of_parameter().
std::vector<Parameter> law_parameters(const LawFit& fit, std::string_view observed, int derivative,
                                      std::string_view force_unit = {});

/// The parameters in SI, of a body with a mass (else none) and a record of a length or its derivatives: each
/// term's coefficient (stiffness, damping, drag_constant, …), the force of a harmonic drive and, with a disc,
/// drag_coefficient: C_d = 2 d/(rho S), where S = pi D^2/4 and rho is the density of dry air at the
/// temperature. `length` is the unit of displacements; of one that is not known no newtons are named.
/// Averaged over a cycle this is 3 pi m q/(2 rho S w), q being the slope of the decay rate against amplitude.
std::vector<Parameter> force_parameters(const LawFit& fit, const Body& body, std::string_view length);

/// Which of the parameters are the coefficients of the law, in the order of its terms: those in SI where a
/// mass gives them, else those per unit mass. drag_coefficient comes last.
std::vector<std::string> coefficient_names(const Law& law, const std::vector<Parameter>& parameters);

/// Derived quantities that a goal may be set for.
extern const std::span<const std::string_view> derived_names;

/// What the whole law is like at one amplitude, in the words of the linear oscillator: frequency [Hz], period
/// [s], damping_ratio, quality_factor, logarithmic_decrement, and at_amplitude, the amplitude at which they
/// hold.
///
/// Free motion: the amplitude of the first sample. Driven motion: that of a sinusoid with the root mean
/// square of the law's motion `x`, taken as certain. Viscous damping of this ratio takes as much energy in a
/// cycle at this amplitude as all terms of the law. The frequency is that of the springs at this amplitude,
/// lowered by the viscous term alone: drag and friction do not shift it to first order. Of the viscous law
/// nothing depends on the amplitude. Standard errors follow from the covariance of all parameters, start
/// included.
///
/// Quantities that do not exist are NaN. A hysteretic law has none: its loops depend on the motion before. An
/// overdamped driven law has damping_ratio, quality_factor and at_amplitude alone. A swing that negative
/// damping feeds has limit_cycle_amplitude, where it sustains itself, in place of the quality factor. A
/// pendulum has pendulum_length [m], that of the simple pendulum with the same frequency of small swings. A
/// body without a spring has mass = 1/force_gain [unit of force per unit of acceleration] alone. `observed`,
/// `derivative` and `force_unit` are as in law_parameters.
std::vector<Parameter> derived_quantities(const LawFit& fit, std::string_view observed, int derivative,
                                          const std::vector<double>& x = {},
                                          std::string_view force_unit = {});

/// Length [m] of the simple pendulum whose small swings are as fast, w [rad/s] > 0, under standard_gravity.
Parameter pendulum_length(const Estimate& w);

/// At what rate [1/s] the amplitude of a free motion falls, by all terms of the law, at its first sample and
/// `duration` [s] > 0 later: decay_rate_start and decay_rate_end. The amplitude in between is that of the
/// averaged law. The second is left out where the motion comes to rest before; both, of a hysteretic law, of
/// one without a spring, and of a driven motion.
std::vector<Parameter> decay_rate_ends(const LawFit& fit, double duration);

}  // namespace cromer::core
