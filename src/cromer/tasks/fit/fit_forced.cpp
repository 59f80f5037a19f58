#include "cromer/tasks/fit/fit_forced.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "cromer/base/extent.h"
#include "cromer/identify/choose/choose_law.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/recording.h"
#include "cromer/result.h"
#include "cromer/tasks/fit/fit_driven.h"
#include "cromer/tasks/fit/fit_options.h"
#include "cromer/tasks/fit/used_samples.h"
#include "cromer/tasks/simulate/drive_record.h"

namespace cromer::core {
namespace {

/// The even times at which the force was sampled.
struct ForceGrid {
  double begin = 0;    // [s]
  double spacing = 1;  // [s] > 0
  std::size_t size = 0;

  double time(std::size_t i) const { return begin + static_cast<double>(i) * spacing; }
};

/// An Error if the force has gaps, uneven times, or one value throughout.
Result<ForceGrid> grid_of(const Series& force) {
  if (!force.gaps.empty())
    return Error{Notice{force.gaps.size() == 1 ? "force_has_a_gap" : "force_has_gaps",
                        {{"column", force.column},
                         {"gaps", force.gaps.size()},
                         {"length", force.gaps.front().length},
                         {"t", force.gaps.front().t}}}};
  if (force.t.size() < 2) return Error{"force_is_too_short", {{"column", force.column}}};
  const auto [low, high] = extent_of(force.y);
  if (low == high) return Error{"force_never_changes", {{"column", force.column}, {"value", shortest(low)}}};
  ForceGrid grid{force.t.front(),
                 (force.t.back() - force.t.front()) / static_cast<double>(force.t.size() - 1),
                 force.t.size()};
  for (std::size_t i = 0; i < grid.size; ++i)
    if (std::abs(force.t[i] - grid.time(i)) > most_uneven * grid.spacing)
      return Error{"force_is_uneven",
                   {{"line", i < force.lines.size() ? force.lines[i] : 0},
                    {"t", force.t[i]},
                    {"expected", grid.time(i)},
                    {"spacing", grid.spacing}}};
  return grid;
}

/// The part of a force column from one time to another [s], with the margin that reading between samples
/// needs, as far as it has no gap.
Series force_around(const Series& force, double from, double to) {
  constexpr double margin = 64;  // [samples]
  const double reach = force.rate > 0 ? margin / force.rate : 0;
  auto first = std::lower_bound(force.t.begin(), force.t.end(), from - reach) - force.t.begin();
  auto last = std::upper_bound(force.t.begin(), force.t.end(), to + reach) - force.t.begin();
  std::vector<Gap> inside;
  for (const Gap& gap : force.gaps) {
    const auto after = std::upper_bound(force.t.begin(), force.t.end(), gap.t) - force.t.begin();
    if (force.t[static_cast<std::size_t>(after)] <= from)
      first = std::max(first, after);
    else if (gap.t >= to)
      last = std::min(last, after);
    else
      inside.push_back(gap);
  }
  Series part = force;
  part.t.assign(force.t.begin() + first, force.t.begin() + last);
  part.y.assign(force.y.begin() + first, force.y.begin() + last);
  part.lines.assign(force.lines.begin() + first, force.lines.begin() + last);
  part.gaps = std::move(inside);
  return part;
}

Error force_ends(const Series& force, const Series& motion, double t) {
  return Error{"force_ends",
               {{"force", force.column},
                {"from", force.t.front()},
                {"to", force.t.back()},
                {"column", motion.column},
                {"t", t}}};
}

/// Index of each sample of the motion on the grid. An Error if one has none.
Result<std::vector<std::size_t>> places_on(const ForceGrid& grid, const Series& motion, const Series& force) {
  std::vector<std::size_t> places;
  places.reserve(motion.t.size());
  for (std::size_t i = 0; i < motion.t.size(); ++i) {
    const double at = (motion.t[i] - grid.begin) / grid.spacing, place = std::round(at);
    if (place < 0 || place >= static_cast<double>(grid.size)) return force_ends(force, motion, motion.t[i]);
    if (std::abs(at - place) > most_uneven)
      return Error{"force_at_other_times",
                   {{"force", force.column}, {"column", motion.column}, {"t", motion.t[i]}}};
    places.push_back(static_cast<std::size_t>(place));
  }
  return places;
}

/// Outliers are sorted by time.
bool is_outlier(const Series& series, std::size_t i) {
  const auto found = std::lower_bound(series.outliers.begin(), series.outliers.end(), series.t[i],
                                      [](const Outlier& outlier, double t) { return outlier.t < t; });
  return found != series.outliers.end() && found->t == series.t[i];
}

}  // namespace

Result<Series> take_force(const Recording& recording, const FitOptions& options, int run) {
  Result<Series> force = take_series(recording, options.force_column, run, options.read);
  if (!force) return Error{"of_force_column", {{"what", force.error().notice}}};
  return force;
}

bool is_about_a_force(const Notice& what) {
  static constexpr std::string_view codes[] = {
      "force_is_too_short", "force_never_changes", "force_has_a_gap",     "force_has_gaps",
      "force_is_uneven",    "force_ends",          "force_at_other_times"};
  return std::find(std::begin(codes), std::end(codes), what.code) != std::end(codes);
}

Result<FittedRecording> fit_forced(const Series& motion, const Series& force, std::string_view file,
                                   const FitOptions& options, const Watch& watch) {
  if (motion.column == force.column) return Error{"force_is_the_motion", {{"column", force.column}}};
  Result<Series> used = samples_in_use(motion, options);
  if (!used) return used.error();
  const Series around = force_around(force, used->t.front(), used->t.back());
  if (around.t.empty() && around.gaps.empty() && !force.t.empty())
    return force_ends(force, *used, used->t.front());
  const Result<ForceGrid> grid = grid_of(around);
  if (!grid) return grid.error();
  const Result<std::vector<std::size_t>> places = places_on(*grid, *used, force);
  if (!places) return places.error();

  // The motion's samples that are no outliers, at the force's own times.
  const ForceRecord recorded{around.y, grid->begin, grid->spacing};
  std::vector<double> t, y;
  for (std::size_t i = 0; i < used->t.size(); ++i) {
    if (is_outlier(*used, i)) continue;
    t.push_back(grid->time((*places)[i]));
    y.push_back(used->y[i]);
  }
  if (t.empty()) return Error{"all_set_aside", {{"column", motion.column}}};
  const std::size_t fitted =
      options.hold_out
          ? static_cast<std::size_t>(std::lround((1 - *options.hold_out) * static_cast<double>(t.size())))
          : t.size();
  const Record whole = record_of(*used, t, y);

  const Result<std::optional<Law>> law = law_of(options);
  if (!law) return law.error();
  FittedRecording result = row_to_fit(motion, *std::move(used), file, options);
  for (const Notice& notice : force.notices)
    result.notices.push_back(Notice{"of_the_force", {{"what", notice}}});
  // The law's motion begins at the first sample that the fit sees, and the series ends at the last.
  FitOptions cut;
  cut.from = t.front();
  if (fitted < t.size()) cut.to = t[fitted - 1];
  result.series = *used_part(std::move(result.series), cut);
  LawFitOptions settings{.drive = Drive::recorded(recorded),
                         .hysteresis_exponent = options.hysteresis_exponent};
  if (options.no_spring) settings.law = settings.law.without(law_with<Spring>);
  LawChoice choice = choose_law(whole.first(fitted), settings, watch, {*law, reading_of(options)});
  std::vector<double> of_series;
  for (const double at : result.series.t)
    of_series.push_back(
        grid->time(static_cast<std::size_t>(std::lround((at - grid->begin) / grid->spacing))));
  describe_driven_fit(result, std::move(choice), whole.first(fitted), of_series, unit_of(force), watch);
  result.between_samples = name(result.fit.drive.force.between);
  if (result.driven) {
    const std::optional<ForceNoiseSeen> noise = result.fit.force_noise;
    if (!noise) result.notices.push_back(Notice{"force_taken_as_exact"});
    if (noise && noise->counts)
      result.notices.push_back(
          noise->shows ? Notice{"force_is_noisy", {{"noise", noise->deviation}, {"unit", unit_of(force)}}}
                       : Notice{"force_may_be_noisy"});
  }
  add_unused_notices(result);
  std::vector<double> law_motion;
  if (result.driven && fitted < t.size())
    law_motion = observed_motion(result.fit.motion, result.fit.drive, t, whole.derivative, result.fit.step);
  result.fit.drive.force.samples = {};  // they do not outlive this function
  // Without them a law that was refused has no motion, and keeps no values.
  if (!result.driven) {
    result.fit.names.clear();
    result.fit.estimates.clear();
    result.fit.covariance.clear();
  }
  if (law_motion.empty()) return result;
  // The law is carried on through the samples held out.
  HeldOut& held = result.held_out.emplace(HeldOut{.from = t[fitted], .to = t.back(), .samples = 0, .rms = 0});
  for (std::size_t i = fitted; i < law_motion.size(); ++i) {
    held.rms += (y[i] - law_motion[i]) * (y[i] - law_motion[i]);
    held.t.push_back(t[i]);
    held.measured.push_back(y[i]);
    held.law.push_back(law_motion[i]);
    ++held.samples;
  }
  held.rms = std::sqrt(held.rms / static_cast<double>(held.samples));
  return result;
}

}  // namespace cromer::core
