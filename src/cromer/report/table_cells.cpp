#include "cromer/report/table_cells.h"

#include <algorithm>

namespace cromer::core {

bool is_text(const TableBlock& table, std::size_t column) {
  return std::find(table.text_columns.begin(), table.text_columns.end(), static_cast<int>(column)) !=
         table.text_columns.end();
}

std::size_t columns_of(const TableBlock& table) {
  std::size_t columns = table.header.size();
  for (const auto& row : table.rows) columns = std::max(columns, row.size());
  return columns;
}

const std::string& cell(const TableBlock& table, std::size_t row, std::size_t column) {
  static const std::string empty;
  return column < table.rows[row].size() ? table.rows[row][column] : empty;
}

std::size_t rows_taken(const TableBlock& table, std::size_t row, std::size_t column) {
  if (column == 0 || !is_text(table, column) || cell(table, row, column).empty()) return 1;
  const std::string& text = cell(table, row, column);
  if (row > 0 && cell(table, row - 1, column) == text) return 0;
  std::size_t end = row + 1;
  while (end < table.rows.size() && cell(table, end, column) == text) ++end;
  return end - row;
}

std::string label_of(const TableBlock& table, int number) {
  return table.label.empty() ? "Table " + std::to_string(number) : table.label;
}

}  // namespace cromer::core
