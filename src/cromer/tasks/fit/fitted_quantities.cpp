#include "cromer/tasks/fit/fitted_quantities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/analysis/air.h"
#include "cromer/base/pi.h"
#include "cromer/model/terms/term.h"

namespace cromer::core {
namespace {

// Of a coefficient per unit mass, where displacements have the unit `length`, in a law with this hysteresis
// exponent n: beta |x'| |z|^(n-1) z is the rate of an acceleration z.
std::string unit_per_mass(const CoefficientInfo& info, std::string_view length, double n) {
  if (info.fitted == FittedAs::square_root) return "rad/s";
  if (info.fitted == FittedAs::not_a_force && n != 1)
    return fmt::format("s^{:.4g}/{}^{:.4g}", 2 * (n - 1), length.empty() ? "1" : length, n);
  if (info.fitted == FittedAs::not_a_force) return unit_of_powers({{length, info.length}, {"s", info.time}});
  return unit_of_powers({{length, 1 + info.length}, {"s", info.time - 2}});
}

// Of the parameters beside the law's.
std::string unit_of_parameter(std::string_view name, std::string_view observed, std::string_view length,
                              std::string_view force_unit) {
  if (name == "drive_frequency") return "rad/s";
  if (name == "drive_phase") return "rad";
  if (name == "drive_amplitude") return unit_of_powers({{length, 1}, {"s", -2}});
  if (name == "force_gain") return unit_of_powers({{length, 1}, {"s", -2}, {force_unit, -1}});
  if (name == "force_offset") return std::string(force_unit);
  if (name == "equilibrium") return std::string(observed);
  if (name == "velocity") return unit_of_powers({{length, 1}, {"s", -1}});
  return std::string(length);
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

// Its interval is that of the root, squared.
Estimate squared(const Estimate& root) {
  const double low = std::max(0.0, root.low);
  return {root.value * root.value, 2 * root.value * root.standard_error, low * low, root.high * root.high};
}

}  // namespace

Quantity Body::effective_mass() const {
  const Quantity spring = spring_mass.value_or(Quantity{});
  return {mass->value + spring.value / 3, std::hypot(mass->uncertainty, spring.uncertainty / 3)};
}

std::string displacement_unit(std::string_view unit, int derivative) {
  return std::string(derivative > 0 ? unit.substr(0, unit.find('/')) : unit);
}

std::vector<Parameter> law_parameters(const LawFit& fit, std::string_view observed, int derivative,
                                      std::string_view force_unit) {
  const std::string length = displacement_unit(observed, derivative);
  std::vector<Parameter> result;
  for (std::size_t i = 0; i < fit.names.size(); ++i) {
    std::string unit = unit_of_parameter(fit.names[i], observed, length, force_unit);
    for_each_term([&]<class T>() {
      for (const CoefficientInfo& info : T::coefficients)
        if (fit.law.has<T>() && info.parameter == fit.names[i])
          unit = unit_per_mass(info, length, fit.motion.per_mass.hysteresis_exponent);
    });
    result.push_back({fit.names[i], fit.estimates[i], std::move(unit)});
  }
  return result;
}

std::vector<Parameter> force_parameters(const LawFit& fit, const Body& body) {
  std::vector<Parameter> result;
  if (!body.mass) return result;
  const Quantity m = body.effective_mass();
  const double u_m = m.uncertainty / m.value;
  for_each_term([&]<class T>() {
    for (const CoefficientInfo& info : T::coefficients) {
      const Estimate* fitted = fit.find(info.parameter);
      if (!fit.law.has<T>() || info.in_si.empty() || !fitted) continue;
      const Estimate per_mass = info.fitted == FittedAs::square_root ? squared(*fitted) : *fitted;
      const double times = from_fitted(info.fitted, 1.0) * m.value;
      result.push_back({std::string(info.in_si), scaled(per_mass, times, u_m, fit.student),
                        unit_of(info, Powers::superscript)});
    }
  });
  if (const Estimate* amplitude = fit.find("drive_amplitude"))
    result.push_back({"drive_force", scaled(*amplitude, m.value, u_m, fit.student), "N"});
  const Estimate* drag = fit.find(Drag::coefficients[0].parameter);
  if (drag && body.disc_diameter) {
    // d = rho S C_d / 2 with S = pi D²/4; rho goes as 1/T.
    const Quantity D = *body.disc_diameter;
    const double area = pi / 4 * D.value * D.value;
    const double factor = 2 * m.value / (air_density(body.temperature.value) * area);
    const double relative =
        std::hypot(u_m, 2 * D.uncertainty / D.value, body.temperature.uncertainty / body.temperature.value);
    result.push_back({"drag_coefficient", scaled(*drag, factor, relative, fit.student), "1"});
  }
  return result;
}

}  // namespace cromer::core
