#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "cromer/report/figure.h"
#include "cromer/report/layout.h"
#include "cromer/report/palette.h"

// The layout is written in px with y upwards: gnuplot draws, it decides nothing.
namespace cromer {
namespace {

// How a terminal's units relate to the px of the layout (measured with gnuplot 5.4).
struct Terminal {
  double dash_unit;   // px per unit of `dt` and per unit of line width
  double point_size;  // of `pt 7` for a dot of radius 1.3 px; in SVG tidy_svg gives it its size
};

Terminal terminal_of(FigureFormat format) {
  switch (format) {
    case FigureFormat::svg:
      return {0.5, 0.25};
    case FigureFormat::png:
      return {0.25, 0.64};
    case FigureFormat::pdf:
      return {0.283, 0.2};
  }
  return {0.5, 0.25};
}

// A single-quoted gnuplot string. Apostrophe and backquote become their typographic forms: neither can end
// the string or hand a command to the shell (gnuplot 5.4 reads a doubled apostrophe at a string's start as
// its end).
std::string quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'')
      out += "’";
    else if (c == '`')
      out += "‘";
    else
      out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return out += '\'';
}

class Script {
 public:
  Script(const Layout& layout, FigureFormat format, std::string_view font)
      : layout_(layout), format_(format), font_(font) {}

  std::string write() {
    terminal();
    line("set encoding utf8");
    line("set minussign");
    line("unset key");
    line("set border 3 back lc rgb '{}' lw 0.8", light_surface.axis);
    line("set tics nomirror out scale 0.5,0.25");
    line("set grid xtics ytics nomxtics nomytics back lt 1 lc rgb '{}' lw 0.7 dt solid", light_surface.grid);
    line("set clip two");  // a segment that crosses the frame is drawn even if both its ends lie outside
    line("set multiplot");
    for (std::size_t i = 0; i < layout_.panels.size(); ++i) panel(layout_.panels[i], i);
    line("unset multiplot");
    return std::move(out_);
  }

