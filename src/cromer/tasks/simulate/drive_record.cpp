#include "cromer/tasks/simulate/drive_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cromer/base/quantity.h"
#include "cromer/read/column_kind.h"

namespace cromer::core {
namespace {

constexpr double most_uneven = 0.02;  // of a spacing

/// The one column that can be meant: of the quantity, or the only one beside the time.
Result<std::string> column_of(const Recording& recording, int run, const DriveRequest& request) {
  std::vector<std::string> alike, others;
  for (const Column& column : recording.table.columns) {
    if (column.run != run || column.quantity == "time" || column.quantity == "index") continue;
    (column.quantity == request.quantity ? alike : others).push_back(column.name);
  }
  const auto& candidates = alike.empty() ? others : alike;
  if (candidates.size() == 1) return candidates.front();
  if (candidates.empty()) return Error{"there is no column beside the time"};
  std::string list;
  for (const auto& name : candidates) list += (list.empty() ? "\"" : ", \"") + name + "\"";
  return Error{fmt::format("which column is the {}? {}; say it with {}", request.quantity, list,
                           request.column_option)};
}

Result<void> check_even(const Series& series, double spacing, std::string_view use) {
  for (std::size_t i = 0; i < series.t.size(); ++i) {
    const double even = series.t.front() + static_cast<double>(i) * spacing;
    if (std::abs(series.t[i] - even) > most_uneven * spacing)
      return Error{fmt::format(
          "line {}: the times are not evenly spaced ({:.6g} s where {:.6g} s is expected, one sample "
          "each {:.6g} s); a {} needs even samples: resample it first",
          series.lines[i], series.t[i], even, spacing, use)};
  }
  return {};
}

}  // namespace

Result<DriveRecord> read_drive_record(std::string_view bytes, std::string_view file,
                                      const DriveRequest& request, const ReadOptions& options) {
  const auto refuse = [&](std::string_view why) { return Error{fmt::format("{}: {}", file, why)}; };
  const auto recording = read_recording(bytes, file, options);
  if (!recording) return recording.error();
  const std::vector<int> all = runs(*recording);
  if (all.empty()) return refuse("there is no column of numbers");
  const int run = request.run > 0 ? request.run : all.front();
  if (std::find(all.begin(), all.end(), run) == all.end())
    return refuse(fmt::format("there is no run {}; the file has {}", run, all.size()));
  Result<std::string> name = std::string(request.column);
  if (name->empty()) name = column_of(*recording, run, request);
  if (!name) return refuse(name.error().message);
  const auto series = take_series(*recording, *name, run, options);
  if (!series) return series.error();

  if (!series->quantity.empty() && series->quantity != request.quantity)
    return refuse(fmt::format(
        "column \"{}\" holds {}, not {}; choose another with {}", series->column, series->quantity,
        request.quantity == "force" ? "a force (N)" : "an acceleration (m/s^2 or g)", request.column_option));
  if (series->t.size() < 2)
    return refuse(fmt::format("column \"{}\" has {}, and a {} needs at least two samples", series->column,
                              series->t.empty() ? "no sample" : "one sample", request.use));
  if (!series->gaps.empty())
    return refuse(fmt::format(
        "the samples have {} of {:.6g} s after t = {:.6g} s; a {} needs even samples without "
        "gaps: fill in what is missing, or cut or resample the recording",
        series->gaps.size() == 1 ? "a gap" : fmt::format("{} gaps, the first", series->gaps.size()),
        series->gaps.front().length, series->gaps.front().t, request.use));
  DriveRecord record;
  record.spacing = (series->t.back() - series->t.front()) / static_cast<double>(series->t.size() - 1);
  if (const auto even = check_even(*series, record.spacing, request.use); !even)
    return refuse(even.error().message);
  record.values = series->y;
  record.column = series->column;
  record.motion = recording->motion;
  const auto target = parse_unit(request.quantity == "force" ? "N" : "m/s^2");
  const auto unit = parse_unit(series->unit, &target->dimension);
  record.unit_known = !series->unit.empty() && unit && unit->dimension == target->dimension;
  record.warnings = recording->warnings;
  for (const auto& warning : series->warnings)
    record.warnings.push_back(fmt::format("{}: {}", file, warning));
  if (all.size() > 1 && request.run == 0)
    record.warnings.push_back(
        fmt::format("{}: run {} of {} is taken as the {}", file, run, all.size(), request.use));
  if (request.use == "drive" && std::abs(series->t.front()) > most_uneven * record.spacing)
    record.warnings.push_back(fmt::format("{}: its first sample, at {:.6g} s, acts at the run's start, t = 0",
                                          file, series->t.front()));
  return record;
}

}  // namespace cromer::core
