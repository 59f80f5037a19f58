#include "cromer/report/paper_table.h"

#include <algorithm>
#include <numeric>

#include "cromer/report/palette.h"
#include "cromer/report/table_cells.h"

namespace cromer::core {
namespace {

// [px]
constexpr double column_gap = 18, cell_padding = 3.5, narrowest_words = 100;
constexpr double highest_strip = 320;  // rows that share a cell; a higher row is continued below
constexpr std::string_view row_line = "#DFE3E8";

struct ColumnNeed {
  double least = 0, most = 0;   // its longest word, its longest line
  double unbroken_numbers = 0;  // as `least`, but numbers are one word
  double broken_words = 0;      // numbers are one word, and long words are broken
};

/// Lines of each column, and whether the cell belongs to the one above.
struct PaperRow {
  struct Cell {
    std::vector<PaperLine> lines;
    bool continued = false;
  };
  std::vector<Cell> cells;
  bool ends = true;  // false: the rest of it is the next row
};

class PaperTable {
 public:
  PaperTable(const TableBlock& table, Typeface typeface, double width, double scale)
      : table_(table), columns_(columns_of(table)), width_(width) {
    head_ = {12 * scale, 16 * scale, light_surface.ink, typeface, true};
    number_ = {12.67 * scale, 17.5 * scale, light_surface.ink, typeface};
    words_ = {12.2 * scale, 17.5 * scale, light_surface.text_2, typeface};
    find_needs();
  }

  bool fits() const { return sum(&ColumnNeed::unbroken_numbers) <= room(); }

  std::vector<Strip> strips() {
    set_widths();
    for (std::size_t r = 0; r < table_.rows.size(); ++r) add_row(r);
    const std::shared_ptr<const Strip> header = header_strip();
    std::vector<Strip> strips;
    if (header) strips.push_back(*header);
    for (std::size_t from = 0; from < rows_.size();) {
      const std::size_t end = end_of_strip(from);
      strips.push_back(row_strip(from, end));
      strips.back().header = header;
      from = end;
    }
    if (header) strips.front().keeps_next = true;
    return strips;
  }

 private:
  Align align_of(std::size_t column) const { return is_text(table_, column) ? Align::left : Align::right; }

  TextStyle cell_style(std::size_t column) const {
    const bool answer = static_cast<int>(column) == table_.answer_column;
    TextStyle style = is_text(table_, column) && !answer && column > 0 ? words_ : number_;
    style.bold = answer;
    return style;
  }

  PaperText text_of(std::size_t row, std::size_t column) const {
    return {pieces_of(cell(table_, row, column)), cell_style(column)};
  }

  PaperText head_of(std::size_t column) const {
    static const std::string none;
    return {pieces_of(column < table_.header.size() ? table_.header[column] : none), head_};
  }

  void find_needs() {
    needs_.resize(columns_);
    for (std::size_t c = 0; c < columns_; ++c) {
      ColumnNeed& need = needs_[c];
      const PaperText head = head_of(c);
      need.least = need.unbroken_numbers = head.longest_word();
      need.most = head.width();
      for (std::size_t r = 0; r < table_.rows.size(); ++r) {
        const PaperText text = text_of(r, c);
        need.least = std::max(need.least, text.longest_word());
        need.most = std::max(need.most, text.width());
        if (!is_text(table_, c)) need.unbroken_numbers = std::max(need.unbroken_numbers, text.width());
      }
      if (is_text(table_, c))
        need.unbroken_numbers = std::max(need.least, std::min(need.most, narrowest_words));
      need.broken_words =
          is_text(table_, c) ? std::min(need.unbroken_numbers, narrowest_words) : need.unbroken_numbers;
    }
  }

  double room() const { return width_ - column_gap * static_cast<double>(columns_ - 1); }

