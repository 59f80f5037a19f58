#include "cromer/study/task/fitted_quantities.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/analysis/air.h"

namespace cromer {
namespace {

constexpr double pi = std::numbers::pi;

// "1/m" and "1/(m² s²)" from "m".
std::string reciprocal(std::string_view unit) { return unit.empty() ? "" : "1/" + std::string(unit); }
std::string cubic_unit(std::string_view unit) {
  return unit.empty() ? "1/s²" : "1/(" + std::string(unit) + "² s²)";
}
std::string rate_unit(std::string_view unit) { return unit.empty() ? "1/s" : std::string(unit) + "/s"; }
std::string acceleration_unit(std::string_view unit) {
  return unit.empty() ? "1/s²" : std::string(unit) + "/s²";
}

// c times an estimate, where c has a relative uncertainty of its own that is independent of the estimate.
Estimate scaled(const Estimate& estimate, double c, double relative_uncertainty, double t) {
  const double value = c * estimate.value;
  Estimate result =
      make_estimate(value, std::hypot(c * estimate.standard_error, value * relative_uncertainty), t);
  // An interval that is not centred, or cut at a bound, stays so.
  const double widening =
      estimate.standard_error > 0 ? result.standard_error / (c * estimate.standard_error) : 1;
  result.low = value + c * widening * (estimate.low - estimate.value);
  result.high = value + c * widening * (estimate.high - estimate.value);
  if (estimate.low >= 0) result.low = std::max(result.low, 0.0);
  return result;
}

}  // namespace

Quantity Body::effective_mass() const {
  const Quantity spring = spring_mass.value_or(Quantity{});
  return {mass->value + spring.value / 3, std::hypot(mass->uncertainty, spring.uncertainty / 3)};
}

std::string displacement_unit(std::string_view unit, int derivative) {
  return std::string(derivative > 0 ? unit.substr(0, unit.find('/')) : unit);
}

std::vector<NamedEstimate> law_parameters(const FreeDecay& fit, std::string_view observed, int derivative) {
  const std::string unit = displacement_unit(observed, derivative);
  std::vector<NamedEstimate> result;
  result.push_back({"angular_frequency", fit.angular_frequency, "rad/s"});
  if (fit.law.viscous) result.push_back({"decay_rate", fit.decay_rate, "1/s"});
  if (fit.drag) result.push_back({"drag", *fit.drag, reciprocal(unit)});
  if (fit.friction) result.push_back({"friction", *fit.friction, acceleration_unit(unit)});
  if (fit.cubic) result.push_back({"cubic", *fit.cubic, cubic_unit(unit)});
  result.push_back({"equilibrium", fit.equilibrium, std::string(observed)});
  result.push_back({"position", fit.position, unit});
  result.push_back({"velocity", fit.velocity, rate_unit(unit)});
  return result;
}

std::vector<NamedEstimate> force_parameters(const FreeDecay& fit, const Body& body) {
  std::vector<NamedEstimate> result;
  if (!body.mass) return result;
  const Quantity m = body.effective_mass();
  const double u_m = m.uncertainty / m.value;
  const double w0 = fit.angular_frequency.value;
  const Estimate stiffness_per_mass =
      make_estimate(w0 * w0, 2 * w0 * fit.angular_frequency.standard_error, fit.student);
  result.push_back({"stiffness", scaled(stiffness_per_mass, m.value, u_m, fit.student), "N/m"});
  if (fit.law.viscous)
    result.push_back({"damping", scaled(fit.decay_rate, 2 * m.value, u_m, fit.student), "kg/s"});
  if (fit.drag) result.push_back({"drag_constant", scaled(*fit.drag, m.value, u_m, fit.student), "kg/m"});
  if (fit.friction)
    result.push_back({"friction_force", scaled(*fit.friction, m.value, u_m, fit.student), "N"});
  if (fit.cubic) result.push_back({"cubic_stiffness", scaled(*fit.cubic, m.value, u_m, fit.student), "N/m³"});
  if (fit.drag && body.disc_diameter) {
    // d = rho S C_d / 2 with S = pi D²/4; rho goes as 1/T.
    const Quantity D = *body.disc_diameter;
    const double area = pi / 4 * D.value * D.value;
    const double factor = 2 * m.value / (air_density(body.temperature.value) * area);
    const double relative =
        std::hypot(u_m, 2 * D.uncertainty / D.value, body.temperature.uncertainty / body.temperature.value);
    result.push_back({"drag_coefficient", scaled(*fit.drag, factor, relative, fit.student), "1"});
  }
  return result;
}

}  // namespace cromer
