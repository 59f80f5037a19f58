// One column of one run as times and values.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"
#include "cromer/read/drop_outs.h"
#include "cromer/read/recording.h"
#include "cromer/read/series_shape.h"
#include "cromer/read/steps.h"
#include "cromer/read/time.h"

namespace cromer::core {
namespace {

/// "x (m)", "y (m)".
std::string titles(const std::vector<Column>& columns, const std::vector<std::size_t>& chosen) {
  std::string list;
  for (const std::size_t j : chosen)
    list += concat({list.empty() ? "" : ", ", "\"", column_title(columns[j]), "\""});
  return list;
}

/// Without a name: a position, else an angle, ...; several alike are an Error, and so are several of which
/// nothing is known but their names; without names it is the first that is no time.
Result<std::size_t> main_column(const Recording& recording, int run, std::vector<std::string>& warnings) {
  constexpr std::array<std::string_view, 5> wanted{"position", "angle", "angular velocity", "velocity",
                                                   "acceleration"};
  const auto& columns = recording.table.columns;
  std::vector<std::size_t> of_run;
  for (std::size_t j = 0; j < columns.size(); ++j)
    if (columns[j].run == run) of_run.push_back(j);
  for (const std::string_view quantity : wanted) {
    std::vector<std::size_t> alike;
    for (const std::size_t j : of_run)
      if (columns[j].quantity == quantity) alike.push_back(j);
    if (alike.size() == 1) return alike.front();
    if (alike.empty()) continue;
    return Error{
        concat({"several columns are alike: ", titles(columns, alike),
                "; say which with --column, for instance --column \"", columns[alike.front()].name, "\""})};
  }
  constexpr std::array<std::string_view, 3> no_motions{"time", "index", "frequency"};
  std::vector<std::size_t> left, frequencies;
  for (const std::size_t j : of_run) {
    if (std::find(no_motions.begin(), no_motions.end(), columns[j].quantity) == no_motions.end())
      left.push_back(j);
    if (columns[j].quantity == "frequency") frequencies.push_back(j);
  }
  if (left.empty() && !frequencies.empty())
    return Error{concat({"there is no motion beside the time: ", titles(columns, frequencies),
                         frequencies.size() == 1 ? " holds a frequency" : " hold frequencies",
                         "; to fit one all the same, say it with --column, for instance --column \"",
                         columns[frequencies.front()].name, "\""})};
  if (left.empty()) return Error{"there is no column beside the time"};
  const std::string list = titles(columns, left);
  const std::string_view first = columns[left.front()].name;
  if (left.size() > 1 && recording.named)
    return Error{concat({"no column is known to be a position, angle or velocity: ", list,
                         "; say which with --column, for instance --column \"", first, "\""})};
  warnings.push_back(concat({"no column is known to be a position, angle or velocity: \"",
                             column_title(columns[left.front()]), "\" is taken"}));
  if (left.size() > 1) warnings.back() += concat({" of ", list, "; --column says another"});
  return left.front();
}

/// What is assumed of a column whose unit is missing or unknown.
void say_assumed_unit(const Column& column, std::vector<std::string>& warnings) {
  if (to_si(column).known) return;
  const std::string_view si = si_unit_of(column.quantity);
  if (!column.unit.empty())
    warnings.push_back(concat({"unit \"", column.unit, "\" of column \"", column.name,
                               "\" is not known: its values are taken as they are"}));
  else if (!si.empty())
    warnings.push_back(concat({"column \"", column.name, "\" has no unit: ", si, " is assumed"}));
  else
    warnings.push_back(
        concat({"column \"", column.name, "\" has no unit: its values are taken as they are"}));
}

/// `rate`: of a series without a time column, else 0.
void describe_times(Series& series, double rate) {
  dialects::Steps steps = dialects::describe_steps(series.t);
  series.rate = rate > 0 && series.t.size() > 1 ? rate : steps.rate;
  series.jitter = rate > 0 ? 0 : steps.jitter;
  series.gaps = std::move(steps.gaps);
  if (steps.clock && rate <= 0) {
    series.t = std::move(steps.clock->t);
    series.warnings.push_back(
        concat({"the times are rounded to ", shortest(steps.clock->rounding), " s and agree with even ones ",
                rounded(steps.clock->spacing, 6), " s apart, which are taken"}));
  }
  if (series.gaps.empty()) return;
  const auto longest = std::max_element(series.gaps.begin(), series.gaps.end(),
                                        [](const Gap& a, const Gap& b) { return a.length < b.length; });
  series.warnings.push_back(concat({counted(series.gaps.size(), "gap"), " in the times, the longest ",
                                    rounded(longest->length, 3), " s at ", rounded(longest->t, 6), " s"}));
}

/// What a motion sensor drops is a stretch of its own; of other columns (a force's pulses) only single
/// samples are doubted.
bool is_motion(const Series& series) {
  constexpr std::array<std::string_view, 4> motions{"position", "angle", "velocity", "angular velocity"};
  return std::find(motions.begin(), motions.end(), series.quantity) != motions.end();
}

/// Spikes and drop-outs: listed, counted and said, not changed.
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
  const auto say = [&](std::string_view what, std::size_t first) {
    series.warnings.push_back(concat({what, ", the first in line ", std::to_string(series.lines[first])}));
  };
  if (alone > 0)
    say(concat({counted(alone, "sample"), alone == 1 ? " sticks" : " stick", " out alone"}), first_alone);
  if (dropped > 0)
    say(concat({counted(dropped, "sample"), " in ", counted(stretches.size(), "drop-out"), " of the sensor"}),
        stretches.front().first);
}

void describe_values(Series& series, const std::vector<double>& as_written) {
  series.resolution = dialects::rounding_step(as_written) * series.to_si;
  if (series.rate > 0) set_aside(series);
  if (series.rate > 0 && is_motion(series) &&
      dialects::tops_cut_off(series.y, 1 / series.rate, series.resolution))
    series.warnings.push_back(
        concat({"column \"", series.column,
                "\": the motion's tops are cut off at the same value again and again, as "
                "where a sensor is out of its range"}));
  const auto [low, high] = std::minmax_element(series.y.begin(), series.y.end());
  if (!series.y.empty() && *low == *high)
    series.warnings.push_back(concat({"column \"", series.column, "\" never changes"}));
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

Result<Series> take_series(const Recording& recording, std::string_view column, int run,
                           const ReadOptions& options) {
  const auto refuse = [&](std::string_view reason) { return Error{concat({recording.file, ": ", reason})}; };
  const auto& columns = recording.table.columns;
  if (std::none_of(columns.begin(), columns.end(), [&](const Column& of) { return of.run == run; })) {
    const std::size_t known = runs(recording).size();
    return refuse(concat({"there is no run ", std::to_string(run), ": the file has ",
                          known == 1 ? "one run" : counted(known, "run")}));
  }
  Series series;
  const auto chosen = column.empty() ? main_column(recording, run, series.warnings)
                                     : find_column(recording.table, column, run);
  if (!chosen) return refuse(chosen.error().message);
  const Column& value = columns[*chosen];
  const double factor = to_si(value).factor;
  series.column = column_title(value);
  series.quantity = value.quantity;
  series.unit = value.unit;
  series.to_si = factor;
  series.run = run;
  say_assumed_unit(value, series.warnings);
  if (value.quantity == "frequency")
    series.warnings.push_back(concat({"column \"", series.column,
                                      "\" holds a frequency, which is no motion: its numbers are taken as "
                                      "they are, in Hz"}));

  const auto time = dialects::time_column_of(recording.table, *chosen);
  if (!time && options.rate <= 0)
    return refuse(
        "there is no time column: give the samples per second with --rate, or name the column with "
        "--time-column");
  double seconds = 1;
  if (time) {
    seconds = to_si(columns[*time]).factor;
    series.time_column = column_title(columns[*time]);
    if (columns[*time].unit.empty()) say_assumed_unit(columns[*time], series.warnings);
    if (options.rate > 0)
      series.warnings.push_back(
          concat({"--rate is not used: the times stand in \"", series.time_column, "\""}));
  }

  std::vector<double> t, y, as_written;
  std::vector<long> lines;
  for (auto* values : {&t, &y, &as_written}) values->reserve(value.values.size());
  lines.reserve(value.values.size());
  for (std::size_t i = 0; i < value.values.size(); ++i) {
    const double at = time ? columns[*time].values[i] * seconds : static_cast<double>(i) / options.rate;
    const double y_si = value.values[i] * factor;
    if (!std::isfinite(at) || !std::isfinite(y_si)) continue;
    t.push_back(at);
    y.push_back(y_si);
    as_written.push_back(value.values[i]);
    lines.push_back(line_of(recording, *chosen, i));
  }
  if (t.empty())
    return refuse(concat({"column \"", series.column, "\" of run ", std::to_string(run), " has no values"}));
  const auto rising = dialects::keep_rising(t, lines);
  if (!rising) return refuse(concat({"column \"", series.time_column, "\": ", rising.error().message}));
  series.warnings.insert(series.warnings.end(), rising->warnings.begin(), rising->warnings.end());
  for (auto* values : {&series.t, &series.y}) values->reserve(rising->kept.size());
  series.lines.reserve(rising->kept.size());
  for (const std::size_t i : rising->kept) {
    series.t.push_back(t[i]);
    series.y.push_back(y[i]);
    series.lines.push_back(lines[i]);
  }
  describe_times(series, time ? 0 : options.rate);
  if (series.t.size() > 1 && !(series.rate > 0 && std::isfinite(series.rate)))
    return refuse(concat({"column \"", series.time_column, "\": from ", shortest(series.t[0]), " to ",
                          shortest(series.t[1]),
                          " is no step of time: seconds are expected, or a unit behind the name"}));
  describe_values(series, as_written);
  // Pixels are no metres: a displacement in a unit of its own has none that is known.
  const bool displacement = series.quantity == "position" || series.quantity == "angle";
  if (displacement && !series.unit.empty() && !to_si(value).known) series.quantity.clear();
  return series;
}

}  // namespace cromer::core
