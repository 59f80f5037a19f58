#include "cromer/study/task/fit_forced.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/base/nearest.h"
#include "cromer/identify/driven_fit.h"
#include "cromer/record/dialects/column_kind.h"
#include "cromer/study/task/forced_parameters.h"

namespace cromer {
namespace {

constexpr double most_uneven = 0.02;  // of a sample spacing
constexpr std::array<std::string_view, 4> readings{"auto", "linear", "hold", "band-limited"};

std::optional<ForceBetween> reading_of(const FitOptions& options) {
  for (const ForceBetween reading : {ForceBetween::linear, ForceBetween::hold, ForceBetween::band_limited})
    if (options.between_samples == name(reading)) return reading;
  return std::nullopt;
}

Result<std::optional<ForcedTerms>> terms_of(const FitOptions& options) {
  if (options.law.empty() || options.law == "auto") return std::optional<ForcedTerms>{};
  const Result<Law> law = parse_law(options.law);
  if (!law) return law.error();
  const Law known{true, law->drag, false, law->cubic};
  if (*law != known)
    return Error{fmt::format(
        "--law {}: a driven motion is fitted with viscous damping, and drag and cubic if they are asked for",
        options.law)};
  return std::optional<ForcedTerms>{{.drag = law->drag, .curved = law->cubic}};
}

Result<std::optional<double>> drive_of(const FitOptions& options) {
  if (options.drive_frequency == "auto") return std::optional<double>{};
  const Result<Quantity> frequency = parse_quantity(options.drive_frequency, "rad/s");
  if (!frequency)
    return Error{"--drive-frequency: " + frequency.error().message + "; or auto, to find it in the record"};
  if (!(frequency->value > 0) || !std::isfinite(frequency->value))
    return Error{fmt::format("--drive-frequency {}: it must be positive", options.drive_frequency)};
  return std::optional<double>{frequency->value};
}

Result<void> check_displacement(const Series& motion) {
  if (motion.quantity.find("velocity") == std::string::npos &&
      motion.quantity.find("acceleration") == std::string::npos)
    return {};
  return Error{
      fmt::format("column \"{}\" holds {}: a driven motion is fitted to a position or an angle; choose one "
                  "by --column",
                  motion.column, motion.quantity)};
}

// An even grid of times, by the force's own samples.
struct Grid {
  double begin = 0, spacing = 1;
  std::size_t size = 0;

