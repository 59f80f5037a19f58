#include "cromer/report/svg.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "cromer/report/enhanced_text.h"
#include "cromer/report/heat_map.h"
#include "cromer/report/html_text.h"
#include "cromer/report/palette.h"
#include "cromer/report/thinning.h"

namespace cromer::core {
namespace {

constexpr double tick_length = 4.9, minor_tick_length = 2.4;  // [px]
constexpr double ring_width = 1.3, dot_radius = 2.6;          // [px]
constexpr double dots_on_a_line = 5.2;                        // [px] across
constexpr double band_opacity = 0.2;
constexpr double ground_edge = 2;                // [px] at either side of a word
constexpr double baseline_below_middle = 0.325;  // font sizes
constexpr int colours_of_a_bar = 255;

std::string number(double value) {
  std::string text = fmt::format("{:.2f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string place(Spot p) { return number(p.x) + ' ' + number(p.y); }

/// After M, each further pair is a line.
std::string line_path(const std::vector<Spot>& spots) {
  std::string path;
  for (const Spot& p : spots) path += (path.empty() ? "M" : " ") + place(p);
  return path;
}

/// A line of no length, whose round ends are a dot.
std::string dot_path(const std::vector<Spot>& spots, const Box& frame) {
  std::string path;
  for (const Spot& p : spots)
    if (inside(p, frame)) path += "M" + place(p) + "h0";
  return path;
}

std::string dash_attribute(const std::array<double, 4>& dash) {
  std::string list;
  for (std::size_t i = 0; i < dash.size() && dash[i] > 0; ++i)
    list += (list.empty() ? "" : " ") + number(dash[i]);
  return list.empty() ? "" : " stroke-dasharray=\"" + list + "\"";
}

class Svg {
 public:
  std::string document(const Layout& layout, std::string_view alternative_text,
                       std::string_view font_family) {
    const std::string width = number(layout.width), height = number(layout.height);
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "role=\"img\" aria-label=\"{2}\" font-family=\"{3}\" stroke-linejoin=\"round\" fill=\"none\" "
        "xml:space=\"preserve\">\n",  // else librsvg leaves out a blank after an exponent
        width, height, escaped(alternative_text), font_family);
    rectangle({0, 0, layout.width, layout.height});
    for (const PlacedPanel& each : layout.panels) panel(each);
    add("</svg>\n");
    return well_formed(std::move(out_));
  }

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> text, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), text, std::forward<Args>(args)...);
  }

  void panel(const PlacedPanel& panel) {
    grid(panel);
    axes(panel);
    for (const PlacedLine& zero : panel.zero_lines) line(zero);
    if (panel.map) image(panel.map->values, panel.map->columns, panel.map->rows, panel.frame);
    for (const PlacedCurve& each : panel.curves) curve(each, panel.frame);
    if (panel.map) bar(panel.map->bar);
    for (const PlacedLine& leader : panel.leaders) line(leader);
    for (const Spot& p : panel.rings)
      add("<circle stroke=\"{}\" stroke-width=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", light_surface.ink,
          ring_width, number(p.x), number(p.y), ring_radius);
    for (const Spot& p : panel.dots)
      add("<circle fill=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", light_surface.ink, number(p.x), number(p.y),
          dot_radius);
    for (const PlacedText& each : panel.texts)
      if (each.ground) ground(each.box);
    for (const PlacedText& each : panel.texts) text(each);
  }

  void grid(const PlacedPanel& panel) {
    const Box& f = panel.frame;
    std::string path;
    for (const PlacedTick& tick : panel.y_ticks)
      if (!tick.minor) path += line_path({{f.x, tick.at}, {f.right(), tick.at}});
    for (const PlacedTick& tick : panel.x_ticks)
      if (!tick.minor) path += line_path({{tick.at, f.bottom()}, {tick.at, f.y}});
    stroke(light_surface.grid, 0.7, "", path);
  }

  /// Ticks point outwards; the frame has only its left and its lower line.
  void axes(const PlacedPanel& panel) {
    const Box& f = panel.frame;
    const auto length = [](const PlacedTick& tick) { return tick.minor ? minor_tick_length : tick_length; };
    std::string path;
    for (const PlacedTick& tick : panel.y_ticks)
      path += line_path({{f.x, tick.at}, {f.x - length(tick), tick.at}});
    for (const PlacedTick& tick : panel.x_ticks)
      path += line_path({{tick.at, f.bottom()}, {tick.at, f.bottom() + length(tick)}});
    if (!panel.bare) path += line_path({{f.x, f.y}, {f.x, f.bottom()}, {f.right(), f.bottom()}});
    stroke(light_surface.axis, 0.8, "", path);
  }

  void stroke(std::string_view colour, double width, const std::string& more, const std::string& path) {
    if (path.empty()) return;
    add("<path stroke=\"{}\" stroke-width=\"{}\"{} d=\"{}\"/>\n", colour, number(width), more, path);
  }

