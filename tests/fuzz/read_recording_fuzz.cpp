// Any bytes must end in a recording or an Error: no crash, no hang, no memory without bound.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "cromer/record/dialects/clean_table.h"
#include "cromer/study/task/inspect.h"

/// The first byte chooses the options, the rest is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cromer;
  if (size == 0) return 0;
  const unsigned choice = data[0];
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  ReadOptions options;
  options.skip_bad_rows = (choice & 1u) != 0;
  if (choice & 2u) options.rate = 100;
  if (choice & 4u) options.decimal = ",";
  if (choice & 8u) options.delimiter = ",";
  if (choice & 16u) options.time_column = "t";
  const auto inspection = inspect(bytes, "fuzz.csv", options);
  if (!inspection) return 0;
  (void)clean_table(inspection->recording, options);
  for (const int run : runs(inspection->recording))
    (void)take_series(inspection->recording, "x", run, options);
  return 0;
}
