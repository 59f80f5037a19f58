// Stages 2 and 3: text to lines, lines to cells, cells to numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/notice.h"
#include "cromer/result.h"

namespace cromer::core::dialects {

/// The lines of a text without their ends: LF, CR LF, or CR in a text without LF. Line i of the file is
/// lines[i - 1]. The last one is empty, unless the text ends without a line end.
std::vector<std::string_view> split_lines(std::string_view text);

/// A line to skip among data: nothing but blanks, or a comment (# or %).
bool is_blank(std::string_view line);
bool is_comment(std::string_view line);

/// Wider tables are refused: each column costs memory, even if it takes one byte of the file.
constexpr std::size_t most_columns = 2000;

/// How rows are written. Blanks (' ') stand for any run of spaces and tabs; 0: one value a line.
struct Layout {
  char separator = ',';  // , ; \t ' ' or 0
  char decimal = '.';    // . or ,
  std::size_t columns = 1;
  /// Commas both separate and mark decimals, without quotes: each value has a decimal comma.
  bool paired = false;
  /// The columns that hold text (labels, remarks) and are left out; empty where none does.
  std::vector<bool> text{};

  bool is_text(std::size_t column) const { return column < text.size() && text[column]; }
};

Error too_many_columns();

/// Whether the commas of a line fit this layout. Where they are paired, a whole number without a decimal
/// comma would shift all cells that follow.
bool commas_pair_up(std::string_view line, const Layout& layout);

/// Takes the cells of a line one by one. Quotes are taken off; blanks around a cell too.
class CellReader {
 public:
  CellReader(std::string_view line, const Layout& layout);

  /// The next cell; false at the end of the line.
  bool next(std::string_view& cell);

  /// The usual case, made fast: takes the next cell if it is a plain number up to the separator. Else takes
  /// nothing, and next() decides.
  bool next_number(double& value);

 private:
  std::size_t cell_end() const;

  std::string_view rest_;
  char separator_;
  char decimal_;
  bool paired_;  ///< two pieces make one cell
  bool more_ = true;
};

/// The cells of a line, at most one more than most_columns; `cells` is reused.
void split_cells(std::string_view line, const Layout& layout, std::vector<std::string_view>& cells);

enum class CellKind { number, missing, word };
struct Cell {
  CellKind kind = CellKind::missing;
  double value = 0;  ///< NaN unless a number
};

/// Empty cells, NaN, null, inf and dashes are missing. All else is a word, unless the whole cell is a finite
/// number.
Cell read_cell(std::string_view cell, char decimal);

/// A cell as it is shown to people: short, and without control characters.
std::string shown(std::string_view cell);

/// Says what a cell is that is not a number, and the cure: a clock time, a number with thousands separators,
/// a date, Fortran's D exponents, a number beyond the doubles, the other decimal mark. Empty if it is none of
/// these.
Notice bad_cell(std::string_view cell, char decimal);

}  // namespace cromer::core::dialects
