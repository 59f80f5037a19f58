// Any bytes must end in a recording or an Error: no crash, no hang, no memory without bound, no nonsense.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "cromer/read/recording.h"
#include "cromer/tasks/inspect/inspect.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

void check_table(const cromer::core::Table& table) {
  for (const cromer::core::Column& column : table.columns) {
    require(column.values.size() == table.rows());
    require(column.run >= 1);
    for (const double value : column.values) require(!std::isinf(value));
  }
}

void check_series(const cromer::core::Series& series) {
  require(series.t.size() < 2 || (series.rate > 0 && std::isfinite(series.rate)));
  require(series.t.size() == series.y.size() && series.t.size() == series.lines.size());
  for (std::size_t i = 0; i < series.t.size(); ++i) {
    require(std::isfinite(series.t[i]) && std::isfinite(series.y[i]));
    require(i == 0 || series.t[i] > series.t[i - 1]);
    require(series.lines[i] > 0);
  }
}

}  // namespace

/// The first byte chooses the options, the rest is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cromer::core;
  if (size == 0) return 0;
  const unsigned choice = data[0];
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  cromer::ReadOptions options;
  options.skip_bad_rows = (choice & 1u) != 0;
  if (choice & 2u) options.rate = 100;
  if (choice & 4u) options.decimal = ",";
  if (choice & 8u) options.delimiter = ",";
  if (choice & 16u) options.time_column = "t";
  auto recording = read_recording(bytes, choice & 32u ? "fuzz.AT2" : "fuzz.csv", options);
  if (!recording) return 0;
  const auto inspection = inspect(*std::move(recording), options);
  if (!inspection) return 0;
  check_table(inspection->recording.table);
  for (const Series& series : inspection->series) check_series(series);
  if (const auto clean = clean_table(inspection->recording, options)) check_table(*clean);
  for (const int run : runs(inspection->recording))
    if (const auto series = take_series(inspection->recording, "x", run, options)) check_series(*series);
  return 0;
}
