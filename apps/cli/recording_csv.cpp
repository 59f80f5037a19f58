#include "recording_csv.h"

#include <fmt/format.h>

#include <algorithm>

#include "cromer/model/sensor.h"
#include "cromer/report/csv.h"

namespace cromer::cli {

std::string column_header(const Column& column, bool with_run) {
  std::string header = column.name;
  if (!column.unit.empty()) header += " (" + column.unit + ")";
  if (with_run) header += fmt::format(" Run #{}", column.run);
  return header;
}

std::string recording_csv(const Inspection& inspection, double rate) {
  const auto& columns = inspection.recording.table.columns;
  const bool several = std::any_of(columns.begin(), columns.end(), [](const Column& c) { return c.run > 1; });
  std::vector<double> times;
  std::vector<CsvColumn> cells;
  const bool timed =
      std::any_of(columns.begin(), columns.end(), [](const Column& c) { return c.quantity == "time"; });
  if (!timed && rate > 0) {
    for (std::size_t i = 0; i < inspection.recording.table.rows(); ++i)
      times.push_back(to_15_digits(static_cast<double>(i) / rate));
    cells.push_back({"Time (s)", std::span<const double>(times)});
  }
  for (const auto& column : columns)
    cells.push_back({column_header(column, several), std::span<const double>(column.values)});
  std::string out;
  append_csv(out, cells, {}, true);
  return out;
}

}  // namespace cromer::cli
