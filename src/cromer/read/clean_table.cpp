// A recording as one clean table, whatever dialect it came in.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/concat.h"
#include "cromer/read/column_kind.h"
#include "cromer/read/columns.h"
#include "cromer/read/in_file.h"
#include "cromer/read/recording.h"
#include "cromer/read/time.h"

namespace cromer::core {

Result<Table> clean_table(const Recording& recording, const ReadOptions& options) {
  const Table& table = recording.table;
  Table clean;
  std::size_t longest = 0;
  const auto times = dialects::time_columns_of(table);
  for (const int run : runs(recording)) {
    // Columns follow their own time: two sensors sampled in turn keep two time columns.
    const std::size_t end = rows_of_run(table, run);
    std::vector<bool> done(table.columns.size(), false);
    for (std::size_t j = 0; j < table.columns.size(); ++j) {
      if (done[j] || table.columns[j].run != run || table.columns[j].quantity == "time") continue;
      const auto time = times[j];
      Column seconds{time ? table.columns[*time].name : "Time", "time", "s", run, {}};
      const double factor = time ? to_si(table.columns[*time]).factor : 1;
      std::vector<std::size_t> rows;
      std::vector<long> lines;
      for (std::size_t i = 0; i < end; ++i) {
        const double t =
            time ? table.columns[*time].values[i] * factor
                 : (options.rate > 0 ? static_cast<double>(i) / options.rate : static_cast<double>(i));
        if (!std::isfinite(t)) continue;
        rows.push_back(i);
        lines.push_back(line_of(recording, j, i));
        seconds.values.push_back(t);
      }
      const auto rising = dialects::keep_rising(seconds.values, lines);
      if (!rising) return in_file(recording.file, rising.error());
      std::vector<double> kept;
      for (const std::size_t i : rising->kept) kept.push_back(seconds.values[i]);
      seconds.values = kept;
      longest = std::max(longest, kept.size());
      if (time || options.rate > 0) clean.columns.push_back(std::move(seconds));
      for (std::size_t k = j; k < table.columns.size(); ++k) {
        const Column& column = table.columns[k];
        if (done[k] || column.run != run || column.quantity == "time" || times[k] != time) continue;
        done[k] = true;
        Column copy{column.name, column.quantity, column.unit, run, {}};
        for (const std::size_t i : rising->kept) copy.values.push_back(column.values[rows[i]]);
        clean.columns.push_back(std::move(copy));
      }
    }
  }
  for (Column& column : clean.columns)
    column.values.resize(longest, std::numeric_limits<double>::quiet_NaN());
  return clean;
}

std::string column_heading(const Table& table, std::size_t column) {
  const std::string title = column_title(table.columns[column]);
  const bool several = std::any_of(table.columns.begin(), table.columns.end(),
                                   [](const Column& other) { return other.run > 1; });
  return several ? concat({title, " Run #", std::to_string(table.columns[column].run)}) : title;
}

}  // namespace cromer::core
