#include "cromer/report/place_names.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/report/labels.h"
#include "cromer/report/palette.h"
#include "cromer/report/place_curve.h"

namespace cromer::core {
namespace {

constexpr double leading = 1.28;  // line height over font size
constexpr double off = 8;         // names beside the plot [px]
constexpr double leader_gap = 3;  // between a leader line and what it joins [px]
constexpr std::size_t most_targets = 240;

// Of the list beside the plot:
constexpr double list_off = 10;                // the list from the plot [px]
constexpr double sample = 26, sample_gap = 6;  // the piece of a line, and what follows it [px]
constexpr double between_names = 6;            // where there is room [px]
constexpr int columns_read = 120;              // places looked at for the order
constexpr double told_apart = 20;              // [px] further apart is not told apart better

class Words {
 public:
  Words(PlacedPanel& placed, Drawn& drawn, const AxisRange& x, const AxisRange& y)
      : placed_(placed), drawn_(drawn), x_(x), y_(y) {}

  // `block` with its box at a place already chosen.
  void put(const NameBlock& block, const Box& box, Align align, bool ground) {
    double top = box.y;
    for (PlacedText line : block.lines) {
      const double height = line.size * leading;
      line.align = align;
      line.at = {align == Align::left    ? box.x
                 : align == Align::right ? box.right()
                                         : box.x + box.width / 2,
                 top + height / 2};
      line.ground = ground;
      line.box = {box.x, top, box.width, height};
      placed_.texts.push_back(line);
      top += height;
    }
    drawn_.all.add_box(box);
    drawn_.inked.add_box(box);
  }

  // At the place asked for, in graph fractions: left or right of it, on the side away from `point`.
  Box asked(const NameBlock& block, double text_x, double text_y, Spot point) const {
    const Box& f = placed_.frame;
    const double px = f.x + text_x * f.width, py = f.bottom() - text_y * f.height;
    const double left = std::isfinite(point.x) && px < point.x ? px - block.width : px;
    return {std::clamp(left, f.x + 3, std::max(f.x + 3, f.right() - block.width - 1)), py - block.height / 2,
            block.width, block.height};
  }

  // Beside one of upright lines: where it covers least, right of it and high up before all else.
  void put_beside_line(const NameBlock& block, double at, std::span<const double> lines) {
    constexpr double off_line = 5, off_top = 2, square = 2;  // of Occupancy, as wide as a line
    const Box& f = placed_.frame;
    const bool fits_right = at + off_line + block.width <= f.right();
    const bool fits_left = at - off_line - block.width >= f.x;
    const auto covered = [&](const Box& box) {
      const auto crossed = std::count_if(lines.begin(), lines.end(),
                                         [&](double line) { return line > box.x && line < box.right(); });
      return drawn_.all.taken(box) + static_cast<int>(crossed * std::lround(box.height / square));
    };
    Box best{};
    int least = std::numeric_limits<int>::max();
    for (double y = f.y + off_top; y == f.y + off_top || y + block.height + off_top <= f.bottom();
         y += block.height) {
      for (const bool right : {true, false}) {
        if (right ? !fits_right : fits_right && !fits_left) continue;
        const Box box{right ? at + off_line : at - off_line - block.width, y, block.width, block.height};
        if (const int covers = covered(box); covers < least) best = box, least = covers;
      }
    }
    put(block, best, Align::left, least > 0);
  }

  void leader(const Box& box, Spot point, const std::string& colour, double gap_at_point) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) return;
    Spot edge = box.nearest(point);
    if (point.x < box.x || point.x > box.right())
      edge.y = std::clamp(point.y, box.y + 6, std::max(box.y + 6, box.bottom() - 6));
    const double length = std::hypot(point.x - edge.x, point.y - edge.y);
    if (length < leader_from) return;
    const double ux = (point.x - edge.x) / length, uy = (point.y - edge.y) / length;
    placed_.leaders.push_back({{edge.x + leader_gap * ux, edge.y + leader_gap * uy},
                               {point.x - gap_at_point * ux, point.y - gap_at_point * uy},
                               colour,
                               0.8,
                               {}});
    const Spot ends[] = {placed_.leaders.back().from, placed_.leaders.back().to};
    drawn_.all.add_line(ends, 0.8);
    drawn_.inked.add_line(ends, 0.8);
  }

