#include "cromer/tasks/inspect/inspect.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "cromer/base/concat.h"
#include "cromer/base/quantity.h"
#include "cromer/read/columns.h"
#include "cromer/read/time.h"

namespace cromer::core {
namespace {

/// The first of what a fit would take in a run: a position, else an angle, ..., else anything beside the
/// time.
const Column* main_column(const Recording& recording, int run) {
  for (const std::string_view quantity :
       {"position", "angle", "angular velocity", "velocity", "acceleration", "any other"})
    for (const Column& column : recording.table.columns)
      if (column.run == run &&
          (column.quantity == quantity ||
           (quantity == "any other" && column.quantity != "time" && column.quantity != "index")))
        return &column;
  return nullptr;
}

/// Where several columns are alike, that of the first of them, since a description need not choose: that is
/// said.
Result<Series> main_series(const Recording& recording, int run, const ReadOptions& options) {
  auto series = take_series(recording, "", run, options);
  const Column* main = series ? nullptr : main_column(recording, run);
  if (!main) return series;
  auto first = take_series(recording, column_title(*main), run, options);
  if (first && main->quantity != "frequency")
    first->warnings.push_back(
        "several columns may be meant: what is said of times and outliers is that of \"" +
        column_title(*main) + "\"; a fit needs --column");
  return first;
}

/// Values that are there, and the time column they are taken with.
InspectedColumn look_at(const Recording& recording, std::size_t j, std::optional<std::size_t> time) {
  const Column& column = recording.table.columns[j];
  InspectedColumn found;
  found.samples = static_cast<std::size_t>(std::count_if(column.values.begin(), column.values.end(),
                                                         [](double value) { return !std::isnan(value); }));
  if (time && column.quantity != "time") found.time_column = column_title(recording.table.columns[*time]);
  return found;
}

/// What a run's other columns hold beside their motion: a description is not only of the one that a fit
/// takes.
std::vector<std::string> outliers_elsewhere(const Recording& recording, int run, const std::string& inspected,
                                            const ReadOptions& options) {
  std::vector<std::string> found;
  for (const Column& column : recording.table.columns) {
    const std::string title = column_title(column);
    if (column.run != run || column.quantity == "time" || column.quantity == "index" || title == inspected)
      continue;
    const auto series = take_series(recording, title, run, options);
    if (!series || series->outliers.empty()) continue;
    found.push_back(concat({"column \"", title, "\": ", counted(series->outliers.size(), "outlier"),
                            ", the first in line ", std::to_string(series->outliers.front().line), ": ",
                            shortest(series->outliers.front().value)}));
  }
  return found;
}

}  // namespace

Result<Inspection> inspect(std::string_view bytes, std::string_view file, const ReadOptions& options,
                           std::string_view column) {
  auto recording = read_recording(bytes, file, options);
  if (!recording) return recording.error();
  Inspection inspection;
  inspection.recording = std::move(*recording);
  inspection.warnings = inspection.recording.warnings;
  std::set<std::string> said(inspection.warnings.begin(), inspection.warnings.end());
  const auto say = [&](const std::string& warning) {
    if (said.insert(warning).second) inspection.warnings.push_back(warning);
  };
  const auto times = dialects::time_columns_of(inspection.recording.table);
  for (std::size_t j = 0; j < times.size(); ++j)
    inspection.columns.push_back(look_at(inspection.recording, j, times[j]));
  for (const int run : runs(inspection.recording)) {
    inspection.samples = std::max(inspection.samples, rows_of_run(inspection.recording.table, run));
    auto series = column.empty() ? main_series(inspection.recording, run, options)
                                 : take_series(inspection.recording, column, run, options);
    const Column* main = main_column(inspection.recording, run);
    if (inspection.column.empty() && (series || main))
      inspection.column = series ? series->column : column_title(*main);
    if (!series) {
      const std::string prefix = std::string(file) + ": ";
      const std::string& message = series.error().message;
      say(message.starts_with(prefix) ? message.substr(prefix.size()) : message);
      continue;
    }
    for (const std::string& warning : series->warnings) say(warning);
    for (const std::string& warning : outliers_elsewhere(inspection.recording, run, series->column, options))
      say(warning);
    inspection.gaps.insert(inspection.gaps.end(), series->gaps.begin(), series->gaps.end());
    inspection.outliers.insert(inspection.outliers.end(), series->outliers.begin(), series->outliers.end());
    const double duration = series->t.back() - series->t.front();
    if (inspection.series.empty() || duration > inspection.duration) {
      inspection.rate = series->rate;
      inspection.duration = duration;
      inspection.time_column = series->time_column;
      inspection.jitter = series->jitter;
    }
    inspection.series.push_back(std::move(*series));
  }
  return inspection;
}

}  // namespace cromer::core
