// W5: a two-column CSV of 217 MB, from bytes in memory to columns with names, units and line numbers. Prints
// lines of tab-separated "row, who, seconds"; with a file's name it also writes the CSV there, for the peers.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "bench/stopwatch.h"
#include "cromer/base/quantity.h"
#include "cromer/read/recording.h"

namespace {

/// A decaying swing at 100 Hz with 17 digits, as a simulation writes it, until the text has so many bytes.
std::string swing(std::size_t bytes) {
  std::string text = "Time (s),Position (m)\n";
  text.reserve(bytes + 64);
  for (long n = 0; text.size() < bytes; ++n) {
    const double t = static_cast<double>(n) / 100;
    text += cromer::core::shortest(t);
    text += ',';
    text += cromer::core::shortest(0.3 + 0.05 * std::exp(-1e-5 * t) * std::cos(6 * t));
    text += '\n';
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string text = swing(217'000'000);
  if (argc > 1) std::ofstream(argv[1], std::ios::binary) << text;
  std::size_t rows = 0;
  const std::vector<std::function<void()>> works{[&] {
    const auto recording = cromer::core::read_recording(text, "swing.csv", {});
    if (!recording) std::abort();
    rows = recording->lines.size();
  }};
  const double seconds = cromer::core::bench::medians(works, argc > 2 ? std::atoi(argv[2]) : 5).front();
  std::printf("reading %.0f MB of CSV, %zu rows\tcromer\t%.9g\n", static_cast<double>(text.size()) / 1e6,
              rows, seconds);
  std::fprintf(stderr, "%.0f MB/s\n", static_cast<double>(text.size()) / seconds / 1e6);
}
