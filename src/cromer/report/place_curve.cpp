#include "cromer/report/place_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

constexpr double figure_width = 1.3 / 1.5;  // a figure's curves against the page's
constexpr double road_width = 4.5, narrow_road = 3;
constexpr double measured_line = 1;   // [px] error bars, and samples too dense for dots
constexpr std::size_t few_dots = 40;  // up to here dots are large
constexpr double few_dots_width = 5;  // [px]
constexpr std::size_t all_dots = 60;  // up to here none is left out: each may have an error bar
constexpr double dots_apart = 5;      // [px] of more than all_dots, beside a line
constexpr double dense_dots = 4;      // per pixel column: dots cannot be told apart
constexpr double swing_dots = 1.5;    // per pixel column: those of a narrow swing make a pattern of their own
constexpr double swing_columns = 40;  // of a narrow swing's period
constexpr double band_columns = 6;    // columns per period from which on a band is filled
constexpr double crosses_within = 4;  // [px] of the frame
constexpr double far_outside = 3000;  // [px] beyond this a point is held, so that the line's direction stays

bool is_dense(const std::vector<Spot>& spots, double period_columns) {
  std::vector<Spot> finite;
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for (const Spot& p : spots) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
    finite.push_back(p);
    left = std::min(left, p.x), right = std::max(right, p.x);
  }
  const bool swings = period_columns > band_columns && period_columns < swing_columns;
  const double most = swings ? swing_dots : dense_dots;
  if (static_cast<double>(finite.size()) < most * std::max(1.0, right - left)) return false;
  const Band band = min_max_band(finite, 1);
  double thickness = 0;
  for (std::size_t i = 0; i < band.x.size(); ++i) thickness += band.high[i] - band.low[i];
  return thickness > 2 * static_cast<double>(band.x.size());
}

/// A band for each piece, so that none is drawn where nothing was measured.
Band band_of_pieces(const std::vector<Spot>& spots, int columns) {
  Band all;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const auto& piece : unbroken(spots)) {
    const Band band = min_max_band(piece, columns);
    if (!all.x.empty())
      for (auto* values : {&all.x, &all.low, &all.high}) values->push_back(none);
    all.x.insert(all.x.end(), band.x.begin(), band.x.end());
    all.low.insert(all.low.end(), band.low.begin(), band.low.end());
    all.high.insert(all.high.end(), band.high.begin(), band.high.end());
  }
  return all;
}

/// Two strokes for each spot; one cross for several that would cover each other.
std::vector<std::vector<Spot>> crosses(const std::vector<Spot>& spots) {
  constexpr double reach = 2.2;  // [px]
  std::vector<std::vector<Spot>> strokes;
  std::set<std::pair<long, long>> taken;
  for (const Spot& p : spots) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
    if (!taken.emplace(std::lround(p.x / reach), std::lround(p.y / reach)).second) continue;
    strokes.push_back({{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}});
    strokes.push_back({{p.x - reach, p.y + reach}, {p.x + reach, p.y - reach}});
  }
  return strokes;
}

bool is_road(const Curve& curve) { return curve.road || curve.role == "exact"; }

/// Besides what was measured.
bool has_line(const Panel& panel) {
  return std::any_of(panel.curves.begin(), panel.curves.end(), [](const Curve& each) {
    return each.mark == Mark::line && each.role != "measured" && each.role != "grid";
  });
}

}  // namespace

std::vector<Spot> spots_of(const Curve& curve, const AxisRange& x, const AxisRange& y) {
  const std::size_t n = std::min(curve.x.size(), curve.y.size());
  std::vector<Spot> spots(n);
  const double beyond = curve.mark == Mark::crosses ? -crosses_within : far_outside;
  const double low_y = std::min(y.from, y.to) - beyond, high_y = std::max(y.from, y.to) + beyond;
  const double low_x = std::min(x.from, x.to) - far_outside, high_x = std::max(x.from, x.to) + far_outside;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < n; ++i) {
    const double px = x.px(curve.x[i]), py = y.px(curve.y[i]);
    if (std::isnan(px) || std::isnan(py))
      spots[i] = {none, none};
    else
      spots[i] = {std::clamp(px, low_x, high_x), std::clamp(py, low_y, high_y)};
  }
  return spots;
}

PlacedCurve place_curve(const Curve& curve, const std::vector<Spot>& spots, const Panel& panel) {
  const RoleStyle& style = style_of(curve.role);
  const bool alone = panel.curves.size() == 1;
  PlacedCurve placed;
  placed.colour = style.line;
  if (!alone) placed.dash = style.dash;
  if (curve.dashed && placed.dash[0] == 0) placed.dash = dashes;
  // In a strong colour a narrow one is seen as well.
  placed.width = is_road(curve)             ? (panel.phase_portrait || curve.road ? narrow_road : road_width)
                 : curve.role == "measured" ? measured_line
                                            : style.width * (alone ? 1 : figure_width);
  placed.mark = curve.mark;
  if (curve.mark == Mark::crosses) {
    placed.mark = Mark::line;
    placed.pieces = crosses(spots);
    return placed;
  }
  if (curve.mark != Mark::line && !curve.always_dots) {
    const double columns = columns_per_period(spots);
    const bool dense = is_dense(spots, columns);
    if (dense && columns <= band_columns) {
      placed.mark = Mark::band;
      placed.band = band_of_pieces(spots, std::max(1, static_cast<int>(std::ceil(columns)) + 1));
      return placed;
    }
    if (curve.mark == Mark::band || dense) {
      placed.mark = Mark::line;
      placed.width = measured_line;
    }
  }
  if (placed.mark == Mark::dots) {
    placed.pieces.push_back(thin_dots(spots, has_line(panel) && spots.size() > all_dots ? dots_apart : 0));
    placed.width = placed.pieces.back().size() <= few_dots ? few_dots_width : style_of("measured").width;
    return placed;
  }
  for (const auto& piece : unbroken(spots)) {
    if (piece.size() == 1 || curve.with_dots)
      placed.dots.insert(placed.dots.end(), piece.begin(), piece.end());
    placed.pieces.push_back(thin_line(piece));
  }
  return placed;
}

double height_at_end(const std::vector<Spot>& spots, const Box& frame) {
  std::vector<Spot> seen;
  for (const Spot& p : spots) {
    if (std::isfinite(p.x) && std::isfinite(p.y) && p.x >= frame.x - 0.5 && p.x <= frame.right() + 0.5)
      seen.push_back(p);
  }
  if (seen.empty()) return frame.y + frame.height / 2;
  std::stable_sort(seen.begin(), seen.end(), [](const Spot& a, const Spot& b) { return a.x < b.x; });
  const double from = frame.x + frame.width * 2 / 3;
  const double end = seen.back().y;
  // Backwards in time. A turning point counts once the curve has come back by 2 px: noise is no swing.
  constexpr double come_back = 2;
  double extreme = end, last_peak = end;
  int direction = 0, turns = 0;
  bool has_peak = false;
  for (std::size_t i = seen.size(); i-- > 0 && seen[i].x >= from;) {
    const double y = seen[i].y;
    if (direction == 0) {
      if (std::abs(y - end) > come_back) direction = y < end ? -1 : 1, extreme = y;
    } else if ((y - extreme) * direction > 0) {
      extreme = y;
    } else if (std::abs(y - extreme) > come_back) {
      if (direction < 0 && !has_peak) last_peak = extreme, has_peak = true;
      ++turns;
      direction = -direction;
      extreme = y;
    }
  }
  return std::clamp(has_peak && turns >= 2 ? last_peak : end, frame.y, frame.bottom());
}

}  // namespace cromer::core