  double time(std::size_t i) const { return begin + static_cast<double>(i) * spacing; }
};

Result<Grid> grid_of(const Series& force) {
  const auto column = [&] { return fmt::format("force column \"{}\"", force.column); };
  if (force.t.size() < 2) return Error{column() + " has fewer than two values"};
  const auto [low, high] = std::minmax_element(force.y.begin(), force.y.end());
  if (*low == *high)
    return Error{
        fmt::format("{} is {} throughout: a force that never changes drives nothing; leave out "
                    "--force-column to fit the free motion",
                    column(), shortest(*low))};
  if (!force.gaps.empty())
    return Error{
        fmt::format("{} has {}, the first {:.6g} s long at {:.6g} s: what the force did there is not known; "
                    "choose one side of it with --from and --to, or fill it in",
                    column(), force.gaps.size() == 1 ? "a gap" : fmt::format("{} gaps", force.gaps.size()),
                    force.gaps.front().length, force.gaps.front().t)};
  Grid grid{force.t.front(), (force.t.back() - force.t.front()) / static_cast<double>(force.t.size() - 1),
            force.t.size()};
  for (std::size_t i = 0; i < grid.size; ++i)
    if (std::abs(force.t[i] - grid.time(i)) > most_uneven * grid.spacing)
      return Error{fmt::format(
          "line {}: the times are not evenly spaced ({:.6g} s where {:.6g} s is expected, one sample each "
          "{:.6g} s); a recorded force needs even samples: resample the recording first",
          i < force.lines.size() ? force.lines[i] : 0, force.t[i], grid.time(i), grid.spacing)};
  return grid;
}

// The part of a force column between --from and --to with the margin that its reading between the samples
// wants; without gaps outside it.
Series force_around(const Series& force, double from, double to) {
  constexpr double margin = 64;  // [samples]
  const double reach = force.rate > 0 ? margin / force.rate : 0;
  auto first = std::lower_bound(force.t.begin(), force.t.end(), from - reach) - force.t.begin();
  auto last = std::upper_bound(force.t.begin(), force.t.end(), to + reach) - force.t.begin();
  for (const Gap& gap : force.gaps) {
    const auto after = std::upper_bound(force.t.begin(), force.t.end(), gap.t) - force.t.begin();
    if (gap.t < from) first = std::max(first, after);
    if (gap.t >= to) last = std::min(last, after);
  }
  Series part = force;
  part.t.assign(force.t.begin() + first, force.t.begin() + last);
  part.y.assign(force.y.begin() + first, force.y.begin() + last);
  part.lines.assign(force.lines.begin() + first, force.lines.begin() + last);
  std::erase_if(part.gaps, [&](const Gap& gap) { return gap.t < from || gap.t >= to; });
  return part;
}

// Where each sample of the motion stands on the grid.
Result<std::vector<std::size_t>> places_on(const Grid& grid, const Series& motion, const Series& force) {
  std::vector<std::size_t> places;
  places.reserve(motion.t.size());
  for (std::size_t i = 0; i < motion.t.size(); ++i) {
    const double at = (motion.t[i] - grid.begin) / grid.spacing, place = std::round(at);
    if (place < 0 || place >= static_cast<double>(grid.size))
      return Error{fmt::format(
          "force column \"{}\" goes from {:.6g} to {:.6g} s, and column \"{}\" has a value at {:.6g} s; "
          "choose the part that both have with --from and --to",
          force.column, grid.begin, grid.time(grid.size - 1), motion.column, motion.t[i])};
    if (std::abs(at - place) > most_uneven)
      return Error{
          fmt::format("force column \"{}\" has other times than column \"{}\": {:.9g} s lies between "
                      "two of its samples; resample one of them first",
                      force.column, motion.column, motion.t[i])};
    places.push_back(static_cast<std::size_t>(place));
  }
  return places;
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
  if (!result.fit.residual.white && result.fit.independent_samples > 0)
    result.warnings.push_back(fmt::format(
        "the residuals are correlated ({:.3f} from sample to sample): the uncertainties are widened to those "
        "of {:.0f} independent samples",
        result.fit.residual.autocorrelation, result.fit.independent_samples));
}

void say_unused(FittedRecording& result) {
  const FitOptions& options = result.options;
  if (options.segment || options.segments)
    result.warnings.emplace_back("--segment and --segments are not used: a driven motion has no decay");
  if (options.disc_diameter)
    result.warnings.emplace_back("--disc-diameter gives no Reynolds number of a driven motion");
}

}  // namespace

bool is_driven(const FitOptions& options) {
  return !options.force_column.empty() || !options.drive_frequency.empty();
}

Result<void> check_forced_options(const FitOptions& options) {
  if (!options.force_column.empty() && !options.drive_frequency.empty())
    return Error{
        "--force-column and --drive-frequency exclude each other: the drive is recorded, or it is "
        "harmonic"};
  if (!options.between_samples.empty()) {
    if (options.force_column.empty())
      return Error{
          "--between-samples needs --force-column: only a recorded force has anything between its "
          "samples"};
    if (std::find(readings.begin(), readings.end(), options.between_samples) == readings.end())
      return Error{fmt::format("--between-samples: \"{}\" is none of linear, hold, band-limited and auto",
                               options.between_samples)};
  }
  if (options.hold_out) {
    if (options.force_column.empty())
      return Error{"--hold-out needs --force-column: only a motion whose force is known can be foretold"};
    if (!(*options.hold_out > 0 && *options.hold_out <= 0.9))
      return Error{fmt::format("--hold-out {}: it must lie above 0 and at most at 90 %", *options.hold_out)};
  }
  if (!is_driven(options)) return {};
  if (const auto terms = terms_of(options); !terms) return terms.error();
  if (!options.drive_frequency.empty())
    if (const auto drive = drive_of(options); !drive) return drive.error();
  return {};
}

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
  const Result<Grid> grid = grid_of(around);
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
  if (result.fit.status == FitStatus::converged) {
    constexpr double two_pi = 2 * std::numbers::pi;
    if (fit.drive_amplitude->low <= 0)
      result.warnings.emplace_back("the drive's amplitude is not told from none: the motion looks free");
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

std::optional<FittedRecording> recognise_drive(const FittedRecording& free, const Series& motion,
                                               const FitOptions& options, const Watch& watch) {
  const bool automatic =
      options.recognise_drive && (options.law.empty() || options.law == "auto") && !is_driven(options);
  constexpr double structured = 0.3, unstructured = 0.5;  // autocorrelation of residuals
  if (!automatic || !has_values(free.fit) || free.fit.residual.autocorrelation < structured ||
      watch.interrupted() || !check_displacement(motion))
    return std::nullopt;
  FitOptions driven = options;
  driven.drive_frequency = "auto";
  Result<FittedRecording> result = fit_driven(motion, free.file, driven, watch);
  if (!result || result->fit.status != FitStatus::converged) return std::nullopt;
  const ForcedFit& fit = *result->forced;
  const Residual &left = fit.law.residual, &left_free = free.fit.residual;
  if (!(left.rms < 0.9 * left_free.rms) || std::abs(left.autocorrelation) > unstructured ||
      !(fit.drive_amplitude->low > 0))
    return std::nullopt;
  const double w0 = fit.law.angular_frequency.value, w = fit.drive_frequency->value;
  const double steady =
      fit.drive_amplitude->value / std::hypot(w0 * w0 - w * w, 2 * fit.law.decay_rate.value * w);
  double square = 0;
  for (double y : result->series.y)
    square += (y - fit.law.equilibrium.value) * (y - fit.law.equilibrium.value);
  const double rms = std::sqrt(square / static_cast<double>(result->series.y.size()));
  if (steady < 0.3 * rms * std::numbers::sqrt2) return std::nullopt;
  result->options = options;
  result->warnings.push_back(fmt::format(
      "the motion is driven, at {:.6g} Hz: a free motion would leave {:.3g}, this leaves {:.3g}; say "
      "--drive-frequency if it is known, or choose a free part with --from and --to",
      w / (2 * std::numbers::pi), left_free.rms, left.rms));
  return *std::move(result);
}

}  // namespace cromer
