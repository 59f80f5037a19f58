// Stage 5: the lines above the rows: names, units, runs, titles.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/read/cells.h"

namespace cromer::core::dialects {

/// One column's heading taken apart: `Position (mm) Run #1` is Position, mm, Run #1.
struct Heading {
  std::string name;
  std::string unit;
  std::string run;     ///< "Run #1", "Latest", "Data Set 2"; "" where the file names none
  std::string prefix;  ///< the run's label, if it stands in front with a colon (Logger Pro)
};
Heading parse_heading(std::string_view cell);

struct Header {
  std::vector<Heading> headings;    ///< one for each column, or none where the file has no header
  std::vector<std::string> titles;  ///< lines above the header, as they stand
  bool quoted = false;              ///< the names stood in quotes
  char separator = 0;               ///< of the header; may differ from the rows'
};

/// Reads the lines above the first row, whose index is `data`.
Header find_header(const std::vector<std::string_view>& lines, std::size_t data, const Layout& layout);

}  // namespace cromer::core::dialects
