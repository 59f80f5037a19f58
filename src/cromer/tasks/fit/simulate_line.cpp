#include "cromer/tasks/fit/simulate_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/base/number.h"
#include "cromer/base/quantity.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

// Twelve significant digits: a logger's times do not carry more.
double to_twelve_digits(double value) {
  return leading_number(fmt::format("{:.12g}", value)).value_or(LeadingNumber{value}).value;
}

}  // namespace

std::string simulate_line(const LawFit& fit, const Series& series, double mass) {
  if (fit.drive.kind == DriveKind::recorded || !fit.law.shares(springs)) return {};
  const Motion& motion = fit.motion;
  const double exponent = motion.per_mass.hysteresis_exponent;
  const double shorter = 2 * std::numbers::pi / std::max(motion.angular_frequency(), motion.drive_frequency);
  for (const double value : {mass, motion.angular_frequency(), motion.position, motion.velocity, shorter})
    if (!std::isfinite(value)) return {};
  std::string line = fmt::format("cromer simulate --mass {}", shortest(mass));
  const auto add = [&](std::string_view option, double value) {
    line += fmt::format(" --{} {}", option, shortest(value));
  };
  const Oscillator<double> oscillator = multiplied_by_mass(motion.per_mass, mass);
  if (!motion.law.has<Spring>()) add(Spring::coefficients[0].option, 0);
  for_each_term([&]<class T>() {
    if (!motion.law.has<T>()) return;
    for (std::size_t i = 0; i < coefficients_of<T>; ++i) {
      const double value = oscillator.*T::template members<double>[i];
      if (value != 0) add(T::coefficients[i].option, value);
    }
    if (HasInnerState<T> && exponent != 1) add("hysteresis-exponent", exponent);
  });
  if (fit.drive.kind == DriveKind::harmonic) {
    add("drive-amplitude", mass * fit["drive_amplitude"].value);
    add("drive-frequency", motion.drive_frequency);
    add("drive-phase", fit["drive_phase"].value);
  }
  add("position", motion.position);
  add("velocity", motion.velocity);
  line += " --method rk4";
  // A sample is a whole number of steps, and a period has at least the default number.
  constexpr double fewest = default_steps_per_period;
  const double rate = to_twelve_digits(series.rate > 0 ? series.rate : fewest / shorter);
  add("step", 1 / (rate * std::max(1.0, std::ceil(fewest / (rate * shorter) - 1e-9))));
  add("until", to_twelve_digits(series.t.back() - series.t.front()));
  return line;
}

}  // namespace cromer::core