  double sum(double ColumnNeed::*need) const {
    return std::accumulate(needs_.begin(), needs_.end(), 0.0,
                           [need](double all, const ColumnNeed& column) { return all + column.*need; });
  }

  /// What is left over is shared in proportion to what each column would still take.
  void share(double ColumnNeed::*have, double ColumnNeed::*want) {
    const double left = room() - sum(have), wanted = sum(want) - sum(have);
    for (std::size_t c = 0; c < columns_; ++c) {
      const double more = needs_[c].*want - needs_[c].*have;
      widths_[c] = needs_[c].*have + (wanted > 0 ? left * more / wanted : 0);
    }
  }

  void set_widths() {
    widths_.assign(columns_, 0);
    if (const double most = sum(&ColumnNeed::most); most > 0 && most <= room())
      for (std::size_t c = 0; c < columns_; ++c) widths_[c] = needs_[c].most * room() / most;
    else if (fits())
      share(&ColumnNeed::unbroken_numbers, &ColumnNeed::most);
    else if (sum(&ColumnNeed::broken_words) <= room())
      share(&ColumnNeed::broken_words, &ColumnNeed::unbroken_numbers);
    else if (sum(&ColumnNeed::least) <= room())
      share(&ColumnNeed::least, &ColumnNeed::most);
    else
      for (std::size_t c = 0; c < columns_; ++c)
        widths_[c] = needs_[c].least * room() / sum(&ColumnNeed::least);
    for (std::size_t c = 1; c < columns_; ++c) lefts_.push_back(lefts_.back() + widths_[c - 1] + column_gap);
  }

  /// Long cells are continued in further rows.
  void add_row(std::size_t row) {
    const auto most = static_cast<std::size_t>(highest_strip / number_.line_height);
    PaperRow whole;
    std::size_t longest = 1;
    for (std::size_t c = 0; c < columns_; ++c) {
      const std::vector<PaperLine> lines = text_of(row, c).lines(widths_[c]);
      whole.cells.push_back({lines, lines.size() <= most && rows_taken(table_, row, c) == 0});
      longest = std::max(longest, lines.size());
    }
    for (std::size_t from = 0; from < longest; from += most) {
      PaperRow part;
      for (const PaperRow::Cell& cell : whole.cells) {
        const std::size_t first = std::min(from, cell.lines.size());
        const std::size_t end = std::min(from + most, cell.lines.size());
        part.cells.push_back(
            {{cell.lines.begin() + first, cell.lines.begin() + end}, cell.continued && from == 0});
      }
      part.ends = from + most >= longest;
      rows_.push_back(std::move(part));
    }
  }

  static double height_of(const PaperRow::Cell& cell, const TextStyle& style) {
    return style.line_height * static_cast<double>(cell.lines.size()) + 2 * cell_padding;
  }

  bool is_continued(std::size_t row, std::size_t column) const {
    return row < rows_.size() && rows_[row].cells[column].continued;
  }

  /// Of the cells that are not shared.
  double height_of(std::size_t row) const {
    double height = number_.line_height + 2 * cell_padding;
    for (std::size_t c = 0; c < columns_; ++c)
      if (!is_continued(row, c) && !is_continued(row + 1, c))
        height = std::max(height, height_of(rows_[row].cells[c], cell_style(c)));
    return height;
  }

  bool shares_cells_with_above(std::size_t row) const {
    return std::any_of(rows_[row].cells.begin(), rows_[row].cells.end(),
                       [](const PaperRow::Cell& cell) { return cell.continued; });
  }

  std::size_t end_of_strip(std::size_t from) const {
    std::size_t end = from + 1;
    double height = height_of(from);
    for (; end < rows_.size() && shares_cells_with_above(end); ++end)
      if ((height += height_of(end)) > highest_strip) break;
    return end;
  }

  /// How far the cell of that row reaches down; the first row of a strip says again what it shares with the
  /// sheet before.
  std::size_t end_of_cell(std::size_t row, std::size_t column, std::size_t end) const {
    std::size_t below = row + 1;
    while (below < end && is_continued(below, column)) ++below;
    return below;
  }

