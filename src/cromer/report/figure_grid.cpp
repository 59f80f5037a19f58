#include "cromer/report/figure_grid.h"

#include <algorithm>

namespace cromer::core {
namespace {

constexpr double row_of_several = 310;
constexpr double wide_text = 1.15;  // a wide figure is shown smaller on the page

}  // namespace

Canvas canvas_of(const Figure& figure, int rows) {
  const int columns = std::max(1, figure.columns);
  switch (figure.size) {
    case FigureSize::single:
      return {760, rows > 1 ? row_of_several : 440, 1};
    case FigureSize::wide:
      return {1100, rows > 1 ? row_of_several : 440, wide_text};
    case FigureSize::phase:
      return {480.0 * columns, 440, 1};
    case FigureSize::half:
      return {420, rows > 1 ? 230.0 : 300.0, 1};
    case FigureSize::tall:
      return {420, rows > 1 ? 230.0 : 385.0, 1};
  }
  return {760, 440, 1};
}

std::string letter_of(std::size_t panel) {
  std::string letter;
  for (std::size_t n = panel + 1; n > 0; n = (n - 1) / 26)
    letter.insert(letter.begin(), static_cast<char>('a' + (n - 1) % 26));
  return letter;
}

std::vector<std::vector<std::size_t>> rows_of(const Figure& figure) {
  std::vector<std::vector<std::size_t>> rows;
  const int columns = std::max(1, figure.columns);
  int used = columns;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const int span = std::clamp(figure.panels[i].span, 1, columns);
    if (used + span > columns) {
      rows.emplace_back();
      used = 0;
    }
    rows.back().push_back(i);
    used += span;
  }
  return rows;
}

}  // namespace cromer::core