  Spot at(double x, double y) const { return {x_.px(x), y_.px(y)}; }
  bool covers(const Box& box) const { return drawn_.all.taken(box) > 0; }

 private:
  PlacedPanel& placed_;
  Drawn& drawn_;
  const AxisRange& x_;
  const AxisRange& y_;
};

std::vector<Spot> targets_of(const PlacedCurve& curve, const Box& frame) {
  std::vector<Spot> all;
  for (const auto& piece : curve.pieces) {
    for (const Spot& p : piece) {
      if (p.x >= frame.x && p.x <= frame.right() && p.y >= frame.y && p.y <= frame.bottom()) all.push_back(p);
    }
  }
  std::vector<Spot> some;
  const std::size_t stride = std::max<std::size_t>(1, all.size() / most_targets);
  for (std::size_t i = 0; i < all.size(); i += stride) some.push_back(all[i]);
  return some;
}

void draw_on(Occupancy& drawn, const PlacedCurve& curve) {
  for (const auto& piece : curve.pieces) {
    if (curve.mark == Mark::dots) {
      for (const Spot& p : piece) drawn.add_line(std::span(&p, 1), curve.width);
    } else {
      drawn.add_line(piece, curve.width);
    }
  }
  for (const Spot& p : curve.dots) drawn.add_line(std::span(&p, 1), 5);
  for (std::size_t i = 0; i < curve.band.x.size(); ++i) {
    if (std::isnan(curve.band.x[i])) continue;
    drawn.add_box({curve.band.x[i], std::min(curve.band.low[i], curve.band.high[i]), 1,
                   std::abs(curve.band.high[i] - curve.band.low[i])});
  }
}

void place_outside(Words& words, const PlacedPanel& placed, const Panel& panel,
                   const std::vector<std::vector<Spot>>& spots, const Box& cell, const TextSizes& sizes,
                   Typeface typeface) {
  std::vector<NameBlock> blocks;
  std::vector<double> centres, heights, gaps;
  const double room = cell.right() - placed.frame.right() - off;
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    if (!stands_outside(panel.curves[i], panel)) continue;
    blocks.push_back(name_block(panel.curves[i], sizes, typeface, room));
    const NameBlock& block = blocks.back();
    // The name's own line, not the remark, faces the curve.
    centres.push_back(height_at_end(spots[i], placed.frame) + block.height / 2 - sizes.name * leading / 2);
    heights.push_back(block.height);
    gaps.push_back(panel.curves[i].remark.empty() ? 0 : 6);
  }
  // Beside the plot if there is room for all, not beside the axis below it.
  double needed = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) needed += heights[i] + gaps[i];
  const double top = std::max(cell.y, placed.frame.y - 6), beside = placed.frame.bottom() + 2;
  const std::vector<double> placed_at =
      spread(centres, heights, gaps, top, needed <= beside - top ? beside : cell.bottom());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    words.put(blocks[i],
              {placed.frame.right() + off, placed_at[i] - heights[i] / 2, blocks[i].width, heights[i]},
              Align::left, false);
  }
}

std::size_t listed(const Panel& panel) {
  return static_cast<std::size_t>(std::count_if(panel.curves.begin(), panel.curves.end(),
                                                [&](const Curve& c) { return stands_in_list(c, panel); }));
}

/// The right margin the list needs [px]; 0 without names.
double list_margin(const Panel& panel, const TextSizes& sizes, Typeface typeface, double room) {
  double widest = 0;
  for (const Curve& curve : panel.curves) {
    if (stands_in_list(curve, panel))
      widest = std::max(widest, name_block(curve, sizes, typeface, room - sample - sample_gap).width);
  }
  return widest > 0 ? list_off + sample + sample_gap + widest + 4 : 0;
}

