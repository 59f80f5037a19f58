#include "cromer/study/task/fit_forced.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/identify/diagnose/doubts.h"
#include "cromer/identify/driven_fit.h"
#include "cromer/record/dialects/column_kind.h"
#include "cromer/study/task/derived_quantities.h"
#include "cromer/study/task/force_grid.h"
#include "cromer/study/task/forced_options.h"
#include "cromer/study/task/forced_parameters.h"
#include "cromer/study/task/used_samples.h"

namespace cromer {
namespace {

bool is_outlier(const Series& series, std::size_t i) {
  // They stand in the order of their times.
  const auto found = std::lower_bound(series.outliers.begin(), series.outliers.end(), series.t[i],
                                      [](const Outlier& outlier, double t) { return outlier.t < t; });
  return found != series.outliers.end() && found->t == series.t[i];
}

std::vector<double> taken(const std::vector<double>& from, const std::vector<std::size_t>& places) {
  std::vector<double> result;
  for (const std::size_t i : places) result.push_back(from[i]);
  return result;
}

bool has_values(const FreeDecay& fit) {
  return fit.status == FitStatus::converged || fit.status == FitStatus::iteration_limit;
}

// What both kinds of driven fits say.
void describe(FittedRecording& result, ForcedChoice&& choice, std::string_view force_unit,
              bool has_force_column) {
  result.fit = choice.chosen.law;
  result.forced = std::move(choice.chosen);
  result.warnings.insert(result.warnings.end(), result.fit.warnings.begin(), result.fit.warnings.end());
  for (const ForcedFit& candidate : choice.candidates)
    if (candidate.law.residual.rms > 0)
      result.candidates.push_back({candidate.law.law, candidate.law.residual.rms, candidate.law.bic,
                                   has_force_column ? std::string(name(candidate.between)) : ""});
  if (!has_values(result.fit) || !(result.fit.angular_frequency.value > 0)) return;
  const FitOptions& options = result.options;
  const Body body{options.mass, options.spring_mass, options.disc_diameter,
                  options.temperature.value_or(Quantity{293.15, 0})};
  const std::string_view unit = si_unit_of(result.series.quantity);
  const int derivative = std::max(0, derivative_order(result.series.quantity));
  if (derivative > 0)
    result.warnings.push_back(fitted_as_it_is(result.series.quantity, result.series.column));
  result.parameters = forced_parameters(*result.forced, unit, derivative, force_unit, body);
  if (options.mass && !result.find("stiffness"))
    result.warnings.push_back(
        fmt::format("--mass gives no stiffness here: column \"{}\" is no length", result.series.column));
  result.derived = derived_quantities(*result.forced, unit, derivative);
  if (result.find("stiffness")) {
    result.stiffness_budget = stiffness_budget(result.fit, body);
    if (options.monte_carlo)
      result.monte_carlo = stiffness_monte_carlo(result.fit, body, *options.monte_carlo, options.seed);
  }
  if (result.fit.decay_rate.value >= result.fit.angular_frequency.value)
    result.warnings.emplace_back("the law is overdamped: it has no frequency and no period of its own");
  if (result.fit.explained < 0.9 && result.fit.residual.autocorrelation > 0.5)
    result.warnings.push_back(
        fmt::format("the law accounts for {:.0f} % of the motion's variance, and what is left is no noise: "
                    "something else "
                    "drives it as well, or drives it instead",
                    100 * result.fit.explained));
  if (const std::string wide = widening(result.fit, result.series.t.size()); !wide.empty())
    result.warnings.push_back(wide);
}

// The command that simulates a harmonically driven law; it has no quadratic term.
std::string simulate_line(const ForcedFit& fit, const Series& series, double mass) {
  const FreeDecay& law = fit.law;
  if (fit.quadratic || !fit.drive_amplitude) return {};
  const double w0 = law.angular_frequency.value, w = fit.drive_frequency->value;
  std::string line = fmt::format("cromer simulate --mass {} --stiffness {} --damping {}", shortest(mass),
                                 shortest(mass * w0 * w0), shortest(2 * mass * law.decay_rate.value));
  const auto add = [&](const char* option, double value) {
    line += fmt::format(" --{} {}", option, shortest(value));
  };
  if (law.drag) add("drag", mass * law.drag->value);
  add("drive-amplitude", mass * fit.drive_amplitude->value);
  add("drive-frequency", w);
  add("drive-phase", fit.drive_phase->value);
  add("position", law.position.value);
  add("velocity", law.velocity.value);
  line += " --method rk4";
  const double shorter = 2 * std::numbers::pi / std::max(w0, w);
  const double spacing = series.rate > 0 ? 1 / series.rate : shorter / 200;
  add("step", spacing / std::max(1.0, std::ceil(200 * spacing / shorter - 1e-9)));
  add("until", series.t.back() - series.t.front());
  return line;
}

void say_unused(FittedRecording& result) {
  const FitOptions& options = result.options;
  for (const std::string_view unused : unused_if_driven(options))
    result.warnings.push_back(fmt::format("{} is not used: the motion is driven", unused));
  if (options.disc_diameter)
    result.warnings.push_back(
        fmt::format("--disc-diameter gives no Reynolds number of a driven motion{}",
                    result.find("drag_coefficient")
                        ? ""
                        : "; and no drag coefficient: that needs --mass and drag in the law"));
}

}  // namespace

Result<FittedRecording> fit_forced(const Series& motion, const Series& force, std::string_view file,
                                   const FitOptions& options, const Watch& watch) {
  if (motion.column == force.column)
    return Error{
        fmt::format("--force-column: \"{}\" is the column that is fitted; say which holds the motion "
                    "with --column",
                    force.column)};
  Result<Series> used = samples_in_use(motion, options);
  if (!used) return used.error();
  const Series around = force_around(force, used->t.front(), used->t.back());
  const Result<ForceGrid> grid = grid_of(around);
  if (!grid) return grid.error();
  const Result<std::vector<std::size_t>> places = places_on(*grid, *used, force);
  if (!places) return places.error();

  const std::size_t first = places->front(), count = places->back() - first + 1;
  std::vector<double> t(count), y(count, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < count; ++i) t[i] = grid->time(first + i);
  for (std::size_t i = 0; i < used->t.size(); ++i)
    if (!is_outlier(*used, i)) y[(*places)[i] - first] = used->y[i];
  ForcedRecord record{.force = around.y,
                      .spacing = grid->spacing,
                      .first = first,
                      .t = t,
                      .y = y,
                      .fitted = count,
                      .resolution = used->resolution,
                      .derivative = std::max(0, derivative_order(used->quantity))};
  if (options.hold_out)
    record.fitted =
        static_cast<std::size_t>(std::lround((1 - *options.hold_out) * static_cast<double>(count)));

  const Result<std::optional<ForcedTerms>> terms = terms_of(options);
  if (!terms) return terms.error();
  FittedRecording result;
  result.file = file;
  result.samples = motion.t.size();
  result.options = options;
  result.warnings = used->warnings;
  for (const std::string& warning : force.warnings) result.warnings.push_back("force: " + warning);
  result.series = *std::move(used);
  describe(result, choose_forced(record, *terms, reading_of(options), watch), si_unit_of(force.quantity),
           true);
  result.between_samples = name(result.forced->between);
  say_unused(result);

  std::vector<double>& of_law = result.forced->motion;
  Trajectory& states = result.forced->states;
  if (of_law.size() < count) return result;
  // The series keeps what was fitted; the law goes on through what was held out.
  if (record.fitted < count) {
    HeldOut& held =
        result.held_out.emplace(HeldOut{.from = t[record.fitted], .to = t.back(), .samples = 0, .rms = 0});
    for (std::size_t i = record.fitted; i < count; ++i) {
      if (std::isnan(y[i])) continue;
      held.rms += (y[i] - of_law[i]) * (y[i] - of_law[i]);
      held.t.push_back(t[i]);
      held.measured.push_back(y[i]);
      held.law.push_back(of_law[i]);
      ++held.samples;
    }
    held.rms = held.samples > 0 ? std::sqrt(held.rms / static_cast<double>(held.samples)) : 0;
    FitOptions cut;
    cut.to = t[record.fitted - 1];
    result.series = *samples_in_use(result.series, cut);
  }
  std::vector<std::size_t> of_series;
  for (std::size_t i = 0; i < result.series.t.size(); ++i) of_series.push_back((*places)[i] - first);
  for (std::vector<double>* list : {&of_law, &states.t, &states.x, &states.v})
    *list = taken(*list, of_series);
  return result;
}

Result<FittedRecording> fit_driven(const Series& motion, std::string_view file, const FitOptions& options,
                                   const Watch& watch) {
  Result<Series> used = samples_in_use(motion, options);
  if (!used) return used.error();
  const Result<std::optional<ForcedTerms>> terms = terms_of(options);
  if (!terms) return terms.error();
  const Result<std::optional<double>> drive = drive_of(options);
  if (!drive) return drive.error();

  FittedRecording result;
  result.file = file;
  result.samples = motion.t.size();
  result.options = options;
  result.warnings = used->warnings;
  result.series = *std::move(used);
  const Series& series = result.series;
  std::vector<double> t, y;
  for (std::size_t i = 0; i < series.t.size(); ++i) {
    if (is_outlier(series, i)) continue;
    t.push_back(series.t[i]);
    y.push_back(series.y[i]);
  }
  ForcedChoice choice = choose_driven(
      {t, y, series.resolution, std::max(0, derivative_order(series.quantity))}, *terms, *drive, watch);
  describe(result, std::move(choice), "", false);
  say_unused(result);
  const ForcedFit& fit = *result.forced;
  if (!fit.drive_frequency) return result;
  if (fit.quadratic)
    result.warnings.emplace_back(
        "no command simulates this law: cromer simulate has no quadratic stiffness; --law viscous or "
        "viscous+drag gives one that it has");
  result.simulate = simulate_line(
      fit, series, options.mass ? Body{options.mass, options.spring_mass}.effective_mass().value : 1);
  if (result.fit.status == FitStatus::converged) {
    constexpr double two_pi = 2 * std::numbers::pi;
    const double T = t.back() - t.front();
    if (*drive && std::abs(fit.drive_frequency->value - **drive) > 4 * two_pi / T)
      result.warnings.push_back(
          fmt::format("the steady oscillation has {:.6g} Hz, not the {:.6g} Hz of --drive-frequency",
                      fit.drive_frequency->value / two_pi, **drive / two_pi));
  }
  // Outliers have a place in the series: the law's motion there, by the nearest neighbours.
  if (t.size() != series.t.size() && fit.motion.size() == t.size()) {
    std::vector<std::size_t> of_series;
    for (std::size_t i = 0, k = 0; i < series.t.size(); ++i) {
      while (k + 1 < t.size() && t[k] < series.t[i]) ++k;
      of_series.push_back(k);
    }
    ForcedFit& forced = *result.forced;
    for (std::vector<double>* list : {&forced.motion, &forced.states.t, &forced.states.x, &forced.states.v})
      *list = taken(*list, of_series);
  }
  return result;
}

}  // namespace cromer
