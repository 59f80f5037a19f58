#include "cromer/identify/motion/parameter_unit.h"

#include <fmt/format.h>

#include "cromer/model/terms/term.h"

namespace cromer::core {
namespace {

// Unit of a coefficient per unit mass, `length` being the unit of displacements, n the hysteresis exponent of
// the law: beta |x'| |z|^(n-1) z is the rate of an acceleration z.
std::string unit_per_mass(const CoefficientInfo& info, std::string_view length, double n) {
  if (info.fitted == FittedAs::square_root) return "rad/s";
  if (info.fitted == FittedAs::not_a_force && n != 1)
    return fmt::format("s^{:.4g}/{}^{:.4g}", 2 * (n - 1), length.empty() ? "1" : length, n);
  if (info.fitted == FittedAs::not_a_force) return unit_of_powers({{length, info.length}, {"s", info.time}});
  return unit_of_powers({{length, 1 + info.length}, {"s", info.time - 2}});
}

// Unit of a parameter that is no coefficient of the law.
std::string unit_beside_the_law(std::string_view name, std::string_view observed, std::string_view length,
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

}  // namespace

std::string displacement_unit(std::string_view unit, int derivative) {
  return std::string(derivative > 0 ? unit.substr(0, unit.find('/')) : unit);
}

std::string unit_of_parameter(std::string_view name, const Motion& motion, std::string_view observed,
                              int derivative, std::string_view force_unit) {
  const std::string length = displacement_unit(observed, derivative);
  std::string unit = unit_beside_the_law(name, observed, length, force_unit);
  for_each_term([&]<class T>() {
    for (const CoefficientInfo& info : T::coefficients)
      if (motion.law.has<T>() && info.parameter == name)
        unit = unit_per_mass(info, length, motion.per_mass.hysteresis_exponent);
  });
  return unit;
}

}  // namespace cromer::core
