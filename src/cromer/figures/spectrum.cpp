#include "cromer/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <tuple>

#include "cromer/base/extent.h"
#include "cromer/base/length_unit.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/described/spectrum.h"
#include "cromer/documents/text.h"
#include "cromer/report/axis.h"
#include "cromer/report/enhanced_text.h"
#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

std::string damping_name(const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  const std::string name = result.hysteretic()
                               ? fmt::format("loss factor {:.4g}", spectrum.damping_ratio)
                               : fmt::format("{:.4g} % damping", 100 * spectrum.damping_ratio);
  return result.inelastic() ? fmt::format("{}, ductility {:.4g}", name, spectrum.ductility) : name;
}

/// The name of an axis whose curves all have the same damping ratio.
std::string at_one_damping(std::string_view quantity, const SpectrumResult& result, std::string_view unit) {
  return fmt::format("{} at {} ({})", quantity, damping_name(result, result.spectra[0]), unit);
}

/// The shade of a spectrum: the more damping, the lighter, whatever their order.
std::string family(const SpectrumResult& result, std::size_t i) {
  std::size_t less = 0;
  for (std::size_t k = 0; k < result.spectra.size(); ++k) {
    const double other = result.spectra[k].damping_ratio, own = result.spectra[i].damping_ratio;
    less += other < own || (other == own && k < i);
  }
  return family_role(less, result.spectra.size());
}

/// Sorts the points of a curve by their abscissa.
void sort_by_x(Curve& curve) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < curve.x.size(); ++i) points.emplace_back(curve.x[i], curve.y[i]);
  std::sort(points.begin(), points.end());
  for (std::size_t i = 0; i < points.size(); ++i) std::tie(curve.x[i], curve.y[i]) = points[i];
}

template <class Value>
Curve curve_of(const std::vector<double>& x, std::string name, std::string role, Value value) {
  Curve curve;
  curve.x = x;
  for (std::size_t i = 0; i < x.size(); ++i) curve.y.push_back(value(i));
  curve.name = std::move(name);
  curve.role = std::move(role);
  curve.with_dots = x.size() <= 2;
  sort_by_x(curve);
  return curve;
}

/// Whether the values are spread so widely that the axis is to be logarithmic.
bool wide(const std::vector<double>& x) {
  const auto [low, high] = extent_of(x);
  return high > 8 * low;
}

/// Periods or frequencies, as the oscillators were asked for.
struct Abscissa {
  std::vector<double> values;
  const char* name;
  const char* unit;
};

Abscissa abscissa_of(const SpectrumResult& result) {
  if (!result.by_frequency()) return {result.periods, "period {/:Italic T} (s)", "s"};
  std::vector<double> frequencies;
  for (const double period : result.periods) frequencies.push_back(1 / period);
  return {std::move(frequencies), "natural frequency (Hz)", "Hz"};
}

/// Adds the largest value of a curve as its remark: "1.2 g at 0.3 s".
void say_summit(Curve& curve, std::string_view value_unit, std::string_view at_unit) {
  const auto top = std::max_element(curve.y.begin(), curve.y.end(),
                                    [](double a, double b) { return a < b || std::isnan(a); }) -
                   curve.y.begin();
  const auto i = static_cast<std::size_t>(top);
  if (std::isnan(curve.y[i])) return;
  curve.remark =
      fmt::format("{} {} at {} {}", rounded(curve.y[i], 3), value_unit, rounded(curve.x[i], 3), at_unit);
}

/// Each label points to where its curve is farthest from all others.
void point_words(Panel& panel) {
  const auto height = [&](double y) { return panel.y.logarithmic ? std::log(y) : y; };
  for (Curve& curve : panel.curves) {
    double most = 0;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Curve& other : panel.curves)
        if (&other != &curve && other.x.size() == curve.x.size())
          nearest = std::min(nearest, std::abs(height(other.y[i]) - height(curve.y[i])));
      if (!std::isfinite(nearest) || nearest <= most || curve.y[i] < panel.y.low) continue;
      most = nearest;
      curve.label_x = curve.x[i];
      curve.label_y = curve.y[i];
    }
  }
}