  Strip row_strip(std::size_t from, std::size_t end) const {
    std::vector<double> tops{0};
    for (std::size_t r = from; r < end; ++r) tops.push_back(tops.back() + height_of(r));
    for (std::size_t c = 0; c < columns_; ++c)  // a shared cell may be higher than its rows
      for (std::size_t r = from; r < end; r = end_of_cell(r, c, end)) {
        const std::size_t last = end_of_cell(r, c, end) - from;
        const double lacking = height_of(rows_[r].cells[c], cell_style(c)) - (tops[last] - tops[r - from]);
        if (lacking > 0)
          for (std::size_t i = last; i < tops.size(); ++i) tops[i] += lacking;
      }
    Strip strip;
    strip.height = tops.back();
    for (std::size_t c = 0; c < columns_; ++c)
      for (std::size_t r = from; r < end; r = end_of_cell(r, c, end)) {
        const std::size_t below = end_of_cell(r, c, end);
        print_cell(strip, rows_[r].cells[c].lines, cell_style(c), c, tops[r - from], tops[below - from]);
        if (rows_[below - 1].ends && below < rows_.size()) {
          const double left = c == 0 ? 0 : lefts_[c] - column_gap;
          strip.printed.push_back(
              print_rule(left, tops[below - from] - 1, lefts_[c] + widths_[c] - left, row_line));
        }
      }
    if (from == 0 && table_.header.empty())
      strip.printed.push_back(print_rule(0, 0, width_, light_surface.ink));
    if (end == rows_.size())
      strip.printed.push_back(print_rule(0, strip.height - 1, width_, light_surface.ink));
    return strip;
  }

  void print_cell(Strip& strip, const std::vector<PaperLine>& lines, const TextStyle& style,
                  std::size_t column, double top, double bottom) const {
    double y = (top + bottom - style.line_height * static_cast<double>(lines.size())) / 2;
    for (const PaperLine& line : lines) {
      strip.printed.push_back(print_line(line, style, align_of(column), lefts_[column], y, widths_[column]));
      y += style.line_height;
    }
  }

  std::shared_ptr<const Strip> header_strip() const {
    if (table_.header.empty()) return nullptr;
    auto strip = std::make_shared<Strip>();
    std::vector<std::vector<PaperLine>> heads;
    for (std::size_t c = 0; c < columns_; ++c) {
      heads.push_back(head_of(c).lines(widths_[c]));
      strip->height = std::max(
          strip->height, head_.line_height * static_cast<double>(heads.back().size()) + 2 * cell_padding);
    }
    for (std::size_t c = 0; c < columns_; ++c) {
      const double height = head_.line_height * static_cast<double>(heads[c].size()) + 2 * cell_padding;
      print_cell(*strip, heads[c], head_, c, strip->height - height, strip->height);
    }
    strip->printed.push_back(print_rule(0, 0, width_, light_surface.ink));
    strip->printed.push_back(print_rule(0, strip->height - 1, width_, light_surface.ink));
    return strip;
  }

  const TableBlock& table_;
  std::size_t columns_;
  double width_;
  TextStyle head_, number_, words_;
  std::vector<ColumnNeed> needs_;
  std::vector<double> widths_, lefts_{0};
  std::vector<PaperRow> rows_;
};

}  // namespace

std::vector<Strip> table_strips(const TableBlock& table, Typeface typeface, double width) {
  if (columns_of(table) == 0) return {};
  const double full = typeface == Typeface::lato ? 1 : 0.93;
  for (const double scale : {1.0, 0.92, 0.85}) {
    PaperTable set(table, typeface, width, full * scale);
    if (set.fits()) return set.strips();
  }
  return PaperTable(table, typeface, width, 0.8 * full).strips();
}

}  // namespace cromer::core
