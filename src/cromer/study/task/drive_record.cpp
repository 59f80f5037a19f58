#include "cromer/study/task/drive_record.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "cromer/record/dialects/column_kind.h"

namespace cromer {
namespace {

constexpr double most_uneven = 0.02;  // of a spacing

/// The one column that can be meant: of the quantity, or the only one beside the time.
Result<std::string> column_of(const Recording& recording, int run, std::string_view quantity) {
  std::vector<std::string> alike, others;
  for (const Column& column : recording.table.columns) {
    if (column.run != run || column.quantity == "time" || column.quantity == "index") continue;
    (column.quantity == quantity ? alike : others).push_back(column.name);
  }
  const auto& candidates = alike.empty() ? others : alike;
  if (candidates.size() == 1) return candidates.front();
  if (candidates.empty()) return Error{"there is no column beside the time"};
  std::string list;
  for (const auto& name : candidates) list += (list.empty() ? "\"" : ", \"") + name + "\"";
  return Error{fmt::format("which column is the {}? {}; say it with --drive-column", quantity, list)};
}

Result<void> check_even(const Series& series, double spacing) {
  for (std::size_t i = 0; i < series.t.size(); ++i) {
    const double even = series.t.front() + static_cast<double>(i) * spacing;
    if (std::abs(series.t[i] - even) > most_uneven * spacing)
      return Error{fmt::format(
          "line {}: the times are not evenly spaced ({:.6g} s where {:.6g} s is expected, one sample "
          "each {:.6g} s); a drive needs even samples: resample it first",
          series.lines[i], series.t[i], even, spacing)};
  }
  return {};
}

}  // namespace

Result<DriveRecord> read_drive_record(std::string_view bytes, std::string_view file,
                                      std::string_view quantity, std::string_view column,
                                      const ReadOptions& options) {
  const auto refuse = [&](std::string_view why) { return Error{fmt::format("{}: {}", file, why)}; };
  const auto recording = read_recording(bytes, file, options);
  if (!recording) return recording.error();
  const std::vector<int> all = runs(*recording);
  if (all.empty()) return refuse("there is no column of numbers");
  Result<std::string> name = std::string(column);
  if (column.empty()) name = column_of(*recording, all.front(), quantity);
  if (!name) return refuse(name.error().message);
  const auto series = take_series(*recording, *name, all.front(), options);
  if (!series) return series.error();

  if (!series->quantity.empty() && series->quantity != quantity)
    return refuse(fmt::format("column \"{}\" holds {}, not {}; choose another with --drive-column",
                              series->column, series->quantity,
                              quantity == "force" ? "a force (N)" : "an acceleration (m/s^2 or g)"));
  if (series->t.size() < 2) return refuse("a drive needs at least two samples");
  if (!series->gaps.empty())
    return refuse(fmt::format(
        "the samples have {} of {:.6g} s after t = {:.6g} s; a drive needs even samples without "
        "gaps: fill in what is missing, or cut or resample the recording",
        series->gaps.size() == 1 ? "a gap" : fmt::format("{} gaps, the first", series->gaps.size()),
        series->gaps.front().length, series->gaps.front().t));
  DriveRecord record;
  record.spacing = (series->t.back() - series->t.front()) / static_cast<double>(series->t.size() - 1);
  if (const auto even = check_even(*series, record.spacing); !even) return refuse(even.error().message);
  record.values = series->y;
  record.warnings = recording->warnings;
  for (const auto& warning : series->warnings)
    record.warnings.push_back(fmt::format("{}: {}", file, warning));
  if (all.size() > 1)
    record.warnings.push_back(
        fmt::format("{}: run {} of {} is taken as the drive", file, all.front(), all.size()));
  if (std::abs(series->t.front()) > most_uneven * record.spacing)
    record.warnings.push_back(fmt::format("{}: its first sample, at {:.6g} s, acts at the run's start, t = 0",
                                          file, series->t.front()));
  return record;
}

}  // namespace cromer