/// Adds a curve for each damping ratio: the only component, or RotD50 of two. Adds nothing and returns false
/// for two components at a single damping ratio: there is room for more than RotD50 then.
template <class Add>
bool add_each_damping(const SpectrumResult& result, Add add) {
  const bool two = result.components.size() > 1;
  if (two && result.spectra.size() == 1) return false;
  for (std::size_t i = 0; i < result.spectra.size(); ++i) {
    const ResponseSpectrum& spectrum = result.spectra[i];
    add(two ? spectrum.rotd50 : spectrum.displacement[0],
        (two ? "RotD50, " : "") + damping_name(result, spectrum), family(result, i));
  }
  return true;
}

Panel response_panel(const SpectrumResult& result) {
  const double unit = written_acceleration(result);
  const Abscissa along = abscissa_of(result);
  Panel panel;
  panel.x.name = along.name;
  panel.x.logarithmic = wide(along.values);
  panel.y.name = fmt::format("pseudo-acceleration ({})", written_unit(result));
  panel.y.low = 0;
  panel.names_inside = true;
  const auto add = [&](const std::vector<double>& displacement, const std::string& name,
                       const std::string& role) {
    panel.curves.push_back(curve_of(along.values, name, role, [&](std::size_t i) {
      return pseudo_acceleration(displacement[i], result.periods[i]) / unit;
    }));
    say_summit(panel.curves.back(), written_unit(result), along.unit);
  };
  if (add_each_damping(result, add)) {
    point_words(panel);
    return panel;
  }
  const ResponseSpectrum& spectrum = result.spectra[0];
  panel.y.name = at_one_damping("pseudo-acceleration", result, written_unit(result));
  for (std::size_t c = 0; c < 2; ++c) {
    add(spectrum.displacement[c], figure_text(component_name(result, c)), "family:4");
    panel.curves.back().dashed = c == 1;
  }
  add(spectrum.geometric_mean, "geometric mean", "family:2");
  panel.curves.back().dashed = true;
  add(spectrum.rotd50, "RotD50", "family:2");
  add(spectrum.rotd100, "RotD100", "family:0");
  point_words(panel);
  return panel;
}

Panel shock_panel(const SpectrumResult& result) {
  const double unit = written_shock(result);
  const Abscissa along = abscissa_of(result);
  Panel panel;
  panel.x.name = along.name;
  panel.x.logarithmic = wide(along.values);
  panel.y.name = fmt::format("largest {} ({})", readable_response(result.shock_of), shock_unit(result));
  panel.y.logarithmic = true;
  panel.names_inside = true;
  const auto add = [&](const ResponseSpectrum& spectrum, const std::string& name, const std::string& role,
                       auto value) {
    panel.curves.push_back(curve_of(along.values, name, role, [&](std::size_t i) {
      const double shown = value(spectrum.shock[i]) / unit;
      return shown > 0 ? shown : std::nan("");
    }));
  };
  if (result.spectra.size() > 1) {
    for (std::size_t i = 0; i < result.spectra.size(); ++i) {
      add(result.spectra[i], damping_name(result, result.spectra[i]), family(result, i),
          [](const Shock& s) { return s.maximax(); });
      say_summit(panel.curves.back(), shock_unit(result), along.unit);
    }
  } else {
    const ResponseSpectrum& spectrum = result.spectra[0];
    panel.y.name =
        at_one_damping("largest " + readable_response(result.shock_of), result, shock_unit(result));
    // The maximax curve is drawn first, so that the curves it consists of show on top of it.
    add(spectrum, "maximax", "family:0", [](const Shock& s) { return s.maximax(); });
    add(spectrum, "positive", "positive", [](const Shock& s) { return s.positive; });
    add(spectrum, "primary", "family:4", [](const Shock& s) { return s.primary; });
    panel.curves.back().dashed = true;
    add(spectrum, "residual", "family:4", [](const Shock& s) { return s.residual; });
    add(spectrum, "negative", "negative", [](const Shock& s) { return s.negative; });
    for (Curve& curve : panel.curves) say_summit(curve, shock_unit(result), along.unit);
  }
  // Values more than three decades below the largest do not matter, but the curve of the largest is whole.
  double top = 0, least = std::numeric_limits<double>::infinity(), least_of_largest = least;
  for (const Curve& curve : panel.curves) {
    const bool largest = &curve == &panel.curves.front();
    for (const double y : curve.y)
      if (y > 0 && std::isfinite(y)) {
        top = std::max(top, y), least = std::min(least, y);
        if (largest) least_of_largest = std::min(least_of_largest, y);
      }
  }
  const double low =
      top > 0 ? std::min(std::pow(10.0, std::floor(std::log10(top)) - 2), least_of_largest) : 0;
  if (least < low) panel.y.low = low;
  point_words(panel);
  return panel;
}

}  // namespace