  void line(const PlacedLine& line) {
    stroke(line.colour, line.width, dash_attribute(line.dash), line_path({line.from, line.to}));
  }

  void curve(const PlacedCurve& curve, const Box& frame) {
    if (curve.mark == Mark::band)
      band(band_inside(curve.band, frame), curve.colour);
    else if (curve.mark == Mark::dots)
      for (const auto& piece : curve.pieces) dots(piece, curve, curve.width, frame);
    else
      lines(curve, frame);
  }

  void lines(const PlacedCurve& curve, const Box& frame) {
    std::string path;
    for (const auto& piece : curve.pieces)
      for (const auto& seen : pieces_inside(piece, frame)) path += line_path(seen);
    stroke(curve.colour, curve.width, dash_attribute(curve.dash), path);
    dots(curve.dots, curve, dots_on_a_line, frame);
  }

  void dots(const std::vector<Spot>& spots, const PlacedCurve& curve, double width, const Box& frame) {
    stroke(curve.colour, width, " stroke-linecap=\"round\"", dot_path(spots, frame));
  }

  /// A polygon for each piece: along the low edge and back along the high one.
  void band(const Band& band, const std::string& colour) {
    std::vector<Spot> low, high;
    for (std::size_t i = 0; i <= band.x.size(); ++i) {
      const bool ends = i == band.x.size() || std::isnan(band.x[i]);
      if (!ends) {
        low.push_back({band.x[i], band.low[i]});
        high.push_back({band.x[i], band.high[i]});
        continue;
      }
      low.insert(low.end(), high.rbegin(), high.rend());
      if (low.size() > 2) polygon(low, colour);
      low.clear(), high.clear();
    }
  }

  void polygon(const std::vector<Spot>& corners, const std::string& colour) {
    add("<polygon fill=\"{}\" fill-opacity=\"{}\" points=\"{}\"/>\n", colour, band_opacity,
        line_path(corners).substr(1));
  }

  void bar(const Box& box) {
    std::vector<double> values;
    for (int i = 0; i < colours_of_a_bar; ++i) values.push_back(i / (colours_of_a_bar - 1.0));
    image(values, 1, colours_of_a_bar, box);
  }

  /// Inside the file; sharp at every size.
  void image(const std::vector<double>& values, int columns, int rows, const Box& box) {
    if (values.empty()) return;
    add("<image style=\"image-rendering:pixelated\" preserveAspectRatio=\"none\"");
    corners(box);
    add(" href=\"data:image/png;base64,{}\"/>\n", base64(map_png(values, columns, rows)));
  }

  void corners(const Box& box) {
    add(" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", number(box.x), number(box.y), number(box.width),
        number(box.height));
  }

  void rectangle(const Box& box) {
    add("<rect fill=\"{}\"", light_surface.ground);
    corners(box);
    add("/>\n");
  }

  void ground(const Box& box) {
    rectangle({box.x - ground_edge, box.y, box.width + 2 * ground_edge, box.height});
  }

  void text(const PlacedText& text) {
    if (without_markup(text.text).empty()) return;
    add("<text{} fill=\"{}\" font-size=\"{}\"{}{}>", where(text), text.colour, number(text.size),
        text.bold ? " font-weight=\"bold\"" : "", anchor(text));
    double rise = 0;
    for (const TextRun& run : runs_of(text.text)) {
      span(run, text.size, rise);
      rise = run.rise;
    }
    add("</text>\n");
  }

  /// On a ground of its own a text stands in the middle: fonts differ in width, the ground is made for the
  /// widest.
  static std::string anchor(const PlacedText& text) {
    const Align side = text.ground ? Align::centre : text.align;
    if (side == Align::left) return "";
    return side == Align::right ? " text-anchor=\"end\"" : " text-anchor=\"middle\"";
  }

  static std::string where(const PlacedText& text) {
    const double x = text.ground ? (text.box.x + text.box.right()) / 2 : text.at.x;
    const double down = baseline_below_middle * text.size;
    if (text.rotated)
      return fmt::format(" transform=\"translate({}) rotate(-90)\"", place({x + down, text.at.y}));
    return fmt::format(" x=\"{}\" y=\"{}\"", number(x), number(text.at.y + down));
  }

  /// `rise` is that of the run before: dy counts from there.
  void span(const TextRun& run, double size, double rise) {
    std::string style;
    if (run.italic) style += " font-style=\"italic\"";
    if (run.bold) style += " font-weight=\"bold\"";
    if (run.size != 1) style += " font-size=\"" + number(run.size * size) + '"';
    if (run.rise != rise) style += " dy=\"" + number((rise - run.rise) * size) + '"';
    const std::string words = escaped(run.text);
    out_ += style.empty() ? words : "<tspan" + style + '>' + words + "</tspan>";
  }

  std::string out_;
};

}  // namespace

std::string to_svg(const Layout& layout, std::string_view alternative_text, std::string_view font_family) {
  return Svg().document(layout, alternative_text, font_family);
}

}  // namespace cromer::core
