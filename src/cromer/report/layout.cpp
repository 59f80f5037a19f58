#include "cromer/report/layout.h"

#include <algorithm>
#include <cmath>

#include "cromer/report/axis.h"
#include "cromer/report/heat_map.h"
#include "cromer/report/palette.h"
#include "cromer/report/place_curve.h"
#include "cromer/report/place_names.h"

namespace cromer::core {
namespace {

constexpr double row_of_several = 310;
constexpr double row_of_portraits = 440;  // [px] among other rows
constexpr double wide_text = 1.15;        // a wide figure is shown smaller on the page

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

namespace {

constexpr double margin_share = 0.14;  // of the width, for names
constexpr double most_margin = 0.30;
constexpr double beside_others =
    1.35;  // width over height of a phase portrait next to other panels: room for its names
constexpr double wide_frame = 800;  // [px] has room for more than 7 ticks
constexpr std::size_t most_names_inside = 6;
constexpr double edge = 6;                      // free at the figure's edge [px]
constexpr double tick_room = 8;                 // a tick with the gap to its number [px]
constexpr double bar_gap = 16, bar_width = 14;  // of a map's colours, beside its frame [px]

// A panel while it is laid out.
struct Cell {
  const Panel* panel;
  Box box;
  bool lowest;  // of a shared x axis
  std::string letter;
  bool mixed;  // stands beside panels that are no phase portraits
  AxisRange x, y;
  std::vector<Tick> x_ticks, y_ticks;
  double left = 0, right = 0, top = 0, bottom = 0;  // margins
};

struct Fonts {
  TextSizes sizes;
  Typeface typeface;
  double width(const std::string& text, double size, bool bold = false) const {
    return text_width(text, size, bold, typeface);
  }
};

double widest_label(const std::vector<Tick>& ticks, const Fonts& fonts) {
  double widest = 0;
  for (const Tick& tick : ticks) widest = std::max(widest, fonts.width(tick.label, fonts.sizes.tick));
  return widest;
}

bool titled(const Cell& cell) { return !cell.panel->title.empty() || !cell.letter.empty(); }

// Beside others a phase portrait is wider than high: its orbit stays round, its names get the corners.
void free_the_corners(AxisRange& x, const Axis& axis) {
  if (x.logarithmic || !std::isnan(axis.low) || !std::isnan(axis.high)) return;
  const double extra = (beside_others - 1) / 2 * (x.high - x.low);
  x.low -= extra;
  x.high += extra;
}

void measure(Cell& cell, const Figure& figure, const Fonts& fonts) {
  const Panel& panel = *cell.panel;
  const TextSizes& s = fonts.sizes;
  cell.x = panel.map ? map_x_range(panel) : x_range(panel);
  if (panel.phase_portrait && cell.mixed) free_the_corners(cell.x, panel.x);
  cell.y = panel.map ? map_y_range(panel) : y_range(panel, cell.x);
  const bool named = !panel.y.name.empty();
  cell.top = titled(cell) ? s.title + 17 : named ? s.axis + 16 : 12;
  cell.bottom = cell.lowest ? tick_room + s.tick + 6 + (panel.x.name.empty() ? 0 : s.axis + 6) : 14;
  if (figure.panels.size() > static_cast<std::size_t>(std::max(1, figure.columns)))
    cell.bottom += 8;  // before the next row
  const double height = cell.box.height - cell.top - cell.bottom;
  if (!panel.bare) cell.y_ticks = ticks_of(panel.y, cell.y, height < 150 ? 5 : 6);
  cell.left = edge + widest_label(cell.y_ticks, fonts) + tick_room + (named && titled(cell) ? s.axis + 8 : 0);
  if (panel.map) {
    cell.right =
        bar_gap + bar_width + tick_room + widest_label(map_scale(*panel.map).ticks, fonts) + s.axis + 14;
    return;
  }
  const double names = names_margin(panel, s, fonts.typeface, most_margin * cell.box.width);
  const bool sole_column = figure.columns <= 1 && names > 0;
  cell.right = std::max(names, sole_column ? margin_share * cell.box.width : 18);
  cell.right = std::min(cell.right, 0.5 * cell.box.width);
}

// As many x ticks as their numbers leave room for, 7 at most.
void choose_x_ticks(Cell& cell, const Box& frame, const Fonts& fonts) {
  for (int most = frame.width > wide_frame ? 9 : 7;; --most) {
    cell.x_ticks = ticks_of(cell.panel->x, cell.x, most);
    const auto labelled = std::count_if(cell.x_ticks.begin(), cell.x_ticks.end(),
                                        [](const Tick& t) { return !t.label.empty(); });
    if (most <= 2 || widest_label(cell.x_ticks, fonts) + 14 <=
                         frame.width / static_cast<double>(std::max<long>(1, labelled)))
      return;
    if (cell.panel->x.step > 0) return;
  }
}

PlacedText text(const std::string& words, Spot at, Align align, double size, std::string_view colour,
                const Fonts& fonts) {
  PlacedText placed;
  placed.text = words;
  placed.at = at;
  placed.align = align;
  placed.size = size;
  placed.colour = colour;
  const double width = fonts.width(words, size), left = align == Align::left    ? 0
                                                        : align == Align::right ? width
                                                                                : width / 2;
  placed.box = {at.x - left, at.y - size * 0.6, width, size * 1.2};
  return placed;
}

void place_axes(PlacedPanel& placed, const Cell& cell, const Fonts& fonts) {
  const Box& f = placed.frame;
  const TextSizes& s = fonts.sizes;
  const Panel& panel = *cell.panel;
  const auto& colour = light_surface;
  for (const Tick& tick : cell.x_ticks) {
    const double at = cell.x.px(tick.value);
    placed.x_ticks.push_back({at, tick.label.empty()});
    if (cell.lowest && !tick.label.empty()) {
      placed.texts.push_back(text(tick.label, {at, f.bottom() + tick_room + s.tick / 2 + 2}, Align::centre,
                                  s.tick, colour.text_2, fonts));
    }
  }
  for (const Tick& tick : cell.y_ticks) {
    const double at = cell.y.px(tick.value);
    placed.y_ticks.push_back({at, tick.label.empty()});
    if (!tick.label.empty())
      placed.texts.push_back(
          text(tick.label, {f.x - tick_room, at}, Align::right, s.tick, colour.text_2, fonts));
  }
  const double name_y = f.bottom() + tick_room + s.tick + s.axis / 2 + 8;
  if (cell.lowest && !panel.x.name.empty()) {
    const bool centred = titled(cell);
    placed.texts.push_back(text(panel.x.name, {centred ? f.x + f.width / 2 : f.right(), name_y},
                                centred ? Align::centre : Align::right, s.axis, colour.text_2, fonts));
  }
  if (!panel.y.name.empty() && !titled(cell)) {
    const double left = std::max(cell.box.x + edge, f.x - tick_room - widest_label(cell.y_ticks, fonts));
    placed.texts.push_back(
        text(panel.y.name, {left, f.y - s.axis / 2 - 8}, Align::left, s.axis, colour.text_2, fonts));
  } else if (!panel.y.name.empty()) {
    PlacedText name = text(panel.y.name, {f.x - cell.left + edge + s.axis / 2, f.y + f.height / 2},
                           Align::centre, s.axis, colour.text_2, fonts);
    name.rotated = true;
    name.box = {name.at.x - s.axis * 0.6, name.at.y - name.box.width / 2, s.axis * 1.2, name.box.width};
    placed.texts.push_back(name);
  }
  if (titled(cell)) {
    double x = f.x - cell.left + edge;
    const double y = cell.box.y + s.title * 0.6 + 3;
    if (!cell.letter.empty()) {
      PlacedText letter = text(cell.letter, {x, y}, Align::left, s.title, colour.ink, fonts);
      letter.bold = true;
      placed.texts.push_back(letter);
      x += s.title * 1.5;
    }
    if (!panel.title.empty()) {
      const double room = cell.box.right() - x - edge, width = fonts.width(panel.title, s.title);
      const double size = width > room ? std::max(s.remark, s.title * room / width) : s.title;
      placed.texts.push_back(text(panel.title, {x, y}, Align::left, size, colour.ink, fonts));
    }
  }
  const double zero_y = cell.y.px(0), zero_x = cell.x.px(0);
  const auto inside = [](double at, double from, double to) { return at > from + 1 && at < to - 1; };
  if (inside(zero_y, f.y, f.bottom()))
    placed.zero_lines.push_back({{f.x, zero_y}, {f.right(), zero_y}, std::string(colour.zero_line), 0.8});
  if (panel.phase_portrait && inside(zero_x, f.x, f.right())) {
    placed.zero_lines.push_back({{zero_x, f.y}, {zero_x, f.bottom()}, std::string(colour.zero_line), 0.8});
  }
}

void place_colours(PlacedPanel& placed, const Cell& cell, const Fonts& fonts) {
  const HeatMap& map = *cell.panel->map;
  const Box& f = placed.frame;
  const TextSizes& s = fonts.sizes;
  PlacedMap drawn = place_map(map, cell.x, cell.y, f);
  drawn.bar = {f.right() + bar_gap, f.y, bar_width, f.height};
  const MapScale scale = map_scale(map);
  for (const Tick& tick : scale.ticks) {
    const double at = f.bottom() - scale.share(tick.value) * f.height;
    const double length = tick.label.empty() ? 1.5 : 3;
    placed.leaders.push_back(
        {{drawn.bar.right(), at}, {drawn.bar.right() + length, at}, std::string(light_surface.axis), 0.8});
    if (tick.label.empty()) continue;
    placed.texts.push_back(text(tick.label, {drawn.bar.right() + tick_room, at}, Align::left, s.tick,
                                light_surface.text_2, fonts));
  }
  PlacedText name = text(map.name, {cell.box.right() - s.axis / 2 - 4, f.y + f.height / 2}, Align::centre,
                         s.axis, light_surface.text_2, fonts);
  name.rotated = true;
  name.box = {name.at.x - s.axis * 0.6, name.at.y - name.box.width / 2, s.axis * 1.2, name.box.width};
  placed.texts.push_back(name);
  placed.map = std::move(drawn);
}

// The drawing order: bands and dots too dense to be told apart, the exact curve, a fitted law, the rest as
// given, a rejected law, the dots.
int layer_of(const Curve& curve, const PlacedCurve& placed) {
  if (placed.mark == Mark::band || (curve.mark == Mark::dots && placed.mark == Mark::line)) return 0;
  if (curve.role == "exact") return 1;
  if (curve.role == "fitted") return 2;
  if (curve.role == "constant-rate") return 4;
  return placed.mark == Mark::dots || curve.role == "measured" ? 5 : 3;
}

PlacedPanel place_panel(Cell& cell, const Fonts& fonts) {
  const Panel& panel = *cell.panel;
  PlacedPanel placed;
  Box& f = placed.frame;
  f = {cell.box.x + cell.left, cell.box.y + cell.top, cell.box.width - cell.left - cell.right,
       cell.box.height - cell.top - cell.bottom};
  if (panel.phase_portrait) {
    f.height = std::min(f.height, f.width);
    f.width = std::min(f.width, cell.mixed ? beside_others * f.height : f.height);
  }
  placed.bare = panel.bare;
  if (!panel.bare) choose_x_ticks(cell, f, fonts);
  cell.x.from = f.x, cell.x.to = f.right();
  cell.y.from = f.bottom(), cell.y.to = f.y;
  place_axes(placed, cell, fonts);
  if (panel.map || panel.bare) placed.zero_lines.clear();
  if (panel.map) {
    place_colours(placed, cell, fonts);
    return placed;
  }

  std::vector<std::vector<Spot>> spots;
  std::vector<std::pair<int, PlacedCurve>> layered;
  for (const Curve& curve : panel.curves) {
    spots.push_back(spots_of(curve, cell.x, cell.y));
    PlacedCurve drawn = place_curve(curve, spots.back(), panel);
    const int layer = layer_of(curve, drawn);
    layered.emplace_back(layer, std::move(drawn));
  }
  std::stable_sort(layered.begin(), layered.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& each : layered) placed.curves.push_back(std::move(each.second));
  place_words(placed, panel, spots, cell.x, cell.y, cell.box, fonts.sizes, fonts.typeface);
  return placed;
}

// The widths of a row's panels: equal shares, but phase portraits take no more than their square needs when
// others stand beside them.
std::vector<double> row_widths(const std::vector<Cell>& row, double width, double height, int columns) {
  std::vector<double> widths;
  double left_over = width, shares = 0;
  int used = 0;
  for (const Cell& cell : row) used += std::clamp(cell.panel->span, 1, columns);
  for (const Cell& cell : row) {
    const double share = std::clamp(cell.panel->span, 1, columns);
    const double wanted = beside_others * (height - cell.top - cell.bottom) + cell.left + cell.right;
    const bool fixed = cell.mixed && cell.panel->phase_portrait && wanted < width * share / columns;
    widths.push_back(fixed ? wanted : -share);
    if (fixed)
      left_over -= wanted;
    else
      shares += share;
  }
  const double unit = used == columns ? left_over / std::max(shares, 1.0) : width / columns;
  for (double& w : widths) w = w < 0 ? -w * unit : w;
  return widths;
}

Layout lay_out_as_said(const Figure& figure, Typeface typeface, double smaller_by) {
  const auto rows = rows_of(figure);
  const int columns = std::max(1, figure.columns);
  const Canvas canvas = canvas_of(figure, static_cast<int>(rows.size()));
  Fonts fonts{{}, typeface};
  for (double* size :
       {&fonts.sizes.title, &fonts.sizes.name, &fonts.sizes.remark, &fonts.sizes.axis, &fonts.sizes.tick}) {
    *size = *size * canvas.text_scale - smaller_by;
  }

  Layout layout{canvas.width, 0, {}};
  const double hidden = figure.shared_x && rows.size() > 1 ? fonts.sizes.axis + fonts.sizes.tick + 8
                                                           : 0;  // what upper rows save
  // A portrait alone in its row is as high as elsewhere, and has an axis of its own.
  const auto of_portrait = [&](std::size_t r) {
    return columns == 1 && rows.size() > 1 && r < rows.size() &&
           figure.panels[rows[r].front()].phase_portrait;
  };
  std::vector<std::vector<Cell>> cells;
  std::vector<double> heights;
  double y = 0;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const bool lowest = !figure.shared_x || r + 1 == rows.size() || of_portrait(r) || of_portrait(r + 1);
    const double height = of_portrait(r) ? std::max(row_of_portraits, canvas.row_height)
                                         : canvas.row_height - (lowest ? 0 : hidden);
    auto& row = cells.emplace_back();
    const bool mixed = std::any_of(rows[r].begin(), rows[r].end(),
                                   [&](std::size_t i) { return !figure.panels[i].phase_portrait; });
    for (const std::size_t i : rows[r]) {
      const std::string letter = figure.panels.size() > 1 ? letter_of(i) : "";
      Cell cell{
          &figure.panels[i], {0, y, canvas.width / columns, height}, lowest, letter, mixed, {}, {}, {}, {}};
      cell.box.width *= std::clamp(cell.panel->span, 1, columns);
      measure(cell, figure, fonts);
      row.push_back(std::move(cell));
    }
    heights.push_back(height);
    y += height;
  }

