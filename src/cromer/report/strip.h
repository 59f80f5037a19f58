// What is laid on sheets of paper: strips across the column that are never cut.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cromer/report/paper_text.h"
#include "cromer/report/thinning.h"

namespace cromer::core {

/// Text, a figure, or the rules and grounds behind them. The SVG is that of a box at 0, 0.
struct Printed {
  enum class Kind { text, figure, ground };
  Kind kind = Kind::text;
  Box box;  ///< [px]
  std::string svg;
};

struct Strip {
  double space = 0;  ///< above it, unless it is the first on its sheet [px]
  double height = 0;
  std::vector<Printed> printed;  ///< from the strip's upper left corner
  bool keeps_next = false;       ///< the next strip stands on the same sheet
  /// Stands above the strip where that is the first on its sheet: the header of a table.
  std::shared_ptr<const Strip> header{};
};

inline void keep_together(std::vector<Strip>& strips) {
  for (std::size_t i = 0; i + 1 < strips.size(); ++i) strips[i].keeps_next = true;
}

/// A line of the text at `x`, `y` in a room of that width.
Printed print_line(const PaperLine& line, const TextStyle& style, Align align, double x, double y,
                   double width);

/// A line across, its upper edge at `y`.
Printed print_rule(double x, double y, double width, std::string_view colour, double thickness = 1);

/// Texts beside each other, a strip for each line. No line stands alone.
struct TextColumn {
  PaperText text;
  double x = 0, width = 0;
};
std::vector<Strip> text_strips(const std::vector<TextColumn>& columns, const TextStyle& style, double space);

/// "**Figure 1.** What is seen."
std::vector<Piece> captioned(const std::string& label, const std::string& caption);

}  // namespace cromer::core
