// A figure with every place worked out, in px, y downwards; the SVG only writes it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cromer/report/enhanced_text.h"
#include "cromer/report/figure.h"
#include "cromer/report/labels.h"

namespace cromer::core {

/// Sizes in pixels; the text's is a factor.
struct Canvas {
  double width, row_height, text_scale;
};

/// The canvas of a figure with so many rows of panels.
Canvas canvas_of(const Figure& figure, int rows);

/// a, b, ... z, aa, ab, ...
std::string letter_of(std::size_t panel);

/// The panels of each row; a panel is `span` columns wide.
std::vector<std::vector<std::size_t>> rows_of(const Figure& figure);

/// Font sizes of a figure [px].
struct TextSizes {
  double title = 13, name = 12, remark = 11, axis = 12, tick = 11.5;
};

enum class Align { left, centre, right };

struct PlacedText {
  std::string text;  ///< one line of enhanced text
  Spot at;           ///< its middle height, at the side `align` says
  Align align = Align::left;
  double size = 12;
  std::string colour;
  bool bold = false;
  bool rotated = false;  ///< reads upwards
  bool ground = false;   ///< stands on white, because it covers a curve
  Box box;               ///< its extent
};

struct PlacedLine {
  Spot from, to;
  std::string colour;
  double width = 0.8;
  std::array<double, 4> dash{};
};

struct PlacedCurve {
  Mark mark = Mark::line;
  std::vector<std::vector<Spot>> pieces;  ///< of a line; of dots: one piece
  Band band;
  std::vector<Spot> dots;  ///< on a line
  std::string colour;
  double width = 1.3;
  std::array<double, 4> dash{};
};

/// Of the ring around a named point [px].
inline constexpr double ring_radius = 4.5;

struct PlacedTick {
  double at = 0;  ///< [px]
  bool minor = false;
};

/// A map, sampled at every px of the frame, and its bar.
struct PlacedMap {
  int columns = 0, rows = 0;
  std::vector<double> values;  ///< 0 darkest to 1 lightest; columns run fastest, the lowest row first
  Box bar;
};

struct PlacedPanel {
  Box frame;
  std::vector<PlacedTick> x_ticks, y_ticks;
  std::vector<PlacedLine> zero_lines, leaders;
  std::vector<PlacedCurve> curves;  ///< lowest first
  std::vector<PlacedText> texts;
  std::vector<Spot> rings, dots;
  bool crowded = false;  ///< a name inside covers something, or its leader line crosses something
  std::optional<PlacedMap> map;
  bool bare = false;  ///< without axes
};

struct Layout {
  double width = 0, height = 0;
  std::vector<PlacedPanel> panels;
};

Layout lay_out(const Figure& figure, Typeface typeface, double smaller_by = 0);

}  // namespace cromer::core
