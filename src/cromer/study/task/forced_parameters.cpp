#include "cromer/study/task/forced_parameters.h"

#include <cmath>
#include <string>

namespace cromer {
namespace {

std::string times(std::string_view unit, std::string_view denominator) {
  return std::string(unit.empty() ? "1" : unit) + "/" + std::string(denominator);
}

// Of acceleration per unit of force.
std::string gain_unit(std::string_view unit, std::string_view force_unit) {
  if (force_unit.empty()) return times(unit, "s²");
  return times(unit, "(s² " + std::string(force_unit) + ")");
}

}  // namespace

std::vector<NamedEstimate> forced_parameters(const ForcedFit& fit, std::string_view observed, int derivative,
                                             std::string_view force_unit, const Body& body) {
  const FreeDecay& law = fit.law;
  const std::string length = displacement_unit(observed, derivative), &unit = length;
  std::vector<NamedEstimate> list{{"angular_frequency", law.angular_frequency, "rad/s"},
                                  {"decay_rate", law.decay_rate, "1/s"}};
  const auto add = [&](const char* name, const std::optional<Estimate>& estimate, std::string of_unit) {
    if (estimate) list.push_back({name, *estimate, std::move(of_unit)});
  };
  add("drag", law.drag, unit.empty() ? "" : "1/" + length);
  add("cubic", law.cubic, unit.empty() ? "1/s²" : "1/(" + length + "² s²)");
  add("quadratic", fit.quadratic, unit.empty() ? "1/s²" : "1/(" + length + " s²)");
  add("force_gain", fit.force_gain, gain_unit(unit, force_unit));
  add("force_offset", fit.force_offset, std::string(force_unit));
  add("drive_frequency", fit.drive_frequency, "rad/s");
  add("drive_amplitude", fit.drive_amplitude, times(unit, "s²"));
  add("drive_phase", fit.drive_phase, "rad");
  add("equilibrium", law.equilibrium, std::string(observed));
  add("position", law.position, length);
  add("velocity", law.velocity, times(unit, "s"));
  if (!body.mass || (unit != "m" && !unit.empty())) return list;
  const auto forces = force_parameters(law, body);
  list.insert(list.end(), forces.begin(), forces.end());
  const Quantity m = body.effective_mass();
  const auto scaled = [&](const Estimate& estimate) {
    const double error = std::hypot(m.value * estimate.standard_error, estimate.value * m.uncertainty);
    return make_estimate(m.value * estimate.value, error, law.student);
  };
  if (fit.quadratic) add("quadratic_stiffness", scaled(*fit.quadratic), "N/m²");
  if (fit.drive_amplitude) add("drive_force", scaled(*fit.drive_amplitude), "N");
  return list;
}

}  // namespace cromer
