// What HTML and paper ask of a table alike.
#pragma once

#include <cstddef>
#include <string>

#include "cromer/report/page.h"

namespace cromer::core {

/// Whether the column holds words.
bool is_text(const TableBlock& table, std::size_t column);

/// Of the longest row.
std::size_t columns_of(const TableBlock& table);

/// Empty where a row is shorter.
const std::string& cell(const TableBlock& table, std::size_t row, std::size_t column);

/// How many rows a cell spans; 0 if the cell above spans it.
std::size_t rows_taken(const TableBlock& table, std::size_t row, std::size_t column);

/// "Table 3", or the table's own.
std::string label_of(const TableBlock& table, int number);

}  // namespace cromer::core
