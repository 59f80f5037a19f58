#include "cromer/report/axis.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace cromer::core {
namespace {

constexpr double slack = 1e-6;  // of a step: a tick that rounding put just outside still belongs
constexpr int most_ticks = 1000;

std::string fixed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  if (text == "-0") return "0";
  if (text.front() == '-') text.replace(0, 1, "−");
  return text;
}

int exponent_of(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-12)); }

bool is_plain(int exponent) { return exponent >= -3 && exponent < 4; }

/// Four digits, and as many more as tell the value from one so far apart.
std::string label_of(double value, bool plain, double apart = HUGE_VAL) {
  if (value == 0) return "0";
  const int exponent = exponent_of(value);
  constexpr int most = 12;
  const int needed = std::isfinite(apart) ? 1 - exponent_of(apart) : 0;
  if (plain) {
    const int four = 3 - std::max(exponent, 0) + (exponent < 0 ? -exponent - 1 : 0);
    return fixed(value, std::clamp(std::max(four, needed), 0, most));
  }
  const std::string mantissa =
      fixed(value / std::pow(10.0, exponent), std::clamp(exponent + needed, 2, most));
  return fmt::format("{}×10^{{{}}}", mantissa, fixed(exponent, 0));
}

}  // namespace

double tick_step(double low, double high, int most) {
  const double span = high - low;
  if (!(span > 0) || !std::isfinite(span)) return 1;
  for (int exponent = exponent_of(span / most) - 1;; ++exponent) {
    for (const double mantissa : {1.0, 2.0, 2.5, 5.0}) {
      const double step = mantissa * std::pow(10.0, exponent);
      const double count = std::floor(high / step + slack) - std::ceil(low / step - slack) + 1;
      if (count <= most) return step;
    }
  }
}

std::vector<Tick> linear_ticks(double low, double high, double step) {
  std::vector<Tick> ticks;
  const double first = std::ceil(low / step - slack);
  const double last = std::min(std::floor(high / step + slack), first + most_ticks - 1);
  // All numbers of an axis have the same form.
  const bool plain = is_plain(exponent_of(step * std::max(std::abs(first), std::abs(last))));
  for (double n = first; n <= last; ++n) ticks.push_back({n * step, label_of(n * step, plain, step)});
  return ticks;
}

std::vector<Tick> logarithmic_ticks(double low, double high, int most) {
  const int first = static_cast<int>(std::floor(std::log10(low) - slack));
  const int last = static_cast<int>(std::ceil(std::log10(high) + slack));
  const auto inside = [&](double value) { return value >= low * (1 - slack) && value <= high * (1 + slack); };
  int decades = 0;
  bool plain = true;  // all numbers have the same form
  for (int e = first; e <= last; ++e) {
    if (!inside(std::pow(10.0, e))) continue;
    ++decades;
    plain = plain && is_plain(e);
  }
  if (decades == 0) plain = is_plain(first);
  const int stride = std::max(1, (decades + most - 1) / std::max(most, 1));
  std::vector<Tick> ticks;
  for (int e = first; e <= last; ++e) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, e);
      if (!inside(value)) continue;
      const bool labelled =
          decades >= 3 ? digit == 1 && e % stride == 0 : digit == 1 || digit == 2 || digit == 5;
      if (!labelled && decades > 2 * most) continue;
      ticks.push_back({value, !labelled             ? ""
                              : plain || digit != 1 ? label_of(value, plain)
                                                    : fmt::format("10^{{{}}}", fixed(e, 0))});
    }
  }
  return ticks;
}

std::string tick_label(double value) { return label_of(value, is_plain(exponent_of(value))); }