Figure spectrum_figure(const SpectrumResult& result) {
  Figure figure;
  figure.id = "spectrum";
  const bool shock = result.options.shock;
  figure.title = shock ? "Shock response spectrum" : "Response spectrum";
  figure.size = FigureSize::single;
  figure.panels.push_back(shock ? shock_panel(result) : response_panel(result));
  figure.note = correction_text(result.correction, true);
  return figure;
}

// The slanting lines of a tripartite plot.
namespace {

/// The ranges of the two axes: period or natural frequency, and pseudo-velocity.
struct Frame {
  double x0, x1, v0, v1;

  /// Places in the frame, 0 to 1 from left to right and from bottom to top.
  double across(double x) const { return std::log(x / x0) / std::log(x1 / x0); }
  double up(double v) const { return std::log(v / v0) / std::log(v1 / v0); }
  double x_at(double across) const { return x0 * std::pow(x1 / x0, across); }
};

Frame frame_of(const Panel& panel) {
  Frame frame{1e300, 0, 1e300, 0};
  for (const Curve& curve : panel.curves)
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      frame.x0 = std::min(frame.x0, curve.x[i]);
      frame.x1 = std::max(frame.x1, curve.x[i]);
      if (!(curve.y[i] > 0)) continue;
      frame.v0 = std::min(frame.v0, curve.y[i]);
      frame.v1 = std::max(frame.v1, curve.y[i]);
    }
  if (!(frame.x1 > frame.x0)) frame = {frame.x0 / 2, frame.x1 * 2, frame.v0, frame.v1};
  if (!(frame.v1 >= frame.v0)) frame.v0 = 0.1, frame.v1 = 1;
  frame.v0 /= 1.5;
  frame.v1 *= 4;  // room for the numbers of the lines
  return frame;
}

/// Powers of ten in the range; over less than two and a half decades their doubles and fives as well.
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

/// Whether a number with its left edge at `x` and its middle at `y` would cover a curve or another number.
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

/// A line of equal displacement or pseudo-acceleration: v = factor x, or factor / x where it falls.
struct EqualLine {
  double factor;
  bool rises;

  double v(double x) const { return rises ? factor * x : factor / x; }
  double x(double v) const { return rises ? v / factor : factor / v; }
};

