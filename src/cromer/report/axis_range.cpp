#include "cromer/report/axis_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cromer {
namespace {

constexpr double room = 0.05;  // of the span, above and below the data
constexpr double phase_room = 0.10;
constexpr double near_zero = 0.4;  // data that begin this close to 0, against their span, are shown from 0

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  void take(double value, bool logarithmic) {
    if (!std::isfinite(value) || (logarithmic && value <= 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

void widen(Extent& e, double share, bool logarithmic) {
  if (logarithmic) {
    const double factor = std::pow(e.high / e.low, share);
    e.low /= factor, e.high *= factor;
  } else {
    const double extra = share * (e.high - e.low);
    e.low -= extra, e.high += extra;
  }
}

// An empty or single-valued extent becomes one that can be drawn.
void open_up(Extent& e, bool logarithmic) {
  if (!(e.low <= e.high)) e.low = logarithmic ? 1 : 0, e.high = logarithmic ? 10 : 1;
  if (e.high - e.low > 1e-12 * std::max(std::abs(e.low), std::abs(e.high))) return;
  if (logarithmic) {
    e.low /= 2, e.high *= 2;
  } else {
    const double half = e.high != 0 ? 0.1 * std::abs(e.high) : 1;
    e.low -= half, e.high += half;
  }
}

AxisRange finish(Extent e, const Axis& axis) {
  if (std::isfinite(axis.low) && !(axis.logarithmic && axis.low <= 0)) e.low = axis.low;
  if (std::isfinite(axis.high) && !(axis.logarithmic && axis.high <= 0)) e.high = axis.high;
  if (e.low > e.high) std::swap(e.low, e.high);
  open_up(e, axis.logarithmic);
  return {e.low, e.high, axis.logarithmic, 0, 1};
}

void phase_extent(Extent& e, bool logarithmic) {
  if (!logarithmic && e.low < 0 && e.high > 0) {
    const double reach = std::max(-e.low, e.high);
    e.low = -reach, e.high = reach;
  }
  widen(e, phase_room / 2, logarithmic);
}

}  // namespace

double AxisRange::px(double value) const {
  if (logarithmic) {
    if (value <= 0) return std::numeric_limits<double>::quiet_NaN();
    return from + (to - from) * std::log(value / low) / std::log(high / low);
  }
  return from + (to - from) * ((value - low) / (high - low));
}

AxisRange x_range(const Panel& panel) {
  Extent e;
  for (const Curve& curve : panel.curves) {
    for (const double x : curve.x) e.take(x, panel.x.logarithmic);
  }
  for (const Marker& marker : panel.markers) e.take(marker.x, panel.x.logarithmic);
  open_up(e, panel.x.logarithmic);
  if (panel.phase_portrait) phase_extent(e, panel.x.logarithmic);
  return finish(e, panel.x);
}

AxisRange y_range(const Panel& panel, const AxisRange& x) {
  const bool logarithmic = panel.y.logarithmic;
  Extent e;
  for (const Curve& curve : panel.curves) {
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
      if (curve.x[i] >= x.low && curve.x[i] <= x.high) e.take(curve.y[i], logarithmic);
    }
  }
  open_up(e, logarithmic);
  if (panel.phase_portrait) {
    phase_extent(e, logarithmic);
  } else {
    const double low = e.low, high = e.high;
    widen(e, room, logarithmic);
    if (!logarithmic && low >= 0 && low < near_zero * (high - low)) e.low = 0;
    if (!logarithmic && high <= 0 && -high < near_zero * (high - low)) e.high = 0;
  }
  return finish(e, panel.y);
}

std::vector<Tick> ticks_of(const Axis& axis, const AxisRange& range, int most) {
  if (range.logarithmic) return logarithmic_ticks(range.low, range.high, most);
  const double step = axis.step > 0 && (range.high - range.low) / axis.step < 100
                          ? axis.step
                          : tick_step(range.low, range.high, most);
  return linear_ticks(range.low, range.high, step);
}

}  // namespace cromer
