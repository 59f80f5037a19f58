#include "cromer/study/task/inspect.h"

#include <algorithm>
#include <cmath>

#include "cromer/record/dialects/columns.h"

namespace cromer {
namespace {

/// The column a fit would take; where several are alike, the first of them, since a description need not
/// choose.
Result<Series> main_series(const Recording& recording, int run, const ReadOptions& options) {
  auto series = take_series(recording, "", run, options);
  if (series) return series;
  for (const std::string_view quantity :
       {"position", "angle", "angular velocity", "velocity", "acceleration"})
    for (const Column& column : recording.table.columns)
      if (column.run == run && column.quantity == quantity)
        return take_series(recording, column_title(column), run, options);
  return series;
}

/// Rows up to the last with a value.
std::size_t length_of(const Recording& recording, int run) {
  std::size_t length = 0;
  for (const Column& column : recording.table.columns)
    for (std::size_t i = column.values.size(); column.run == run && i > length; --i)
      if (!std::isnan(column.values[i - 1])) length = i;
  return length;
}

}  // namespace

Result<Inspection> inspect(std::string_view bytes, std::string_view file, const ReadOptions& options) {
  auto recording = read_recording(bytes, file, options);
  if (!recording) return recording.error();
  Inspection inspection;
  inspection.recording = std::move(*recording);
  inspection.warnings = inspection.recording.warnings;
  const auto say = [&](const std::string& warning) {
    auto& all = inspection.warnings;
    if (std::find(all.begin(), all.end(), warning) == all.end()) all.push_back(warning);
  };
  for (const int run : runs(inspection.recording)) {
    inspection.samples = std::max(inspection.samples, length_of(inspection.recording, run));
    auto series = main_series(inspection.recording, run, options);
    if (!series) {
      const std::string prefix = std::string(file) + ": ";
      const std::string& message = series.error().message;
      say(message.starts_with(prefix) ? message.substr(prefix.size()) : message);
      continue;
    }
    for (const std::string& warning : series->warnings) say(warning);
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

}  // namespace cromer