 private:
  template <class... Args>
  void line(fmt::format_string<Args...> text, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), text, std::forward<Args>(args)...);
    out_ += '\n';
  }

  void terminal() {
    const double w = layout_.width, h = layout_.height;
    switch (format_) {
      case FigureFormat::svg:
        line("set terminal svg size {:.0f},{:.0f} enhanced font 'sans-serif,13' background '#ffffff'", w, h);
        break;
      case FigureFormat::png:  // twice the px; a point is 4/3 px
        line(
            "set terminal pngcairo size {:.0f},{:.0f} enhanced font '{},13' fontscale 1.5 linewidth 2 "
            "rounded background '#ffffff'",
            2 * w, 2 * h, font_);
        break;
      case FigureFormat::pdf:  // a px is 3/4 pt; gnuplot's line width unit is half a pt
        line(
            "set terminal pdfcairo size {:.4f}in,{:.4f}in enhanced font '{},13' fontscale 0.5625 linewidth "
            "1.5 rounded background '#ffffff'",
            w / 96, h / 96, font_);
        break;
    }
  }

  double up(double y) const { return layout_.height - y; }

  /// `drawn`: a curve or a line.
  template <class Drawn>
  std::string dash_type(const Drawn& drawn) const {
    if (drawn.dash[0] == 0) return "solid";
    const double unit = terminal_of(format_).dash_unit * drawn.width;
    // Rounded ends make a dash longer by the line's width and the gap shorter.
    const double end = format_ == FigureFormat::svg ? 0 : 0.8 * drawn.width;
    std::string text = "(";
    for (std::size_t i = 0; i < drawn.dash.size() && drawn.dash[i] > 0; ++i) {
      const double px = std::max(0.2, drawn.dash[i] + (i % 2 == 0 ? -end : end));
      fmt::format_to(std::back_inserter(text), "{}{:.3g}", i > 0 ? "," : "", px / unit);
    }
    return text + ")";
  }

  void ticks(char axis, const std::vector<PlacedTick>& ticks, bool upwards) {
    std::string list;
    for (const PlacedTick& tick : ticks) {
      fmt::format_to(std::back_inserter(list), "{}'' {:.2f}{}", list.empty() ? "" : ", ",
                     upwards ? up(tick.at) : tick.at, tick.minor ? " 1" : "");
    }
    if (list.empty())
      line("unset {}tics", axis);  // an empty list would be gnuplot's own choice
    else
      line("set {}tics ({})", axis, list);
  }

  void add_text(const PlacedText& text) {
    if (text.ground) {
      line(
          "set object rectangle from first {:.2f},{:.2f} to first {:.2f},{:.2f} front fc rgb '#ffffff' fs "
          "solid noborder",
          text.box.x - 2, up(text.box.bottom()), text.box.right() + 2, up(text.box.y));
    }
    // On a ground of its own a text stands in the middle: fonts differ in width, the ground is made for the
    // widest.
    const Align side = text.ground ? Align::centre : text.align;
    const double x = text.ground ? (text.box.x + text.box.right()) / 2 : text.at.x;
    const char* align = side == Align::left ? "left" : side == Align::right ? "right" : "center";
    line("set label {} at first {:.2f},{:.2f} {}{} font ',{:.4g}' tc rgb '{}' front",
         quoted(text.bold ? "{/:Bold " + text.text + "}" : text.text), x, up(text.at.y), align,
         text.rotated ? " rotate by 90" : "", text.size, text.colour);
  }

  void add_line(const PlacedLine& segment, const char* layer) {
    line("set arrow from first {:.2f},{:.2f} to first {:.2f},{:.2f} nohead {} lc rgb '{}' lw {:.3g}{}",
         segment.from.x, up(segment.from.y), segment.to.x, up(segment.to.y), layer, segment.colour,
         segment.width, segment.dash[0] > 0 ? " dt " + dash_type(segment) : "");
  }

  void data(const PlacedCurve& curve, std::size_t panel, std::size_t index) {
    line("$curve_{}_{} << EOD", panel + 1, index + 1);
    for (std::size_t i = 0; i < curve.band.x.size(); ++i) {
      if (std::isnan(curve.band.x[i]))
        line("");
      else
        line("{:.2f} {:.2f} {:.2f}", curve.band.x[i], up(curve.band.low[i]), up(curve.band.high[i]));
    }
    for (const auto& piece : curve.pieces) {
      for (const Spot& p : piece) line("{:.2f} {:.2f}", p.x, up(p.y));
      line("");
    }
    line("EOD");
    if (curve.dots.empty()) return;
    line("$dots_{}_{} << EOD", panel + 1, index + 1);
    for (const Spot& p : curve.dots) line("{:.2f} {:.2f}", p.x, up(p.y));
    line("EOD");
  }

  void map_data(const PlacedMap& map, std::size_t panel) {
    line("$map_{} << EOD", panel + 1);
    for (int row = 0; row < map.rows; ++row) {
      std::string numbers;
      for (int column = 0; column < map.columns; ++column) {
        const double value = map.values[static_cast<std::size_t>(row * map.columns + column)];
        numbers += std::isfinite(value) ? fmt::format("{:.4g} ", value) : "NaN ";
      }
      line("{}", numbers);
    }
    line("EOD");
  }

  /// The colours, and the bar in small pieces.
  void colours(const PlacedMap& map) {
    std::string stops;
    for (std::size_t i = 0; i < std::size(map_colours); ++i)
      fmt::format_to(std::back_inserter(stops), "{}{} '{}'", i ? ", " : "", i, map_colours[i]);
    line("set palette defined ({})", stops);
    line("unset colorbox");
    line("set cbrange [0:1]");
    constexpr int pieces = 64;
    const Box& b = map.bar;
    for (int i = 0; i < pieces; ++i) {
      const double low = b.bottom() - i * b.height / pieces, high = b.bottom() - (i + 1) * b.height / pieces;
      line(
          "set object rectangle from first {:.2f},{:.2f} to first {:.2f},{:.2f} front noclip fc rgb '{}' fs "
          "solid noborder",
          b.x, up(low), b.right(), up(std::max(high - 0.3, b.y)), map_colour((i + 0.5) / pieces));
    }
  }

  std::string drawing(const PlacedCurve& curve, std::size_t panel, std::size_t index) const {
    const std::string name = fmt::format("$curve_{}_{}", panel + 1, index + 1);
    switch (curve.mark) {
      case Mark::band:
        return fmt::format("{} using 1:2:3 with filledcurves fc rgb '{}' fs transparent solid 0.2 noborder",
                           name, curve.colour);
      case Mark::dots:
        return fmt::format("{} using 1:2 with points pt 7 ps {} lw 1 lc rgb '{}'", name,
                           terminal_of(format_).point_size, curve.colour);
      case Mark::line:
      case Mark::crosses:
        break;
    }
    std::string line = fmt::format("{} using 1:2 with lines lc rgb '{}' lw {:.3g} dt {}", name, curve.colour,
                                   curve.width, dash_type(curve));
    if (!curve.dots.empty())
      line += fmt::format(", $dots_{}_{} using 1:2 with points pt 7 ps {} lw 1 lc rgb '{}'", panel + 1,
                          index + 1, 2 * terminal_of(format_).point_size, curve.colour);
    return line;
  }

  void panel(const PlacedPanel& panel, std::size_t number) {
    const Box& f = panel.frame;
    for (std::size_t i = 0; i < panel.curves.size(); ++i) data(panel.curves[i], number, i);
    line("unset label");
    line("unset arrow");
    line("unset object");
    line("set lmargin at screen {:.6f}", f.x / layout_.width);
    line("set rmargin at screen {:.6f}", f.right() / layout_.width);
    line("set bmargin at screen {:.6f}", up(f.bottom()) / layout_.height);
    line("set tmargin at screen {:.6f}", up(f.y) / layout_.height);
    line("set xrange [{:.4f}:{:.4f}]", f.x, f.right());
    line("set yrange [{:.4f}:{:.4f}]", up(f.bottom()), up(f.y));
    ticks('x', panel.x_ticks, false);
    ticks('y', panel.y_ticks, true);
    for (const PlacedLine& zero : panel.zero_lines) add_line(zero, "back");
    for (const PlacedLine& leader : panel.leaders) add_line(leader, "front");
    for (const Spot& p : panel.rings) {
      line(
          "set object circle at first {:.2f},{:.2f} size first 4.5 front noclip fc rgb '{}' fs empty border "
          "lw 1.3",
          p.x, up(p.y), light_surface.ink);
    }
    for (const Spot& p : panel.dots) {
      line(
          "set object circle at first {:.2f},{:.2f} size first 2.6 front noclip fc rgb '{}' fs solid "
          "noborder",
          p.x, up(p.y), light_surface.ink);
    }
    for (const PlacedText& text : panel.texts) add_text(text);
    std::string plots;
    if (panel.map) {
      map_data(*panel.map, number);
      colours(*panel.map);
      plots = fmt::format("$map_{} matrix using ({:.4f}+$1*{:.6f}):({:.4f}+$2*{:.6f}):3 with image",
                          number + 1, f.x + 0.5 * f.width / panel.map->columns, f.width / panel.map->columns,
                          up(f.bottom()) + 0.5 * f.height / panel.map->rows, f.height / panel.map->rows);
    }
    for (std::size_t i = 0; i < panel.curves.size(); ++i) {
      const PlacedCurve& curve = panel.curves[i];
      const bool empty = curve.band.x.empty() && std::all_of(curve.pieces.begin(), curve.pieces.end(),
                                                             [](const auto& p) { return p.empty(); });
      if (!empty) plots += (plots.empty() ? "" : ", ") + drawing(curve, number, i);
    }
    // Without data, axes alone: a line outside the frame.
    line("plot {}", plots.empty() ? fmt::format("{:.2f} with lines lw 0.1", up(f.y) + 10) : plots);
  }

  const Layout& layout_;
  FigureFormat format_;
  std::string_view font_;
  std::string out_;
};

}  // namespace

std::string gnuplot_script(const Figure& figure, FigureFormat format, Typeface typeface) {
  // Read with an unknown font, an SVG is measured with the widest. LOOK.md: DejaVu Sans one point smaller
  // than Lato.
  const bool svg = format == FigureFormat::svg;
  const Layout layout = lay_out(figure, svg ? Typeface::dejavu_sans : typeface,
                                !svg && typeface == Typeface::dejavu_sans ? 1 : 0);
  return Script(layout, format, typeface == Typeface::lato ? "Lato" : "DejaVu Sans").write();
}

Result<FigureFormat> figure_format(const std::string& path) {
  const auto ends_with = [&](std::string_view ending) {
    return path.size() > ending.size() &&
           std::equal(ending.rbegin(), ending.rend(), path.rbegin(),
                      [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
  };
  if (ends_with(".svg")) return FigureFormat::svg;
  if (ends_with(".png")) return FigureFormat::png;
  if (ends_with(".pdf")) return FigureFormat::pdf;
  return Error{fmt::format("\"{}\" names no figure: end it with .svg, .png or .pdf", path)};
}

}  // namespace cromer
