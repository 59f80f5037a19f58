#include "cromer/tasks/fit/lab_quantities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/for_page.h"
#include "cromer/base/number.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/read/column_kind.h"
#include "cromer/run/course.h"
#include "cromer/tasks/fit/fitted_motion.h"
#include "cromer/tasks/fit/fitted_quantities.h"
#include "cromer/tasks/fit/used_samples.h"
#include "cromer/tasks/simulate/laid_over.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

// Monte Carlo, the textbook methods and a goal.
constexpr bool has_lab_options = !for_page;

// KC = 2 pi A/D. The error of the amplitude follows from those of displacement and velocity at the first
// sample.
void add_keulegan_carpenter(FittedRecording& result, const Quantity& diameter) {
  const LawFit& fit = result.fit;
  if (!is_linear_quantity(result.series.quantity)) return;
  const double w = fit.angular_frequency().value;
  const double A = first_amplitude(fit);
  if (!(A > 0)) return;
  const double by_x = fit.position().value / A, by_v = fit.velocity().value / (w * w * A);
  const double variance = by_x * by_x * fit.covariance_of("position", "position") +
                          by_v * by_v * fit.covariance_of("velocity", "velocity") +
                          2 * by_x * by_v * fit.covariance_of("position", "velocity");
  const double value = two_pi * A / diameter.value;
  const double relative =
      std::hypot(std::sqrt(std::max(0.0, variance)) / A, diameter.uncertainty / diameter.value);
  result.keulegan_carpenter = make_estimate(value, relative * value, fit.student);
}

void add_textbook(FittedRecording& result, const Record& record) {
  const double w0 = result.fit.angular_frequency().value, g = result.fit.decay_rate().value;
  const double w = std::sqrt(std::max(0.0, w0 * w0 - g * g));
  std::vector<double> y(record.y.begin(), record.y.end());
  for (double& each : y) each -= result.fit.equilibrium().value;
  result.textbook = TextbookDamping{peak_decrement(record.t, y, two_pi / w, result.fit.residual.rms),
                                    half_power_bandwidth(record.t, y, w)};
}

Result<void> add_plan(FittedRecording& result, const Record& record, const Body& body) {
  const Result<Goal> goal = parse_goal(result.options.goal);
  if (!goal) return goal.error();
  const std::string unit = unit_of(result.series);
  const auto quantities_of = [&](const LawFit& fit) {
    std::vector<Parameter> all = law_parameters(fit, unit, record.derivative);
    const auto add = [&](const std::vector<Parameter>& more) {
      all.insert(all.end(), more.begin(), more.end());
    };
    if (result.find("stiffness")) add(force_parameters(fit, body, motion_units(result).displacement));
    add(derived_quantities(fit, unit, record.derivative));
    add_doubts(all, result.law_doubts);  // a longer recording may still not tell the laws apart
    return all;
  };
  const Result<RecordingPlan> plan = plan_recording(*goal, result.fit, record, quantities_of);
  if (!plan) return plan.error();
  result.plan = *plan;
  return {};
}

// Twelve significant digits: a logger's times do not carry more.
double to_twelve_digits(double value) {
  return leading_number(fmt::format("{:.12g}", value)).value_or(LeadingNumber{value}).value;
}

// So many digits that what is cut off is a thousandth of the error, relative to the value.
std::string to_known_digits(double value, double relative_error) {
  if (!(relative_error > 0) || !std::isfinite(relative_error)) return shortest(value);
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(relative_error))) + 3, 1, 17);
  return shortest(leading_number(fmt::format("{:.{}g}", value, digits)).value_or(LeadingNumber{value}).value);
}

}  // namespace

Body body_of(const FitOptions& options) {
  Body body{{}, options.spring_mass, options.disc_diameter};
  if (!options.mass.empty()) body.mass = options.mass.front();
  if (options.temperature) body.temperature = *options.temperature;
  return body;
}

