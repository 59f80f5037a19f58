#include "cromer/figures/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "cromer/base/quantity.h"
#include "cromer/documents/csv/spectrum_columns.h"
#include "cromer/figures/equal_lines.h"
#include "cromer/report/palette.h"

namespace cromer::core {
namespace {

std::string damping_name(const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  return result.hysteretic() ? fmt::format("loss factor {:.4g}", spectrum.damping_ratio)
                             : fmt::format("{:.4g} % damping", 100 * spectrum.damping_ratio);
}

/// The axis of curves that share a damping ratio, which their names leave out.
std::string at_one_damping(const char* quantity, const SpectrumResult& result, const char* unit) {
  return fmt::format("{} at {} ({})", quantity, damping_name(result, result.spectra[0]), unit);
}

/// Dark to light with the damping, in whatever order it was asked for.
std::string family(const SpectrumResult& result, std::size_t i) {
  std::size_t less = 0;
  for (std::size_t k = 0; k < result.spectra.size(); ++k) {
    const double other = result.spectra[k].damping_ratio, own = result.spectra[i].damping_ratio;
    less += other < own || (other == own && k < i);
  }
  return family_role(less, result.spectra.size());
}

/// Points of a curve in the order of their abscissa.
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

/// Periods of several decades, evenly chosen on a line, are best seen on a logarithmic axis.
bool wide(const std::vector<double>& x) {
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  return *high > 8 * *low;
}

/// The abscissa that the oscillators were asked for by.
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

const char* acceleration_unit(const SpectrumResult& result) { return result.options.in_g ? "g" : "m/s²"; }

/// The value at the top of a curve: "1.2 g at 0.3 s".
void say_summit(Curve& curve, const char* value_unit, const char* at_unit) {
  const auto top = std::max_element(curve.y.begin(), curve.y.end(),
                                    [](double a, double b) { return a < b || std::isnan(a); }) -
                   curve.y.begin();
  const auto i = static_cast<std::size_t>(top);
  if (std::isnan(curve.y[i])) return;
  curve.remark =
      fmt::format("{} {} at {} {}", rounded(curve.y[i], 3), value_unit, rounded(curve.x[i], 3), at_unit);
}

/// Words point to where a curve is furthest from all others.
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

Panel response_panel(const SpectrumResult& result) {
  const double unit = result.options.in_g ? standard_gravity : 1;
  const Abscissa along = abscissa_of(result);
  Panel panel;
  panel.x.name = along.name;
  panel.x.logarithmic = wide(along.values);
  panel.y.name = fmt::format("pseudo-acceleration ({})", acceleration_unit(result));
  panel.y.low = 0;
  panel.names_inside = true;
  const auto add = [&](const std::vector<double>& displacement, const std::string& name,
                       const std::string& role) {
    panel.curves.push_back(curve_of(along.values, name, role, [&](std::size_t i) {
      return pseudo_acceleration(displacement[i], result.periods[i]) / unit;
    }));
    say_summit(panel.curves.back(), acceleration_unit(result), along.unit);
  };
  if (result.components.size() == 1) {
    for (std::size_t i = 0; i < result.spectra.size(); ++i)
      add(result.spectra[i].displacement[0], damping_name(result, result.spectra[i]), family(result, i));
    point_words(panel);
    return panel;
  }
  if (result.spectra.size() > 1) {
    for (std::size_t i = 0; i < result.spectra.size(); ++i)
      add(result.spectra[i].rotd50, "RotD50, " + damping_name(result, result.spectra[i]), family(result, i));
    point_words(panel);
    return panel;
  }
  const ResponseSpectrum& spectrum = result.spectra[0];
  panel.y.name = at_one_damping("pseudo-acceleration", result, acceleration_unit(result));
  for (std::size_t c = 0; c < 2; ++c) {
    add(spectrum.displacement[c], component_name(result, c), "family:4");
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
  const double unit = result.options.in_g ? standard_gravity : 1;
  const Abscissa along = abscissa_of(result);
  Panel panel;
  panel.x.name = along.name;
  panel.x.logarithmic = wide(along.values);
  panel.y.name = fmt::format("largest acceleration ({})", acceleration_unit(result));
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
      say_summit(panel.curves.back(), acceleration_unit(result), along.unit);
    }
  } else {
    const ResponseSpectrum& spectrum = result.spectra[0];
    panel.y.name = at_one_damping("largest acceleration", result, acceleration_unit(result));
    // The largest lies lowest, so that what it is the largest of shows on it.
    add(spectrum, "maximax", "family:0", [](const Shock& s) { return s.maximax(); });
    add(spectrum, "positive", "positive", [](const Shock& s) { return s.positive; });
    add(spectrum, "primary", "family:4", [](const Shock& s) { return s.primary; });
    panel.curves.back().dashed = true;
    add(spectrum, "residual", "family:4", [](const Shock& s) { return s.residual; });
    add(spectrum, "negative", "negative", [](const Shock& s) { return s.negative; });
    for (Curve& curve : panel.curves) say_summit(curve, acceleration_unit(result), along.unit);
  }
  // Three decades below the top what is left is of no consequence.
  double top = 0, least = std::numeric_limits<double>::infinity();
  for (const Curve& curve : panel.curves)
    for (const double y : curve.y)
      if (std::isfinite(y)) top = std::max(top, y), least = std::min(least, y);
  const double low = top > 0 ? std::pow(10.0, std::floor(std::log10(top)) - 2) : 0;
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
  return figure;
}

Figure tripartite_figure(const SpectrumResult& result) {
  Panel panel;
  panel.names_inside = true;
  panel.x.name = "period {/:Italic T} (s)";
  panel.y.name = "pseudo-velocity (m/s)";
  panel.x.logarithmic = panel.y.logarithmic = true;
  const auto add = [&](const std::vector<double>& displacement, const std::string& name,
                       const std::string& role) {
    panel.curves.push_back(curve_of(result.periods, name, role, [&](std::size_t i) {
      return pseudo_velocity(displacement[i], result.periods[i]);
    }));
  };
  if (result.components.size() == 1) {
    for (std::size_t i = 0; i < result.spectra.size(); ++i)
      add(result.spectra[i].displacement[0], damping_name(result, result.spectra[i]), family(result, i));
  } else if (result.spectra.size() > 1) {
    for (std::size_t i = 0; i < result.spectra.size(); ++i)
      add(result.spectra[i].rotd50, "RotD50, " + damping_name(result, result.spectra[i]), family(result, i));
  } else {
    panel.y.name = at_one_damping("pseudo-velocity", result, "m/s");
    add(result.spectra[0].rotd50, "RotD50", "family:2");
    add(result.spectra[0].rotd100, "RotD100", "family:0");
  }
  point_words(panel);
  add_equal_lines(panel, result.options.in_g);
  Figure figure;
  figure.id = "spectrum";
  figure.title = "Tripartite response spectrum";
  figure.size = FigureSize::single;
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace cromer::core