  // Panels below each other share their left and right edges if the rows have equally many panels.
  for (auto& row : cells) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      for (const auto& other : cells) {
        if (other.size() != row.size()) continue;
        row[c].left = std::max(row[c].left, other[c].left);
        row[c].right = std::max(row[c].right, other[c].right);
      }
    }
  }
  for (std::size_t r = 0; r < cells.size(); ++r) {
    const std::vector<double> widths = row_widths(cells[r], canvas.width, heights[r], columns);
    double x = 0;
    for (std::size_t c = 0; c < cells[r].size(); ++c) {
      cells[r][c].box.x = x;
      cells[r][c].box.width = widths[c];
      x += widths[c];
      layout.panels.push_back(place_panel(cells[r][c], fonts));
    }
  }
  PlacedPanel& last = layout.panels.back();
  y += place_key(last, figure.key, {edge, y, canvas.width - 2 * edge, 0}, fonts.sizes, fonts.typeface);
  if (!figure.note.empty()) {
    const double height = 2 * fonts.sizes.remark;
    last.texts.push_back(text(figure.note, {edge, y + height / 2 - 2}, Align::left, fonts.sizes.remark,
                              light_surface.text_2, fonts));
    y += height;
  }
  layout.height = std::ceil(y);  // whole px: a picture's last row is not half drawn
  return layout;
}

