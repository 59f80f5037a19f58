#include "cromer/study/task/fit_forced.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/identify/doubts.h"
#include "cromer/identify/driven_fit.h"
#include "cromer/record/dialects/column_kind.h"
#include "cromer/study/task/force_grid.h"
#include "cromer/study/task/forced_options.h"
#include "cromer/study/task/forced_parameters.h"

namespace cromer {
namespace {

Result<void> check_displacement(const Series& motion) {
  if (motion.quantity.find("velocity") == std::string::npos &&
      motion.quantity.find("acceleration") == std::string::npos)
    return {};
  return Error{
      fmt::format("column \"{}\" holds {}: a driven motion is fitted to a position or an angle; choose one "
                  "by --column",
                  motion.column, motion.quantity)};
}

bool is_outlier(const Series& series, std::size_t i) {
  return std::any_of(series.outliers.begin(), series.outliers.end(),
                     [&](const Outlier& outlier) { return outlier.t == series.t[i]; });
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
  result.parameters = forced_parameters(*result.forced, unit, force_unit, body);
  if (options.mass && unit != "m" && !unit.empty())
    result.warnings.push_back(
        fmt::format("--mass gives no stiffness here: column \"{}\" is no length", result.series.column));
  result.derived = forced_derived(*result.forced);
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
  if (options.segment || options.segments)
    result.warnings.emplace_back("--segment and --segments are not used: a driven motion has no decay");
  if (options.disc_diameter)
    result.warnings.emplace_back("--disc-diameter gives no Reynolds number of a driven motion");
}

}  // namespace

Result<FittedRecording> fit_forced(const Series& motion, const Series& force, std::string_view file,
                                   const FitOptions& options, const Watch& watch) {
  if (motion.column == force.column)
    return Error{
        fmt::format("--force-column: \"{}\" is the column that is fitted; say which holds the motion "
                    "with --column",
                    force.column)};
  if (const auto good = check_displacement(motion); !good) return good.error();
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
                      .resolution = used->resolution};
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
  if (of_law.size() < count) return result;
  // The series keeps what was fitted; the law goes on through what was held out.
  if (record.fitted < count) {
    HeldOut& held = result.held_out.emplace(HeldOut{t[record.fitted], t.back(), 0, 0});
    for (std::size_t i = record.fitted; i < count; ++i) {
      if (std::isnan(y[i])) continue;
      held.rms += (y[i] - of_law[i]) * (y[i] - of_law[i]);
      ++held.samples;
    }
    held.rms = held.samples > 0 ? std::sqrt(held.rms / static_cast<double>(held.samples)) : 0;
    FitOptions cut;
    cut.to = t[record.fitted - 1];
    result.series = *samples_in_use(result.series, cut);
  }
  std::vector<double> at_samples;
  for (std::size_t i = 0; i < result.series.t.size(); ++i) at_samples.push_back(of_law[(*places)[i] - first]);
  of_law = std::move(at_samples);
  return result;
}

Result<FittedRecording> fit_driven(const Series& motion, std::string_view file, const FitOptions& options,
                                   const Watch& watch) {
  if (const auto good = check_displacement(motion); !good) return good.error();
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
  ForcedChoice choice = choose_driven({t, y, series.resolution}, *terms, *drive, watch);
  describe(result, std::move(choice), "", false);
  say_unused(result);
  const ForcedFit& fit = *result.forced;
  if (!fit.drive_frequency) return result;
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
    std::vector<double> at_samples;
    for (std::size_t i = 0, k = 0; i < series.t.size(); ++i) {
      while (k + 1 < t.size() && t[k] < series.t[i]) ++k;
      at_samples.push_back(fit.motion[k]);
    }
    result.forced->motion = std::move(at_samples);
  }
  return result;
}

}  // namespace cromer
