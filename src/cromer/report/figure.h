// A figure as data: panels of curves with a role, a name and a remark. Drawn by gnuplot in the look of this project.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cromer/base/result.h"

namespace cromer {

/// How a curve's points are drawn.
enum class Mark { line, dots, band };

/// One curve. `role` says what it means and with it its colour, width and dash (palette.h): "exact", "measured", "fitted", "forward-euler",
/// "euler-cromer", ... (any method's name), "constant-rate", "family:0" to "family:4" (one hue, dark to light), "drive".
struct Curve {
  std::vector<double> x, y;  ///< same length; NaN breaks the line
  std::string role;
  std::string name;    ///< the word at the curve; empty: none. May carry {/:Italic w}-like gnuplot enhanced markup
  std::string remark;  ///< what it does, under the name: "grows, -0.060 1/s"
  Mark mark = Mark::line;
  bool dashed = false;
  std::optional<double> label_x, label_y;  ///< where the word's leader line points to, in data units; by default the curve's end, outside at right
  std::optional<double> text_x, text_y;    ///< where the word stands when label_x is given, in graph fractions 0 to 1
};

/// A word in the plot with a leader line to a point; an extra mark.
struct Note {
  std::string text;
  double x = 0, y = 0;                   ///< the point, in data units
  double text_x = 0.5, text_y = 0.5;     ///< where the word stands, in graph fractions
  bool circle = false;                   ///< a ring about the point
  bool leader = true;
};

struct Axis {
  std::string name;  ///< with unit: "position x (cm)"; the italic symbol as {/:Italic x}
  double low = std::numeric_limits<double>::quiet_NaN();   ///< NaN: from the data
  double high = std::numeric_limits<double>::quiet_NaN();
  double step = 0;   ///< of the ticks; 0: chosen (1, 2, 2.5 or 5 times a power of ten)
  bool logarithmic = false;
};

struct Panel {
  std::string title;  ///< without the letter; letters are added where a figure has several panels
  Axis x, y;
  std::vector<Curve> curves;
  std::vector<Note> notes;
  bool phase_portrait = false;  ///< square, names inside
};

enum class FigureSize { single, wide, phase };  // 760 x 440, 1100 x 440, 480 x 440 per row

struct Figure {
  std::string id;       ///< file name without ending: "figure-01"
  std::string title;    ///< one line; also the alternative text on the page
  std::string caption;  ///< what is seen, with its numbers
  FigureSize size = FigureSize::single;
  std::vector<Panel> panels;
  int columns = 1;      ///< panels per row
};

/// The format is chosen by the ending.
enum class FigureFormat { svg, png, pdf };
Result<FigureFormat> figure_format(const std::string& path);

/// The gnuplot script that draws it on its standard output; pure.
std::string gnuplot_script(const Figure& figure, FigureFormat format);

/// Draws it with gnuplot (`gnuplot -d`, data in the script) and returns the picture's bytes. gnuplot missing or failing is an Error that says what to do.
Result<std::string> draw(const Figure& figure, FigureFormat format);

}  // namespace cromer
