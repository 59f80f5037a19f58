// One column of one run as times and values.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "cromer/base/extent.h"
#include "cromer/base/quantity.h"
#include "cromer/read/angle_about_pivot.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"
#include "cromer/read/in_file.h"
#include "cromer/read/recording.h"
#include "cromer/read/series_shape.h"
#include "cromer/read/time.h"

namespace cromer::core {
namespace {

/// The column if none is named. Several alike are an Error, and so are several
/// of which only the names are known; in a file without names it is the first that is not a time.
Result<std::size_t> main_column(const Recording& recording, int run, std::vector<Notice>& notices) {
  const auto& columns = recording.table.columns;
  const std::vector<std::size_t> alike = motion_columns(recording, run);
  if (alike.size() == 1) return alike.front();
  if (!alike.empty())
    return Error{"columns_alike",
                 {{"columns", quoted_titles(columns, alike)}, {"first", columns[alike.front()].name}}};
  constexpr std::array<std::string_view, 3> no_motions{"time", "index", "frequency"};
  std::vector<std::size_t> left, frequencies;
  for (std::size_t j = 0; j < columns.size(); ++j) {
    if (columns[j].run != run) continue;
    if (std::find(no_motions.begin(), no_motions.end(), columns[j].quantity) == no_motions.end())
      left.push_back(j);
    if (columns[j].quantity == "frequency") frequencies.push_back(j);
  }
  if (left.empty() && !frequencies.empty())
    return Error{
        "frequencies_only",
        {{"columns", quoted_titles(columns, frequencies)}, {"first", columns[frequencies.front()].name}}};
  if (left.empty()) return Error{"no_column_beside_time"};
  const Column& first = columns[left.front()];
  const std::string title = column_title(first);
  if (left.size() == 1)
    notices.push_back(Notice{"only_column_taken", {{"column", title}}});
  else if (recording.named)
    return Error{"no_motion_known", {{"columns", quoted_titles(columns, left)}, {"first", first.name}}};
  else
    notices.push_back(
        Notice{"first_column_taken", {{"column", title}, {"columns", quoted_titles(columns, left)}}});
  return left.front();
}

/// What is assumed of a column whose unit is missing or unknown.
void say_assumed_unit(const Column& column, std::vector<Notice>& notices) {
  if (to_si(column).known) return;
  const std::string_view si = si_unit_of(column.quantity);
  if (!column.unit.empty())
    notices.push_back(Notice{"unit_not_known", {{"unit", column.unit}, {"column", column.name}}});
  else if (!si.empty())
    notices.push_back(Notice{"unit_assumed", {{"column", column.name}, {"unit", si}}});
  else
    notices.push_back(Notice{"column_without_unit", {{"column", column.name}}});
}

/// `rate` of a series without a time column; else 0.
void describe_times(Series& series, double rate) {
  dialects::Steps steps = dialects::describe_steps(series.t);
  series.rate = rate > 0 && series.t.size() > 1 ? rate : steps.rate;
  series.jitter = rate > 0 ? 0 : steps.jitter;
  series.gaps = std::move(steps.gaps);
  if (steps.clock && rate <= 0) {
    series.t = std::move(steps.clock->t);
    series.clock_error = steps.clock->error;
    series.notices.push_back(Notice{
        "times_made_even",
        {{"rounding", shortest(steps.clock->rounding)}, {"spacing", rounded(steps.clock->spacing, 6)}}});
  }
  if (series.gaps.empty()) return;
  const auto longest = std::max_element(series.gaps.begin(), series.gaps.end(),
                                        [](const Gap& a, const Gap& b) { return a.length < b.length; });
  series.notices.push_back(Notice{"gaps_in_times",
                                  {{"gaps", series.gaps.size()},
                                   {"longest", rounded(longest->length, 3)},
                                   {"at", rounded(longest->t, 6)}}});
}

/// Motion sensors drop whole stretches. In other columns (a force's pulses) only single samples are doubted.
bool is_motion(const Series& series) {
  constexpr std::array<std::string_view, 4> motions{"position", "angle", "velocity", "angular velocity"};
  return std::find(motions.begin(), motions.end(), series.quantity) != motions.end();
}

/// Lists spikes and drop-outs, with a notice; the values stay.
void set_aside(Series& series) {
  const double step = 1 / series.rate;
  std::set<std::size_t> found;
  std::vector<dialects::DropOut> stretches;
  if (is_motion(series)) stretches = dialects::drop_outs(series.t, series.y, step, series.resolution);
  for (const dialects::DropOut& stretch : stretches)
    for (std::size_t i = stretch.first; i < stretch.end; ++i) found.insert(i);
  const std::size_t dropped = found.size();
  std::size_t alone = 0, first_alone = 0;
  for (const std::size_t i : dialects::spikes(series.t, series.y, step, series.resolution))
    if (found.insert(i).second && alone++ == 0) first_alone = i;
  for (const std::size_t i : found) series.outliers.push_back({series.t[i], series.y[i], series.lines[i]});
  if (alone > 0)
    series.notices.push_back(
        Notice{"samples_stick_out", {{"samples", alone}, {"line", series.lines[first_alone]}}});
  if (dropped > 0)
    series.notices.push_back(Notice{"samples_in_drop_outs",
                                    {{"samples", dropped},
                                     {"drop_outs", stretches.size()},
                                     {"line", series.lines[stretches.front().first]}}});
}

void describe_values(Series& series, const std::vector<double>& as_written) {
  series.resolution = dialects::rounding_step(as_written) * series.to_si;
  if (series.rate > 0) set_aside(series);
  if (series.rate > 0 && is_motion(series) &&
      !dialects::tops_cut_off(series.y, 1 / series.rate, series.resolution).empty())
    series.notices.push_back(Notice{"column_tops_cut_off", {{"column", series.column}}});
  const auto [low, high] = extent_of(series.y);
  if (low == high) series.notices.push_back(Notice{"column_never_changes", {{"column", series.column}}});
}

/// Why the only column of times cannot be the motion, and which columns may be.
Notice column_is_the_time(const Recording& recording, std::size_t time) {
  const auto& columns = recording.table.columns;
  std::vector<std::size_t> others;
  for (std::size_t j = 0; j < columns.size(); ++j)
    if (columns[j].run == columns[time].run && columns[j].quantity != "time" &&
        columns[j].quantity != "index")
      others.push_back(j);
  if (others.empty()) return Notice{"no_column_beside_time"};
  return Notice{"column_is_the_time",
                {{"column", column_title(columns[time])}, {"others", quoted_titles(columns, others)}}};
}

/// Whether the file has a column of just this name.
bool has_column(const Table& table, std::string_view name) {
  return std::any_of(table.columns.begin(), table.columns.end(), [&](const Column& column) {
    return column.name == name || column_title(column) == name;
  });
}

/// An angle of two columns, as if the file held it.
Result<Series> take_angle(const Recording& recording, ComputedAngle angle, const ReadOptions& options) {
  const Column &x = recording.table.columns[angle.x], &y = recording.table.columns[angle.y];
  Recording with_angle = recording;
  const auto place = static_cast<std::ptrdiff_t>(angle.place);
  with_angle.table.columns.insert(with_angle.table.columns.begin() + place, std::move(angle.angle));
  if (auto& sets = with_angle.set_of_column; !sets.empty())
    sets.insert(sets.begin() + place, std::size_t{sets[angle.x]});
  auto series = take_series(with_angle, name_of_angle(x, y), x.run, options);
  if (!series) return series;
  series->scale_error = angle.arc.radius_error / angle.arc.radius;
  if (const ToSi metres = to_si(x); metres.known || x.unit.empty())
    series->arc_radius = metres.factor * angle.arc.radius;
  std::vector<Notice> notices{
      Notice{"angle_about_pivot",
             {{"x", x.name},
              {"y", y.name},
              {"radius", format_quantity({angle.arc.radius, angle.arc.radius_error},
                                         x.unit.empty() ? si_unit_of(x.quantity) : x.unit)}}}};
  say_assumed_unit(x, notices);
  if (y.unit != x.unit) say_assumed_unit(y, notices);
  series->notices.insert(series->notices.begin(), notices.begin(), notices.end());
  return series;
}

}  // namespace

std::string unit_of(const Series& series) {
  const std::string_view si = si_unit_of(series.quantity);
  if (!si.empty()) return std::string(si);
  return series.to_si == 1 ? series.unit : "";
}

std::vector<int> runs(const Recording& recording) {
  std::set<int> found;
  for (const Column& column : recording.table.columns) found.insert(column.run);
  return {found.begin(), found.end()};
}

std::vector<std::size_t> motion_columns(const Recording& recording, int run) {
  const auto& columns = recording.table.columns;
  std::vector<std::size_t> alike;
  for (const std::string_view quantity :
       {"position", "angle", "angular velocity", "velocity", "acceleration"}) {
    for (std::size_t j = 0; j < columns.size(); ++j)
      if (columns[j].run == run && columns[j].quantity == quantity) alike.push_back(j);
    if (!alike.empty()) break;
  }
  return alike;
}

Result<void> check_run(const Recording& recording, int run) {
  const std::vector<int> known = runs(recording);
  if (std::find(known.begin(), known.end(), run) != known.end()) return {};
  return Error{in_file(recording.file, Notice{"no_such_run", {{"run", run}, {"runs", known.size()}}})};
}

Result<Series> take_series(const Recording& recording, std::string_view column, int run,
                           const ReadOptions& options) {
  const auto refuse = [&](Notice reason) { return Error{in_file(recording.file, std::move(reason))}; };
  const auto& columns = recording.table.columns;
  if (const auto known = check_run(recording, run); !known) return known.error();
  if (!has_column(recording.table, column)) {
    auto angle = computed_angle(recording.table, column, run);
    if (!angle) return refuse(angle.error().notice);
    if (*angle) return take_angle(recording, **std::move(angle), options);
  }
  Series series;
  const auto chosen = column.empty() ? main_column(recording, run, series.notices)
                                     : find_column(recording.table, column, run);
  if (!chosen) return refuse(chosen.error().notice);
  const Column& value = columns[*chosen];
  const double factor = to_si(value).factor;
  series.column = column_title(value);
  series.quantity = value.quantity;
  series.unit = value.unit;
  series.to_si = factor;
  series.run = run;
  say_assumed_unit(value, series.notices);
  if (value.quantity == "frequency")
    series.notices.push_back(Notice{"column_of_frequency", {{"column", series.column}}});

  const auto time = dialects::time_column_of(recording.table, *chosen);
  if (!time && value.quantity == "time") return refuse(column_is_the_time(recording, *chosen));
  if (!time && options.rate <= 0) return refuse(Notice{"no_time_column"});
  double seconds = 1;
  if (time) {
    seconds = to_si(columns[*time]).factor;
    series.time_column = column_title(columns[*time]);
    if (columns[*time].unit.empty()) say_assumed_unit(columns[*time], series.notices);
    if (options.rate > 0) series.notices.push_back(Notice{"rate_not_used", {{"column", series.time_column}}});
  }

  std::size_t n = 0;  // of the rows that have both
  std::vector<double> t(value.values.size()), y = t, as_written = t;
  std::vector<long> lines(value.values.size());
  for (std::size_t i = 0; i < value.values.size(); ++i) {
    const double at = time ? columns[*time].values[i] * seconds : static_cast<double>(i) / options.rate;
    const double y_si = value.values[i] * factor;
    if (!std::isfinite(at) || !std::isfinite(y_si)) continue;
    t[n] = at;
    y[n] = y_si;
    as_written[n] = value.values[i];
    lines[n++] = line_of(recording, *chosen, i);
  }
  for (auto* values : {&t, &y, &as_written}) values->resize(n);
  lines.resize(n);
  if (t.empty()) return refuse(Notice{"column_without_values", {{"column", series.column}, {"run", run}}});
  const auto rising = dialects::keep_rising(t, lines);
  if (!rising)
    return refuse(Notice{"in_column", {{"column", series.time_column}, {"what", rising.error().notice}}});
  series.notices.insert(series.notices.end(), rising->notices.begin(), rising->notices.end());
  const auto keep = [&](auto& values) {
    if (rising->kept.size() < values.size())
      for (std::size_t k = 0; k < rising->kept.size(); ++k) values[k] = values[rising->kept[k]];
    values.resize(rising->kept.size());
    return std::move(values);
  };
  series.t = keep(t);
  series.y = keep(y);
  series.lines = keep(lines);
  describe_times(series, time ? 0 : options.rate);
  if (series.t.size() > 1 && !(series.rate > 0 && std::isfinite(series.rate)))
    return refuse(Notice{
        "no_step_of_time",
        {{"column", series.time_column}, {"from", shortest(series.t[0])}, {"to", shortest(series.t[1])}}});
  describe_values(series, as_written);
  // Pixels are no metres: a displacement in an unknown unit has no known quantity.
  const bool displacement = series.quantity == "position" || series.quantity == "angle";
  if (displacement && !series.unit.empty() && !to_si(value).known) series.quantity.clear();
  return series;
}

}  // namespace cromer::core