std::optional<OtherStiffness> other_stiffness(const FittedRecording& fitted) {
  constexpr double nearly_as_good = 1.1;  // of the rms residual
  const Estimate* k = fitted.find("stiffness");
  const double w = fitted.fit.angular_frequency().value;
  if (!k || fitted.driven || !(w > 0)) return std::nullopt;
  std::optional<OtherStiffness> farthest;
  double most = (k->high - k->low) / 2;
  for (const Candidate& each : fitted.candidates) {
    const double other = k->value * std::pow(each.angular_frequency / w, 2),
                 away = std::abs(other - k->value);
    if (!each.converged || each.rms > nearly_as_good * fitted.fit.residual.rms || !(away > most)) continue;
    most = away;
    farthest = {each.law, other, each.rms};
  }
  return farthest;
}

std::vector<Parameter> headline_of(const FittedRecording& fitted) {
  std::vector<Parameter> headline;
  for (const std::string_view name : {"frequency", "stiffness"})
    for (const auto* list : {&fitted.derived, &fitted.parameters})
      for (const Parameter& each : *list)
        if (each.name == name && std::isfinite(each.estimate.value)) headline.push_back(each);
  const std::vector<double>& t = fitted.series.t;
  if (fitted.fit.is_usable() && t.size() > 1)
    for (Parameter& end : decay_rate_ends(fitted.fit, t.back() - t.front()))
      headline.push_back(with_doubt(std::move(end), fitted.law_doubts));
  if (fitted.reynolds_max) headline.push_back({"reynolds_max", *fitted.reynolds_max, "1"});
  return headline;
}

Estimate angular_frequency_of(const FittedRecording& fitted) {
  const Estimate* found = fitted.find("angular_frequency");
  return found ? *found : fitted.fit.angular_frequency();
}

void add_force_parameters(FittedRecording& result, const Body& body) {
  if (is_linear_quantity(result.series.quantity)) {
    const auto forces = force_parameters(result.fit, body, motion_units(result).displacement);
    result.parameters.insert(result.parameters.end(), forces.begin(), forces.end());
  } else if (body.mass) {
    result.notices.push_back(Notice{"mass_gives_no_stiffness", {{"column", result.series.column}}});
  }
}

void add_stiffness_budget(FittedRecording& result, const Body& body, const Watch& watch) {
  const Estimate w = angular_frequency_of(result);
  const FitOptions& options = result.options;
  result.stiffness_budget = stiffness_budget(w, body);
  if constexpr (has_lab_options)
    if (options.monte_carlo) {
      const double degrees = result.fit.independent_samples - static_cast<double>(result.fit.fitted);
      result.monte_carlo = stiffness_monte_carlo(w, degrees, body, *options.monte_carlo, options.seed, watch);
    }
}

Result<void> add_lab_quantities(FittedRecording& result, const Record& record, const Body& body,
                                const Watch& watch) {
  const FitOptions& options = result.options;
  const bool has_forces = result.find("stiffness") != nullptr;
  result.headline = headline_of(result);
  if (body.disc_diameter) add_keulegan_carpenter(result, *body.disc_diameter);
  if (has_forces) add_stiffness_budget(result, body, watch);
  if constexpr (has_lab_options) {
    if (options.textbook) add_textbook(result, record);
    if (!options.goal.empty()) return add_plan(result, record, body);
  }
  return {};
}