std::size_t names_inside(const Panel& panel) {
  return static_cast<std::size_t>(
      std::count_if(panel.curves.begin(), panel.curves.end(), [&](const Curve& curve) {
        return !curve.name.empty() && curve.mark != Mark::band && !stands_outside(curve, panel);
      }));
}

// Whether a word stands on a curve.
bool hides(const PlacedPanel& panel) {
  return std::any_of(panel.texts.begin(), panel.texts.end(),
                     [](const PlacedText& text) { return text.ground; });
}

// Leaves free space above the curves.
void raise(Panel& panel) {
  constexpr double share = 0.2;  // of the height
  const AxisRange y = y_range(panel, x_range(panel));
  panel.y.low = y.low;
  panel.y.high =
      y.logarithmic ? y.high * std::pow(y.high / y.low, share) : std::lerp(y.low, y.high, 1 + share);
}

// Extends the remark of crosses if some lie beyond the frame and stand at its edge.
void say_what_is_outside(Panel& panel) {
  for (Curve& curve : panel.curves) {
    if (curve.remark_outside.empty()) continue;
    const AxisRange y = y_range(panel, x_range(panel));
    if (std::any_of(curve.y.begin(), curve.y.end(), [&](double at) { return at < y.low || at > y.high; }))
      curve.remark += curve.remark_outside;
  }
}

}  // namespace

Layout lay_out(const Figure& source, Typeface typeface, double smaller_by) {
  Figure figure = source;
  if (figure.panels.empty()) figure.panels.emplace_back();
  const bool small = figure.size == FigureSize::half || figure.size == FigureSize::tall;
  for (Panel& panel : figure.panels) {
    panel.names_inside = panel.names_inside || small;
    say_what_is_outside(panel);
    if (!panel.phase_portrait && names_inside(panel) > most_names_inside) panel.names_listed = true;
  }
  Layout layout = lay_out_as_said(figure, typeface, smaller_by);
  bool again = false;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    Panel& panel = figure.panels[i];
    if (panel.phase_portrait || !(small ? hides(layout.panels[i]) : layout.panels[i].crowded)) continue;
    again = true;
    small ? raise(panel) : void(panel.names_listed = true);  // a small plot has no room for a list
  }
  return again ? lay_out_as_said(figure, typeface, smaller_by) : layout;
}

}  // namespace cromer::core
