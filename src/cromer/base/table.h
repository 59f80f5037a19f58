// Named columns of numbers with their units: what readers return and what writers take.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace cromer::core {

/// One column. Missing values are NaN. All columns of a Table have the same length (shorter runs are padded).
struct Column {
  std::string name;      ///< as the file or the writer spells it, without unit and run: "Position"
  std::string quantity;  ///< time, position, angle, velocity, angular velocity, acceleration, force, voltage,
                         ///< index (a counter of rows); or ""
  std::string unit;      ///< as spelled: "mm", "m/s²"; "" where the file says none
  int run = 1;           ///< runs side by side are numbered from 1
  std::vector<double> values;
};

struct Table {
  std::vector<Column> columns;

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
};

}  // namespace cromer::core
