#include "cromer/tasks/simulate/drive_record.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cromer/base/quantity.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/in_file.h"

namespace cromer::core {
namespace {

bool wants_force(const DriveRequest& request) { return request.quantity == "force"; }

Notice use_of(const DriveRequest& request) {
  return request.use == "drive" ? Notice{"drive"} : Notice{"spectrum"};
}

/// The one column that can be meant: of the quantity, or the only one beside the time.
Result<std::string> drive_column(const Recording& recording, int run, const DriveRequest& request) {
  std::vector<std::string> alike, others;
  for (const Column& column : recording.table.columns) {
    if (column.run != run || column.quantity == "time" || column.quantity == "index") continue;
    (column.quantity == request.quantity ? alike : others).push_back(column.name);
  }
  const auto& candidates = alike.empty() ? others : alike;
  if (candidates.size() == 1) return candidates.front();
  if (candidates.empty()) return Error{"no_column_beside_time"};
  std::vector<Notice> list;
  for (const std::string& name : candidates) list.push_back(Notice{"quoted", {{"text", name}}});
  return Error{wants_force(request) ? "which_column_is_the_force" : "which_column_is_the_acceleration",
               {{"columns", list}, {"option", request.column_option}}};
}

Result<void> check_even(const Series& series, double spacing, const DriveRequest& request) {
  for (std::size_t i = 0; i < series.t.size(); ++i) {
    const double even = series.t.front() + static_cast<double>(i) * spacing;
    if (std::abs(series.t[i] - even) > most_uneven * spacing)
      return Error{"times_not_even",
                   {{"line", series.lines[i]},
                    {"t", series.t[i]},
                    {"even", even},
                    {"spacing", spacing},
                    {"use", use_of(request)}}};
  }
  return {};
}

}  // namespace

Result<DriveRecord> drive_record(const Recording& recording, const DriveRequest& request,
                                 const ReadOptions& options) {
  const std::string& file = recording.file;
  const auto refuse = [&](const Notice& why) { return Error{in_file(file, why)}; };
  const std::vector<int> all = runs(recording);
  if (all.empty()) return refuse(Notice{"no_column_of_numbers"});
  const int run = request.run > 0 ? request.run : all.front();
  if (const auto known = check_run(recording, run); !known) return known.error();
  Result<std::string> name = std::string(request.column);
  if (name->empty()) name = drive_column(recording, run, request);
  if (!name) return refuse(name.error().notice);
  const auto series = take_series(recording, *name, run, options);
  if (!series) return series.error();

  if (!series->quantity.empty() && series->quantity != request.quantity)
    return refuse(Notice{wants_force(request) ? "column_holds_no_force" : "column_holds_no_acceleration",
                         {{"column", series->column},
                          {"kind", kind_of(series->quantity)},
                          {"option", request.column_option}}});
  if (series->t.size() < 2)
    return refuse(Notice{series->t.empty() ? "column_has_no_sample" : "column_has_one_sample",
                         {{"column", series->column}, {"use", use_of(request)}}});
  if (!series->gaps.empty())
    return refuse(Notice{series->gaps.size() == 1 ? "samples_have_a_gap" : "samples_have_gaps",
                         {{"gaps", series->gaps.size()},
                          {"length", series->gaps.front().length},
                          {"t", series->gaps.front().t},
                          {"use", use_of(request)}}});
  DriveRecord record;
  record.spacing = (series->t.back() - series->t.front()) / static_cast<double>(series->t.size() - 1);
  if (const auto even = check_even(*series, record.spacing, request); !even)
    return refuse(even.error().notice);
  record.values = series->y;
  record.column = series->column;
  record.motion = recording.motion;
  const auto target = parse_unit(wants_force(request) ? "N" : "m/s^2");
  const auto unit = parse_unit(series->unit, &target->dimension);
  record.unit_known = !series->unit.empty() && unit && unit->dimension == target->dimension;
  if (!series->unit.empty() && unit && !record.unit_known) {
    for (double& value : record.values) value /= series->to_si;
    record.notices.push_back(in_file(
        file,
        Notice{"unit_of_something_else",
               {{"unit", series->unit}, {"column", series->column}, {"kind", kind_of(request.quantity)}}}));
  }
  for (const auto* said : {&recording.notices, &series->notices})
    for (const Notice& notice : *said) record.notices.push_back(in_file(file, notice));
  if (all.size() > 1 && request.run == 0)
    record.notices.push_back(Notice{request.use == "drive" ? "drive_is_of_run" : "spectrum_is_of_run",
                                    {{"file", file}, {"run", run}, {"runs", all.size()}}});
  if (request.use == "drive" && std::abs(series->t.front()) > most_uneven * record.spacing)
    record.notices.push_back(
        Notice{"recording_starts_elsewhere", {{"file", file}, {"t", series->t.front()}}});
  return record;
}

}  // namespace cromer::core
