#include "cromer/figures/equal_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/analysis/ground_motion.h"
#include "cromer/base/pi.h"
#include "cromer/figures/length_unit.h"
#include "cromer/report/axis.h"

namespace cromer::core {
namespace {

/// What the panel shows.
struct Frame {
  double t0, t1, v0, v1;

  /// 0 to 1 from left to right and from bottom to top.
  double across(double t) const { return std::log(t / t0) / std::log(t1 / t0); }
  double up(double v) const { return std::log(v / v0) / std::log(v1 / v0); }
  double t_at(double across) const { return t0 * std::pow(t1 / t0, across); }
  double v_at(double up) const { return v0 * std::pow(v1 / v0, up); }
};

Frame frame_of(const Panel& panel) {
  Frame frame{1e300, 0, 1e300, 0};
  for (const Curve& curve : panel.curves)
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      frame.t0 = std::min(frame.t0, curve.x[i]);
      frame.t1 = std::max(frame.t1, curve.x[i]);
      if (!(curve.y[i] > 0)) continue;
      frame.v0 = std::min(frame.v0, curve.y[i]);
      frame.v1 = std::max(frame.v1, curve.y[i]);
    }
  if (!(frame.t1 > frame.t0)) frame = {frame.t0 / 2, frame.t1 * 2, frame.v0, frame.v1};
  if (!(frame.v1 >= frame.v0)) frame.v0 = 0.1, frame.v1 = 1;
  frame.v0 /= 1.5;
  frame.v1 *= 4;  // the numbers of the lines stand there
  return frame;
}

/// Powers of ten, or 1, 2 and 5 of them within less than two decades.
std::vector<double> round_values(double low, double high) {
  std::vector<double> values;
  const bool few = high < 300 * low;
  for (int decade = static_cast<int>(std::floor(std::log10(low))); decade <= std::log10(high); ++decade)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double value = digit * std::pow(10.0, decade);
      if ((few || digit == 1) && value >= low && value <= high) values.push_back(value);
    }
  return values;
}

constexpr double number_width = 0.085, number_height = 0.05;  // of the frame

/// A number with its left edge at `x`, its middle at `y`, would stand on a curve or on another number.
bool covers(const Panel& panel, const Frame& f, double x, double y) {
  for (const Curve& curve : panel.curves)
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      const double at = f.across(curve.x[i]);
      if (at > x - 0.02 && at < x + number_width + 0.02 && std::abs(f.up(curve.y[i]) - y) < number_height)
        return true;
    }
  for (const Note& note : panel.notes)
    if (std::abs(note.text_x - x) < number_width && std::abs(note.text_y - y) < number_height) return true;
  return false;
}

/// The line v = level (t/2 pi)^slope, cut to the frame, and its number on it.
void add_line(Panel& panel, std::vector<Curve>& lines, const Frame& f, double level, int slope,
              const std::string& number) {
  const auto v_of = [&](double t) { return slope > 0 ? level * t / two_pi : level * two_pi / t; };
  const auto t_of = [&](double v) { return slope > 0 ? two_pi * v / level : two_pi * level / v; };
  const double low = std::max(f.t0, std::min(t_of(f.v0), t_of(f.v1)));
  const double high = std::min(f.t1, std::max(t_of(f.v0), t_of(f.v1)));
  if (!(high > low)) return;
  Curve line;
  line.role = "grid";
  line.x = {low, high};
  line.y = {v_of(low), v_of(high)};
  lines.push_back(line);
  // From the upper end inward: the first place where the number covers no curve.
  const double end = slope > 0 ? f.across(high) : f.across(low);
  for (double inward = 0.01; inward < 0.3; inward += 0.01) {
    const double x = slope > 0 ? end - inward : end + inward;
    const double y = f.up(v_of(f.t_at(x)));
    const double from = slope > 0 ? x - number_width : x;
    if (from < 0 || from + number_width > 1 || y < 0.06 || y > 0.97 || covers(panel, f, from, y)) continue;
    Note note;
    note.leader = false;
    note.text = number;
    note.text_x = from;
    note.text_y = y;
    panel.notes.push_back(note);
    return;
  }
}

}  // namespace

void add_equal_lines(Panel& panel, bool in_g) {
  const Frame f = frame_of(panel);
  panel.x.low = f.t0;
  panel.x.high = f.t1;
  panel.y.low = f.v0;
  panel.y.high = f.v1;
  std::vector<Curve> lines;
  const double unit = in_g ? standard_gravity : 1;
  for (const double a : round_values(two_pi * f.v0 / f.t1 / unit, two_pi * f.v1 / f.t0 / unit))
    add_line(panel, lines, f, a * unit, 1, fmt::format("{} {}", tick_label(a), in_g ? "g" : "m/s²"));
  for (const double d : round_values(f.v0 * f.t0 / two_pi, f.v1 * f.t1 / two_pi)) {
    const LengthUnit length = length_unit(d * 1.0000001);
    add_line(panel, lines, f, d, -1, fmt::format("{} {}", tick_label(d / length.metres), length.symbol));
  }
  panel.curves.insert(panel.curves.begin(), lines.begin(), lines.end());
}

}  // namespace cromer::core