/// Adds the line, cut to the frame, with its number on it.
void add_line(Panel& panel, std::vector<Curve>& lines, const Frame& f, const EqualLine& equal,
              const std::string& number) {
  const double low = std::max(f.x0, std::min(equal.x(f.v0), equal.x(f.v1)));
  const double high = std::min(f.x1, std::max(equal.x(f.v0), equal.x(f.v1)));
  if (!(high > low)) return;
  Curve line;
  line.role = "grid";
  line.x = {low, high};
  line.y = {equal.v(low), equal.v(high)};
  lines.push_back(line);
  // The first place from the upper end inward where the number covers nothing.
  const double end = equal.rises ? f.across(high) : f.across(low);
  for (double inward = 0.01; inward < 0.3; inward += 0.01) {
    const double x = equal.rises ? end - inward : end + inward;
    const double y = f.up(equal.v(f.x_at(x)));
    const double from = equal.rises ? x - number_width : x;
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

/// Sets the ranges of the axes (pseudo-velocity [m/s] against period [s] or natural frequency [Hz], both
/// logarithmic), and draws lines of equal displacement and of equal pseudo-acceleration under the curves.
void add_equal_lines(Panel& panel, const SpectrumResult& result) {
  const Frame f = frame_of(panel);
  panel.x.low = f.x0;
  panel.x.high = f.x1;
  panel.y.low = f.v0;
  panel.y.high = f.v1;
  std::vector<Curve> lines;
  const auto [t0, t1] = result.by_frequency() ? std::pair(1 / f.x1, 1 / f.x0) : std::pair(f.x0, f.x1);
  const double unit = written_acceleration(result);
  for (const double a : round_values(two_pi * f.v0 / t1 / unit, two_pi * f.v1 / t0 / unit))
    add_line(panel, lines, f, {a * unit / two_pi, !result.by_frequency()},
             fmt::format("{} {}", tick_label(a), written_unit(result)));
  for (const double d : round_values(f.v0 * t0 / two_pi, f.v1 * t1 / two_pi)) {
    const LengthUnit length = length_unit(d * 1.0000001);
    add_line(panel, lines, f, {d * two_pi, result.by_frequency()},
             fmt::format("{} {}", tick_label(d / length.metres), length.symbol));
  }
  panel.curves.insert(panel.curves.begin(), lines.begin(), lines.end());
}

}  // namespace

namespace {

Panel tripartite_panel(const SpectrumResult& result) {
  Panel panel;
  panel.names_inside = true;
  panel.x.name = abscissa_of(result).name;
  panel.y.name = "pseudo-velocity (m/s)";
  panel.x.logarithmic = panel.y.logarithmic = true;
  return panel;
}

}  // namespace

Figure tripartite_figure(const SpectrumResult& result) {
  Panel panel = tripartite_panel(result);
  const Abscissa along = abscissa_of(result);
  const auto add = [&](const std::vector<double>& displacement, const std::string& name,
                       const std::string& role) {
    panel.curves.push_back(curve_of(along.values, name, role, [&](std::size_t i) {
      return pseudo_velocity(displacement[i], result.periods[i]);
    }));
  };
  const bool shock = result.options.shock;
  if (shock) {
    panel.y.name = "largest pseudo-velocity (m/s)";
    for (std::size_t s = 0; s < result.spectra.size(); ++s)
      panel.curves.push_back(curve_of(along.values, damping_name(result, result.spectra[s]),
                                      family(result, s),
                                      [&](std::size_t i) { return result.spectra[s].shock[i].maximax(); }));
  } else if (!add_each_damping(result, add)) {
    panel.y.name = at_one_damping("pseudo-velocity", result, "m/s");
    add(result.spectra[0].rotd50, "RotD50", "family:2");
    add(result.spectra[0].rotd100, "RotD100", "family:0");
  }
  point_words(panel);
  add_equal_lines(panel, result);
  Figure figure;
  figure.id = "spectrum";
  figure.title = shock ? "Tripartite shock response spectrum" : "Tripartite response spectrum";
  figure.size = FigureSize::single;
  figure.panels.push_back(std::move(panel));
  figure.note = correction_text(result.correction, true);
  return figure;
}

// Many motions.
namespace {

/// What is drawn of a motion at each period: PSA [m/s^2], PSV [m/s] or the maximax [m/s^2].
std::vector<double> heights_of(const SpectrumResult& result, const ResponseSpectrum& spectrum,
                               bool tripartite) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < result.periods.size(); ++i) {
    const double displacement = !spectrum.rotd50.empty() ? spectrum.rotd50[i]
                                : spectrum.shock.empty() ? spectrum.displacement[0][i]
                                                         : 0;
    heights.push_back(!spectrum.shock.empty() ? spectrum.shock[i].maximax() / written_shock(result)
                      : tripartite            ? pseudo_velocity(displacement, result.periods[i])
                                              : pseudo_acceleration(displacement, result.periods[i]) /
                                         written_acceleration(result));
  }
  return heights;
}

/// The value that a share of the sorted values stay below, between its neighbours by a straight line.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sorted.size()) return sorted.back();
  return std::lerp(sorted[below], sorted[below + 1], place - static_cast<double>(below));
}

constexpr std::size_t most_named = 10, most_drawn = 100;

bool at_the_same_places(const std::vector<Curve>& curves) {
  return std::all_of(curves.begin(), curves.end(), [&](const Curve& c) { return c.x == curves.front().x; });
}

