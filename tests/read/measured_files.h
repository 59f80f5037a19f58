// Files that other people's loggers wrote, and what is in them.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace cromer::core {

/// What a file is known to hold: counted and read off in it by hand, beside what its author says of it.
struct Known {
  const char* file;
  double rate;                       ///< to give, 0 where the file has times
  const char* dialect;               ///< name, encoding, separator, decimal mark
  std::vector<std::string> columns;  ///< run, title, quantity, values that are there
  const char* column;                ///< to take
  std::vector<std::string> series;   ///< of each run: samples, rate, duration, gaps, outliers
  double first, last;                ///< values of run 1 in SI
  std::vector<std::string> notices;  ///< of the file, then of run 1
};

inline void PrintTo(const Known& known, std::ostream* out) { *out << known.file; }

std::vector<Known> measured_files();

}  // namespace cromer::core
