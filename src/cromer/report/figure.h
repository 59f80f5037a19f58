// A figure as data: panels of curves with a role, a name and a remark.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cromer/result.h"

namespace cromer::core {

/// How a curve's points are drawn. Dots too dense to be told apart become a band; a band that is not dense
/// becomes a line. Crosses outside the frame stand at its edge.
enum class Mark { line, dots, band, crosses };

/// One curve. `role` is its meaning, which sets its colour, width and dash (palette.h): "exact", "measured",
/// "fitted", "forward-euler", "euler-cromer", ... (any method's name), "constant-rate", "family:0" to
/// "family:4" (one hue, dark to light; family_role()), "drive".
struct Curve {
  std::vector<double> x, y;  ///< same length; NaN breaks the line
  std::string role;
  std::string name;    ///< the word at the curve; empty: none. May carry the markup of
                       ///< enhanced_text.h; "\n" breaks it
  std::string remark;  ///< what it does, under the name: "grows, -0.060 1/s"
  std::string
      remark_outside{};  ///< of crosses: added to the remark where some of them stand at the frame's edge
  Mark mark = Mark::line;
  bool always_dots = false;  ///< of dots: however dense, as a line runs through them
  bool dashed = false;
  bool with_dots =
      false;          ///< dots on the line: of points so few that each is to be seen. Points alone always are
  bool road = false;  ///< wide, as the exact solution always is: others stay on it or leave it
  bool sets_axes = true;  ///< the range of the vertical axis includes it
  /// The point that the name's leader line points to, in data units. Without label_y it is the curve's own
  /// height at label_x. Without label_x the name stands outside at the right, or, with names inside, in a
  /// free place near the curve.
  std::optional<double> label_x, label_y;
  std::optional<double> text_x,
      text_y;  ///< where the word stands, in graph fractions 0 to 1; by default a free place near the point
};

/// A word in the plot with a leader line to a point; an extra mark.
struct Note {
  std::string text;                   ///< "\n" breaks it
  double x = 0, y = 0;                ///< the point, in data units
  double text_x = 0.5, text_y = 0.5;  ///< where the word stands, in graph fractions
  bool circle = false;                ///< a ring about the point
  bool leader = true;
  bool dot = false;  ///< a dot at the point
};

/// A vertical line through the panel with a word at its top: a drive frequency, the end of a segment.
struct Marker {
  double x = 0;
  std::string text;
  std::string role = "drive";
};

struct Axis {
  std::string name;  ///< with unit: "position x (cm)"; the italic symbol as {/:Italic x}
  double low = std::numeric_limits<double>::quiet_NaN();  ///< NaN: from the data
  double high = std::numeric_limits<double>::quiet_NaN();
  double step = 0;  ///< of the ticks; 0: chosen (1, 2, 2.5 or 5 times a power of ten)
  bool logarithmic = false;
  bool decimal_comma = false;  ///< in its numbers
};

/// A quantity over two others, as colour from dark (low) to light, with a colour bar.
struct HeatMap {
  std::vector<double> x, y;  ///< of the cells' middles: at least two of each, all rising or all falling
  std::vector<double> z;     ///< x runs fastest; NaN is left blank
  std::string name;          ///< of z, with unit: "amplitude (cm)"
  std::vector<double>
      reach{};  ///< further values that the colours include, so that maps side by side share their colours
  bool decades =
      false;  ///< logarithmic colours, if z is positive and its largest is more than 20 times its smallest
};

struct Panel {
  std::string title;  ///< without the letter; letters are added where a figure has several panels
  Axis x, y;
  std::vector<Curve> curves;
  std::vector<Note> notes;
  bool phase_portrait = false;  ///< square, names inside
  std::vector<Marker> markers;
  int span = 1;               ///< how many of the figure's columns it takes
  bool names_inside = false;  ///< names in free places of the plot instead of the right margin
  /// Names in a list beside the plot, in the order of the curves. More than six names are listed in any case,
  /// and so are names inside if one of them finds no clear place.
  bool names_listed = false;
  std::optional<HeatMap> map{};  ///< in place of curves
  bool bare = false;             ///< a drawing: without axes
};

/// 760 x 440, 1100 x 440, 480 x 440 px, and, for half the report's column with names inside, 420 x 300 px
/// (tall: 420 x 385, as high as a phase portrait there). With several rows a row is 300 px high (phase: 440).
/// A figure of phase portraits is 480 px wide per column.
enum class FigureSize { single, wide, phase, half, tall };

struct Figure {
  std::string id;       ///< file name without ending: "figure-01"
  std::string title;    ///< one line; also the alternative text on the page
  std::string caption;  ///< what is seen, with its numbers
  FigureSize size = FigureSize::single;
  std::vector<Panel> panels;
  int columns = 1;           ///< panels per row
  std::vector<Curve> key{};  ///< without points: their looks and names stand in a row under the panels
  std::string note;          ///< one line under the panels; "" none
  bool shared_x = false;     ///< only the lowest row writes the numbers and the name of its x axis
};

/// The format is chosen by the ending.
enum class FigureFormat { svg, png, pdf };
Result<FigureFormat> figure_format(const std::string& path);

/// The bytes of the picture. An SVG can stand in a page as it is. PNG and PDF need librsvg; an Error says so
/// if it is missing.
Result<std::string> draw(const Figure& figure, FigureFormat format);

}  // namespace cromer::core