/// A piece of the curve, before its name.
void place_sample(PlacedPanel& placed, const Curve& curve, const PlacedCurve& drawn, Spot left) {
  const Spot middle{left.x + sample / 2, left.y}, right{left.x + sample, left.y};
  if (drawn.mark == Mark::dots) {
    placed.dots.push_back(middle);
    return;
  }
  if (curve.mark != Mark::crosses) {
    placed.leaders.push_back({left, right, drawn.colour, drawn.width, drawn.dash});
    return;
  }
  for (const auto& stroke : place_curve(curve, {middle}, {}).pieces)
    placed.leaders.push_back({stroke.front(), stroke.back(), drawn.colour, drawn.width, {}});
}

/// Adds the list to `placed`. Remarks that do not fit are left out. If there are more names than fit, evenly
/// chosen ones stand there.
void place_list(PlacedPanel& placed, const Panel& panel, const std::vector<std::vector<Spot>>& spots,
                const std::vector<PlacedCurve>& drawn, const TextSizes& sizes, Typeface typeface,
                double room) {
  const std::size_t count = listed(panel);
  if (count == 0) return;
  const Box& frame = placed.frame;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < panel.curves.size(); ++i)
    if (stands_in_list(panel.curves[i], panel)) which.push_back(i);
  const std::vector<std::size_t> order = order_from_top(spots, which, frame);
  const auto block_of = [&](std::size_t i, bool remark) {
    Curve words;
    words.name = panel.curves[i].name, words.role = panel.curves[i].role;
    if (remark) words.remark = panel.curves[i].remark;
    return name_block(words, sizes, typeface, room - list_off - sample - sample_gap);
  };
  const auto height_of = [&](bool remark) {
    double height = 0;
    for (const std::size_t i : order) height += block_of(i, remark).height;
    return height;
  };
  const bool remarks = height_of(true) + static_cast<double>(count - 1) * between_names <= frame.height;
  const double names = height_of(remarks);
  // Every `stride`-th name, and a line that says so.
  std::size_t stride = 1;
  const double line = sizes.name * leading;
  while (names / static_cast<double>(stride) > frame.height - (stride > 1 ? 2 * line : 0)) ++stride;
  const double gap =
      stride > 1 || count < 2
          ? 0
          : std::clamp((frame.height - names) / static_cast<double>(count - 1), 0.0, between_names);
  double y = frame.y;
  const double left = frame.right() + list_off;
  for (std::size_t k = 0; k < order.size(); k += stride) {
    const std::size_t i = order[k];
    const NameBlock block = block_of(i, remarks);
    const double middle = y + line / 2;
    place_sample(placed, panel.curves[i], drawn[i], {left, middle});
    for (PlacedText text : block.lines) {
      const double height = text.size * leading;
      text.at = {left + sample + sample_gap, y + height / 2};
      text.box = {text.at.x, y, text_width(text.text, text.size, text.bold, typeface), height};
      placed.texts.push_back(text);
      y += height;
    }
    y += gap;
  }
  if (stride == 1) return;
  PlacedText text;
  text.text = fmt::format("one of {} is named", stride);
  text.size = sizes.remark;
  text.colour = light_surface.text_2;
  text.at = {left, y + line / 2};
  text.box = {left, y, text_width(text.text, text.size, false, typeface), line};
  placed.texts.push_back(text);
}

}  // namespace

double height_at(const std::vector<Spot>& spots, double x) {
  for (std::size_t i = 1; i < spots.size(); ++i) {
    const Spot &a = spots[i - 1], &b = spots[i];
    if ((a.x <= x && x <= b.x) || (b.x <= x && x <= a.x))
      return a.x == b.x ? a.y : a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
  }
  return std::nan("");
}

bool stands_outside(const Curve& curve, const Panel& panel) {
  return !curve.name.empty() && !curve.label_x && !panel.phase_portrait && !panel.names_inside &&
         !panel.names_listed && curve.mark != Mark::band;
}

bool stands_in_list(const Curve& curve, const Panel& panel) {
  return panel.names_listed && !curve.name.empty() && curve.mark != Mark::band;
}

