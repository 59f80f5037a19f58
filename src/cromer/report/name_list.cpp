#include "cromer/report/name_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

constexpr double leading = 1.28;               // line height over font size
constexpr double off = 10;                     // of the list from the plot [px]
constexpr double sample = 20, sample_gap = 6;  // the piece of a line, and what follows it [px]
constexpr double between_names = 6;            // where there is room [px]
constexpr int columns_read = 120;              // places looked at for the order
constexpr double told_apart = 20;              // [px] further apart is not told apart better

std::size_t listed(const Panel& panel) {
  return static_cast<std::size_t>(std::count_if(panel.curves.begin(), panel.curves.end(),
                                                [&](const Curve& c) { return stands_in_list(c, panel); }));
}

}  // namespace

bool stands_in_list(const Curve& curve, const Panel& panel) {
  return panel.names_listed && !curve.name.empty() && curve.mark != Mark::band;
}

double list_margin(const Panel& panel, const TextSizes& sizes, Typeface typeface, double room) {
  double widest = 0;
  for (const Curve& curve : panel.curves) {
    if (stands_in_list(curve, panel))
      widest = std::max(widest, name_block(curve, sizes, typeface, room - sample - sample_gap).width);
  }
  return widest > 0 ? off + sample + sample_gap + widest + 4 : 0;
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
    return name_block(words, sizes, typeface, room - off - sample - sample_gap);
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
  const double left = frame.right() + off;
  for (std::size_t k = 0; k < order.size(); k += stride) {
    const std::size_t i = order[k];
    const NameBlock block = block_of(i, remarks);
    const double middle = y + line / 2;
    if (drawn[i].mark == Mark::dots)
      placed.dots.push_back({left + sample / 2, middle});
    else
      placed.leaders.push_back(
          {{left, middle}, {left + sample, middle}, drawn[i].colour, drawn[i].width, drawn[i].dash});
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

}  // namespace cromer::core