std::vector<TypedOption> simulate_settings(const LawFit& fit, const Series& series, double mass) {
  if (is_recorded(fit.drive.kind) || !fit.law.shares(springs) || !runs_together(fit.law)) return {};
  const Motion& motion = fit.motion;
  const double exponent = motion.per_mass.hysteresis_exponent;
  const double shorter = two_pi / std::max(motion.angular_frequency(), motion.drive_frequency);
  for (const double value : {mass, motion.angular_frequency(), motion.position, motion.velocity, shorter})
    if (!std::isfinite(value)) return {};
  std::vector<TypedOption> settings;
  const auto add = [&](std::string_view option, double value) {
    settings.emplace_back(option, shortest(value));
  };
  // `value` is in proportion to this power of the parameter.
  const auto add_known = [&](std::string_view option, double value, std::string_view parameter, int power) {
    const Estimate* known = fit.find(parameter);
    const double error = known ? power * known->standard_error / std::abs(known->value) : 0;
    settings.emplace_back(option, to_known_digits(value, error));
  };
  add("mass", to_15_digits(mass));
  const Oscillator<double> oscillator = multiplied_by_mass(motion.per_mass, mass);
  if (!motion.law.has<Spring>()) add(Spring::coefficients[0].option, 0);
  for_each_term([&]<class T>() {
    if (!motion.law.has<T>()) return;
    for (std::size_t i = 0; i < coefficients_of<T>; ++i) {
      const double value = oscillator.*T::template members<double>[i];
      const CoefficientInfo& info = T::coefficients[i];
      if (value != 0)
        add_known(info.option, value, info.parameter, info.fitted == FittedAs::square_root ? 2 : 1);
    }
    if (HasInnerState<T> && exponent != 1) add("hysteresis-exponent", exponent);
  });
  if (fit.drive.kind == DriveKind::harmonic) {
    add_known("drive-amplitude", mass * fit["drive_amplitude"].value, "drive_amplitude", 1);
    add_known("drive-frequency", motion.drive_frequency, "drive_frequency", 1);
    add_known("drive-phase", fit["drive_phase"].value, "drive_phase", 1);
  }
  add_known("position", motion.position, "position", 1);
  add_known("velocity", motion.velocity, "velocity", 1);
  settings.emplace_back("method", "rk4");
  // A sample is a whole number of steps, and a period has at least the default number.
  constexpr double fewest = default_steps_per_period;
  const double rate = to_twelve_digits(series.rate > 0 ? series.rate : fewest / shorter);
  double step = 1 / (rate * std::max(1.0, std::ceil(fewest / (rate * shorter) - 1e-9)));
  const double until = to_twelve_digits(series.t.back() - series.t.front());
  // Otherwise the steps fill the record, so that the last is no shorter one.
  if (count_steps({0, until}, step).last > 0) step = until / std::ceil(until / step - 1e-6);
  add("step", step);
  add("until", until);
  return settings;
}

std::vector<TypedOption> over_settings(const FittedRecording& fitted) {
  const Series& series = fitted.series;
  const bool is_as_recorded = series.slips_at == HUGE_VAL;  // a slip of the times was taken out of the others
  if (!is_as_recorded || fitted.simulate.empty() || fitted.of_arrays || fitted.file.empty() ||
      fitted.file == "-" || !lies_under_runs(series))
    return {};
  std::vector<TypedOption> settings{{"over", fitted.file}, {"over-column", series.column}};
  if (series.run > 1) settings.emplace_back("over-run", fmt::format("{}", series.run));
  settings.emplace_back("over-from", shortest(to_twelve_digits(series.t.front())));
  const Estimate& equilibrium = fitted.fit.equilibrium();
  if (equilibrium.value != 0)
    settings.emplace_back("over-offset", to_known_digits(equilibrium.value, equilibrium.standard_error /
                                                                                std::abs(equilibrium.value)));
  const ReadOptions& read = fitted.options.read;
  if (read.rate > 0) settings.emplace_back("rate", shortest(read.rate));
  for (const auto& [option, value] :
       {std::pair{"time-column", &read.time_column}, std::pair{"delimiter", &read.delimiter},
        std::pair{"decimal", &read.decimal}})
    if (!value->empty()) settings.emplace_back(option, *value);
  if (read.skip_bad_rows) settings.emplace_back("skip-bad-rows", "");
  return settings;
}

}  // namespace cromer::core