/// Puts the median, the bounds of 16 and 84 % and the ends of the range over the curves, or in their place.
void add_statistics(Panel& panel) {
  const std::vector<Curve> all = panel.curves;
  std::vector<std::vector<double>> at(all.front().x.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (const Curve& each : all) at[i].push_back(each.y[i]);
    std::sort(at[i].begin(), at[i].end());
  }
  const auto add = [&](double share, const char* name, const char* role, bool dashed) {
    Curve& curve = panel.curves.emplace_back();
    curve.name = name;
    curve.role = role;
    curve.dashed = dashed;
    curve.x = all.front().x;
    for (const auto& values : at) curve.y.push_back(quantile(values, share));
  };
  const bool alone = all.size() > most_drawn;
  if (alone) panel.curves.clear();
  if (alone) add(1, "highest", "family:4", false);
  add(0.84, "84 %", "family:2", true);
  add(0.5, fmt::format("median of {}", all.size()).c_str(), "family:0", false);
  add(0.16, "16 %", "family:2", true);
  if (alone) add(0, "lowest", "family:4", false);
}

/// "pseudo-acceleration (g)", or what else the panels of many motions show.
std::string height_name(const SpectrumResult& result, bool tripartite) {
  const std::string quantity = result.options.shock ? "largest " + readable_response(result.shock_of)
                               : tripartite         ? "pseudo-velocity"
                                                    : "pseudo-acceleration";
  return fmt::format("{}{} ({})", quantity, result.components.size() > 1 ? ", RotD50" : "",
                     tripartite             ? "m/s"
                     : result.options.shock ? shock_unit(result)
                                            : written_unit(result));
}

Panel panel_of_motions(std::span<const SpectrumResult* const> results, std::span<const std::string> names,
                       std::size_t damping, bool tripartite) {
  const SpectrumResult& any = *results.front();
  Panel panel = tripartite ? tripartite_panel(any) : Panel{};
  panel.names_inside = true;
  panel.title = damping_name(any, any.spectra[damping]);
  panel.y.name = height_name(any, tripartite);
  const bool named = results.size() <= most_named;
  panel.names_listed = named;
  for (std::size_t m = 0; m < results.size(); ++m) {
    const SpectrumResult& result = *results[m];
    const Abscissa along = abscissa_of(result);
    const std::vector<double> heights = heights_of(result, result.spectra[damping], tripartite);
    Curve curve = curve_of(along.values, named ? figure_text(names[m]) : "",
                           named ? family_role(m / 2, (results.size() + 1) / 2) : "one-of-many",
                           [&](std::size_t i) { return heights[i]; });
    curve.dashed = named && m % 2 == 1;
    if (named && !tripartite)
      say_summit(curve, result.options.shock ? shock_unit(result) : written_unit(result), along.unit);
    panel.curves.push_back(std::move(curve));
  }
  if (!tripartite) {
    const Abscissa along = abscissa_of(any);
    panel.x.name = along.name;
    panel.x.logarithmic = wide(along.values);
    panel.y.logarithmic = any.options.shock;
    if (!any.options.shock) panel.y.low = 0;
  }
  if (!named) panel.curves.front().name = "each motion";
  if (!named && at_the_same_places(panel.curves)) add_statistics(panel);
  if (!named) point_words(panel);
  if (tripartite) add_equal_lines(panel, any);
  return panel;
}

}  // namespace

Figure spectra_figure(std::span<const MotionSpectra> motions, bool tripartite) {
  const std::vector<std::string> all_names = motion_names(motions);
  std::vector<const SpectrumResult*> results;
  std::vector<std::string> names;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    if (!motions[m].succeeded()) continue;
    results.push_back(&*motions[m].result);
    names.push_back(all_names[m]);
  }
  Figure figure;
  figure.id = "spectra";
  const bool shock = results[0]->options.shock;
  figure.title = tripartite ? (shock ? "Tripartite shock response spectra" : "Tripartite response spectra")
                 : shock    ? "Shock response spectra"
                            : "Response spectra";
  figure.size = FigureSize::single;
  for (std::size_t r = 0; r < results[0]->spectra.size(); ++r)
    figure.panels.push_back(panel_of_motions(results, names, r, tripartite));
  figure.note = correction_text(results[0]->correction, true);
  return figure;
}

}  // namespace cromer::core
