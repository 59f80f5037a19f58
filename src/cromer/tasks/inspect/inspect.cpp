#include "cromer/tasks/inspect/inspect.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "cromer/base/add_once.h"
#include "cromer/base/quantity.h"
#include "cromer/read/columns.h"
#include "cromer/read/in_file.h"
#include "cromer/read/time.h"
#include "cromer/tasks/inspect/take_motion.h"

namespace cromer::core {
namespace {

/// The first column of the kind that a fit would take: a position, else an angle, ..., else anything but the
/// time.
const Column* main_column(const Recording& recording, int run) {
  const auto& columns = recording.table.columns;
  if (const auto alike = motion_columns(recording, run); !alike.empty()) return &columns[alike.front()];
  const auto other = std::find_if(columns.begin(), columns.end(), [&](const Column& column) {
    return column.run == run && column.quantity != "time" && column.quantity != "index";
  });
  return other == columns.end() ? nullptr : &*other;
}

/// Of several columns alike that are no axes a description takes the first, and a notice says so.
Result<Series> main_series(const Recording& recording, int run, const ReadOptions& options) {
  auto series = take_motion(recording, "", run, options);
  const Column* main = series ? nullptr : main_column(recording, run);
  if (!main) return series;
  auto first = take_series(recording, column_title(*main), run, options);
  if (first && main->quantity != "frequency")
    first->notices.push_back(Notice{"inspected_one_of_several", {{"column", column_title(*main)}}});
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

/// Outliers in the run's other columns: a description is not only of the column that a fit takes.
std::vector<Notice> outliers_elsewhere(const Recording& recording, int run, const std::string& inspected,
                                       const ReadOptions& options) {
  std::vector<Notice> found;
  for (const Column& column : recording.table.columns) {
    const std::string title = column_title(column);
    if (column.run != run || column.quantity == "time" || column.quantity == "index" || title == inspected)
      continue;
    const auto series = take_series(recording, title, run, options);
    if (!series || series->outliers.empty()) continue;
    found.push_back(Notice{"outliers_in_column",
                           {{"column", title},
                            {"outliers", series->outliers.size()},
                            {"line", series->outliers.front().line},
                            {"value", shortest(series->outliers.front().value)}}});
  }
  return found;
}

}  // namespace

Result<Inspection> inspect(Recording recording, const ReadOptions& options, std::string_view column) {
  Inspection inspection;
  inspection.recording = std::move(recording);
  inspection.notices = inspection.recording.notices;
  const std::vector<int> all = runs(inspection.recording);
  OfRuns of_runs;
  const auto say = [&](int run, const Notice& notice) {
    if (all.size() <= 1)
      add_once(inspection.notices, notice);
    else if (auto& said = inspection.notices; std::find(said.begin(), said.end(), notice) == said.end())
      of_runs.say(run, notice);
  };
  const auto times = dialects::time_columns_of(inspection.recording.table);
  for (std::size_t j = 0; j < times.size(); ++j)
    inspection.columns.push_back(look_at(inspection.recording, j, times[j]));
  for (const int run : all) {
    inspection.samples = std::max(inspection.samples, rows_of_run(inspection.recording.table, run));
    auto series = column.empty() ? main_series(inspection.recording, run, options)
                                 : take_series(inspection.recording, column, run, options);
    const Column* main = main_column(inspection.recording, run);
    if (inspection.column.empty() && (series || main))
      inspection.column = series ? series->column : column_title(*main);
    if (!series) {
      say(run, without_file(series.error().notice, inspection.recording.file));
      continue;
    }
    for (const Notice& notice : series->notices) say(run, notice);
    for (const Notice& notice : outliers_elsewhere(inspection.recording, run, series->column, options))
      say(run, notice);
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
  for (Notice& notice : of_runs.said()) inspection.notices.push_back(std::move(notice));
  return inspection;
}

}  // namespace cromer::core