namespace {

constexpr double room = 0.05;  // of the span, above and below the data
constexpr double phase_room = 0.10;
constexpr double beside_bars = 0.03;     // of the span: error bars do not stand on the frame
constexpr double given_to_ticks = 0.25;  // of the span, given away at most to end at ticks
constexpr double just_beyond = 0.01;     // of the span: an x axis goes on to a tick this near
constexpr double near_zero = 0.6;  // data that begin this close to 0, against their span, are shown from 0

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  void take(double value, bool logarithmic) {
    // Beyond 1e300 spans and ticks overflow.
    if (!(std::abs(value) < 1e300) || (logarithmic && value <= 0)) return;
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

constexpr double double_precision = 1e-12;  // of the values
constexpr double rounding = 1e-9;           // of computed values: what differs by less is one value

// An empty or single-valued extent becomes one that can be drawn.
void open_up(Extent& e, bool logarithmic, double least = double_precision) {
  if (!(e.low <= e.high)) e.low = logarithmic ? 1 : 0, e.high = logarithmic ? 10 : 1;
  if (e.high - e.low > least * std::max(std::abs(e.low), std::abs(e.high))) return;
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
  return {e.low, e.high, axis.logarithmic, 0, 1, 0};
}

// Widens the extent to ticks, by the step of 3 to 6 ticks that adds least. 0 if each would add too much.
double round_to_ticks(Extent& e) {
  const double span = e.high - e.low;
  Extent best = e;
  double best_step = 0;
  for (int most = 3; most <= 6; ++most) {
    const double step =
        tick_step(e.low - given_to_ticks * span / 2, e.high + given_to_ticks * span / 2, most);
    const Extent rounded{step * std::floor(e.low / step + 1e-6), step * std::ceil(e.high / step - 1e-6)};
    const double length = rounded.high - rounded.low, ticks = std::round(length / step) + 1;
    if (length > (1 + given_to_ticks) * span || ticks < 3 || ticks > 6) continue;
    // The curve should not run along the frame.
    const bool touches = (rounded.low != 0 && e.low - rounded.low < 0.01 * span) ||
                         (rounded.high != 0 && rounded.high - e.high < 0.01 * span);
    if (touches || (best_step != 0 && length >= best.high - best.low)) continue;
    best = rounded, best_step = step;
  }
  e = best;
  return best_step;
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

namespace {

bool are_error_bars(const Curve& curve) { return curve.role == "measured" && curve.mark == Mark::line; }

}  // namespace

AxisRange x_range(const Panel& panel) {
  Extent e;
  for (const Curve& curve : panel.curves) {
    for (const double x : curve.x) e.take(x, panel.x.logarithmic);
  }
  for (const Marker& marker : panel.markers) e.take(marker.x, panel.x.logarithmic);
  open_up(e, panel.x.logarithmic);
  if (std::any_of(panel.curves.begin(), panel.curves.end(), are_error_bars))
    widen(e, beside_bars, panel.x.logarithmic);
  if (!panel.phase_portrait && !panel.x.logarithmic) {
    const double span = e.high - e.low, step = panel.x.step > 0 ? panel.x.step : tick_step(e.low, e.high, 7);
    const double below = step * std::floor(e.low / step + 1e-6),
                 above = step * std::ceil(e.high / step - 1e-6);
    if (e.low - below < just_beyond * span) e.low = below;
    if (above - e.high < just_beyond * span) e.high = above;
  }
  if (panel.phase_portrait) phase_extent(e, panel.x.logarithmic);
  return finish(e, panel.x);
}

AxisRange y_range(const Panel& panel, const AxisRange& x) {
  const bool logarithmic = panel.y.logarithmic;
  Extent e;
  for (const Curve& curve : panel.curves) {
    if (!curve.sets_axes) continue;
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
      if (curve.x[i] >= x.low && curve.x[i] <= x.high) e.take(curve.y[i], logarithmic);
    }
  }
  open_up(e, logarithmic, rounding);
  if (panel.phase_portrait) {
    phase_extent(e, logarithmic);
    return finish(e, panel.y);
  }
  const double low = e.low, high = e.high, span = high - low;
  if (logarithmic) {
    // What is cut off needs no room.
    if (panel.y.low > 0) e.low = std::clamp(panel.y.low, e.low, e.high);
    if (panel.y.high > 0) e.high = std::clamp(panel.y.high, e.low, e.high);
    open_up(e, true);
    widen(e, room, true);
    return finish(e, panel.y);
  }
  if (low >= 0 && low < near_zero * span) e.low = 0;
  if (high <= 0 && -high < near_zero * span) e.high = 0;
  const bool free = std::isnan(panel.y.low) && std::isnan(panel.y.high) && panel.y.step <= 0;
  const double step = free ? round_to_ticks(e) : 0;
  if (step == 0) {
    if (e.low != 0) e.low -= room * span;
    if (e.high != 0) e.high += room * span;
  }
  AxisRange range = finish(e, panel.y);
  range.step = step;
  return range;
}

namespace {

std::vector<Tick> with_points(const Axis& axis, const AxisRange& range, int most) {
  if (range.logarithmic) return logarithmic_ticks(range.low, range.high, most);
  const double step = axis.step > 0 && (range.high - range.low) / axis.step < 100
                          ? axis.step
                          : tick_step(range.low, range.high, most);
  return linear_ticks(range.low, range.high, step);
}

}  // namespace

std::vector<Tick> ticks_of(const Axis& axis, const AxisRange& range, int most) {
  std::vector<Tick> ticks = with_points(axis, range, most);
  if (axis.decimal_comma)
    for (Tick& tick : ticks) std::replace(tick.label.begin(), tick.label.end(), '.', ',');
  return ticks;
}

}  // namespace cromer::core
