#include "cromer/documents/csv/recording.h"

#include <span>
#include <vector>

#include "cromer/read/recording.h"
#include "cromer/report/csv.h"

namespace cromer::core {

Result<std::string> recording_csv(const Recording& recording, const ReadOptions& options) {
  const auto table = clean_table(recording, options);
  if (!table) return table.error();
  std::vector<CsvColumn> cells;
  for (std::size_t i = 0; i < table->columns.size(); ++i)
    cells.push_back({column_heading(*table, i), std::span<const double>(table->columns[i].values)});
  std::string out;
  append_csv(out, cells, {}, true);
  return out;
}

}  // namespace cromer::core
