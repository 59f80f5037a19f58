// Recorded ground motions and tables that others published, where the folder is there.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/tasks/of_bytes.h"

#include "tests/support/bytes_of.h"

namespace cromer::core::test {

inline const std::string shared = CROMER_SOURCE_DIR "/../shared/data/";

inline SpectrumFile ground_motion(const std::string& name) {
  return {name, bytes_of(shared + "ground-motion/" + name)};
}

/// The rows of numbers of a comma-separated table, other lines left out.
inline std::vector<std::vector<double>> number_rows(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] < '0' || line[0] > '9') continue;
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
  }
  return rows;
}

/// "0.01,0.02,...": column `i` as a list of values.
inline std::string list_of(const std::vector<std::vector<double>>& rows, std::size_t i) {
  std::ostringstream list;
  list.precision(17);
  for (const auto& row : rows) list << (&row == &rows.front() ? "" : ",") << row[i];
  return list.str();
}

}  // namespace cromer::core::test