std::vector<std::size_t> order_from_top(const std::vector<std::vector<Spot>>& spots,
                                        const std::vector<std::size_t>& which, const Box& frame) {
  std::vector<std::size_t> best = which;
  double most = 0;
  for (int column = 0; column <= columns_read; ++column) {
    const double x = frame.x + frame.width * column / columns_read;
    std::vector<std::pair<double, std::size_t>> heights;
    for (const std::size_t i : which) {
      const double y = height_at(spots[i], x);
      if (std::isfinite(y)) heights.emplace_back(y, i);
    }
    if (heights.size() < which.size()) continue;
    std::stable_sort(heights.begin(), heights.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    double apart = 0;
    for (std::size_t i = 1; i < heights.size(); ++i)
      apart += std::min(told_apart, heights[i].first - heights[i - 1].first);
    if (apart <= most) continue;
    most = apart;
    for (std::size_t i = 0; i < heights.size(); ++i) best[i] = heights[i].second;
  }
  return best;
}

NameBlock name_block(const Curve& curve, const TextSizes& sizes, Typeface typeface, double room) {
  NameBlock block;
  const auto add = [&](const std::string& text, double size, bool bold, std::string_view colour) {
    if (text.empty()) return;
    for (const std::string& line : wrapped(text, size, bold, typeface, room)) {
      PlacedText placed;
      placed.text = line;
      placed.size = size;
      placed.bold = bold;
      placed.colour = colour;
      block.lines.push_back(placed);
      block.width = std::max(block.width, text_width(line, size, bold, typeface));
      block.height += size * leading;
    }
  };
  add(curve.name, sizes.name, true, style_of(curve.role).word);
  add(curve.remark, sizes.remark, false, light_surface.text_2);
  return block;
}

double names_margin(const Panel& panel, const TextSizes& sizes, Typeface typeface, double room) {
  if (panel.names_listed) return list_margin(panel, sizes, typeface, room);
  double widest = 0;
  for (const Curve& curve : panel.curves) {
    if (stands_outside(curve, panel))
      widest = std::max(widest, name_block(curve, sizes, typeface, room).width);
  }
  return widest > 0 ? widest + off + 4 : 0;
}

double place_key(PlacedPanel& placed, const std::vector<Curve>& key, const Box& room, const TextSizes& sizes,
                 Typeface typeface) {
  constexpr double between = 18;  // [px]
  const double row = 2 * sizes.name;
  double x = room.x, y = room.y + row / 2 - 2;
  for (const Curve& curve : key) {
    PlacedText text;
    text.text = curve.name;
    text.size = sizes.name;
    text.bold = true;
    text.colour = style_of(curve.role).word;
    const double width = text_width(text.text, text.size, text.bold, typeface);
    if (x > room.x && x + sample + sample_gap + width > room.right()) x = room.x, y += row;
    const std::vector<Spot> ends{{x, y}, {x + sample, y}};
    place_sample(placed, curve, place_curve(curve, ends, {}), ends.front());
    text.at = {x + sample + sample_gap, y};
    text.box = {text.at.x, y - text.size * leading / 2, width, text.size * leading};
    placed.texts.push_back(text);
    x = text.box.right() + between;
  }
  return key.empty() ? 0 : y + row / 2 + 2 - room.y;
}

void place_words(PlacedPanel& placed, const Panel& panel, const std::vector<std::vector<Spot>>& spots,
                 const AxisRange& x, const AxisRange& y, const Box& cell, const TextSizes& sizes,
                 Typeface typeface) {
  const Box& frame = placed.frame;
  Drawn drawn{Occupancy(frame), Occupancy(frame), {}};
  std::vector<PlacedCurve> in_order;  // of panel.curves, not of drawing
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    in_order.push_back(place_curve(panel.curves[i], spots[i], panel));
    draw_on(drawn.all, in_order.back());
    const bool to_read_by = panel.curves[i].role == "grid";
    if (!to_read_by) draw_on(drawn.inked, in_order.back());
    drawn.curves.push_back(to_read_by ? std::vector<Spot>{} : spots[i]);
  }
  Words words(placed, drawn, x, y);
  const double room_inside = 0.6 * frame.width;

  std::vector<const Marker*> markers;  // that are in the panel
  std::vector<double> lines;           // theirs
  for (const Marker& marker : panel.markers) {
    const double at = x.px(marker.x);
    if (!(at >= frame.x - 0.5 && at <= frame.right() + 0.5)) continue;
    markers.push_back(&marker);
    lines.push_back(at);
    constexpr double width = 1.3;
    placed.leaders.push_back(
        {{at, frame.y}, {at, frame.bottom()}, std::string(style_of(marker.role).line), width});
  }
  for (std::size_t i = 0; i < markers.size(); ++i) {
    if (markers[i]->text.empty()) continue;
    Curve word;
    word.name = markers[i]->text, word.role = markers[i]->role;
    const NameBlock block = name_block(word, sizes, typeface, room_inside);
    words.put_beside_line(block, lines[i], lines);
  }

  for (const Note& note : panel.notes) {
    const Spot point = words.at(note.x, note.y);
    if (note.circle) placed.rings.push_back(point);
    if (note.dot) placed.dots.push_back(point);
    if (note.text.empty()) continue;
    Curve word;
    (note.circle ? word.name : word.remark) = note.text;
    NameBlock block = name_block(word, sizes, typeface, room_inside);
    for (PlacedText& line : block.lines) {
      line.colour = light_surface.ink;
      line.bold = note.circle;
    }
    const bool points = note.leader || note.circle || note.dot;
    const Box box = words.asked(block, note.text_x, note.text_y, points ? point : Spot{-1e9, 0});
    words.put(block, box, Align::left, words.covers(box));
    if (note.leader)
      words.leader(box, point, std::string(light_surface.ink), note.circle ? ring_radius + 1 : 3);
  }

  place_list(placed, panel, spots, in_order, sizes, typeface, cell.right() - frame.right());
  place_outside(words, placed, panel, spots, cell, sizes, typeface);

  for (const bool fixed : {true, false}) {
    for (std::size_t i = 0; i < panel.curves.size(); ++i) {
      const Curve& curve = panel.curves[i];
      if (curve.name.empty() || stands_outside(curve, panel) || stands_in_list(curve, panel) ||
          (curve.text_x && curve.text_y) != fixed)
        continue;
      const NameBlock block = name_block(curve, sizes, typeface, room_inside);
      const std::string colour(style_of(curve.role).word);
      Spot point{std::nan(""), std::nan("")};
      if (curve.label_x) {
        point = words.at(*curve.label_x, curve.label_y.value_or(0));
        if (!curve.label_y) point.y = height_at(spots[i], point.x);
      }
      if (fixed) {
        const Box box = words.asked(block, *curve.text_x, *curve.text_y, point);
        words.put(block, box, Align::left, words.covers(box));
        words.leader(box, point, colour, 1);
      } else if (in_order[i].mark == Mark::band && !curve.label_x) {
        const Band& band = in_order[i].band;
        const double middle_x = frame.x + frame.width / 2;
        std::size_t k = 0;  // the column nearest to the middle
        for (std::size_t column = 0; column < band.x.size(); ++column)
          if (std::abs(band.x[column] - middle_x) < std::abs(band.x[k] - middle_x)) k = column;
        const Box box{middle_x - block.width / 2, (band.low[k] + band.high[k]) / 2 - block.height / 2,
                      block.width, block.height};
        words.put(block, box, Align::centre, true);
      } else {
        const std::vector<Spot> anywhere = targets_of(in_order[i], frame);
        const std::vector<Spot> wanted =
            curve.label_x && std::isfinite(point.y) ? std::vector<Spot>{point} : anywhere;
        const auto [place, clear] = clear_place(drawn, frame, block.width, block.height, i, wanted, anywhere);
        placed.crowded = placed.crowded || !clear;
        words.put(block, place.box, Align::left, words.covers(place.box));
        words.leader(place.box, place.target, colour, 1);
      }
    }
  }
}

}  // namespace cromer::core
