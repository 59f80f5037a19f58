#include "fit_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/quantity.h"
#include "cromer/study/task/fitted_motion.h"
#include "measured_axis.h"

namespace cromer::cli {
namespace {

/// What the law has at the measured times, less the equilibrium.
std::vector<double> fitted_values(const FittedRecording& fitted) {
  if (fitted.forced) {
    std::vector<double> x = fitted.forced->motion;
    for (double& value : x) value -= fitted.fit.equilibrium.value;
    return x;
  }
  const FittedMotion motion = fitted_motion(fitted);
  std::vector<double> values = motion.measured;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] -= motion.residual[i] + fitted.fit.equilibrium.value;
  values.resize(fitted.series.t.size(), std::numeric_limits<double>::quiet_NaN());
  return values;
}

Panel measured_panel(const FittedRecording& fitted, const MeasuredAxis& axis) {
  Panel panel;
  panel.x.name = "time {/:Italic t} (s)";
  panel.y.name = axis.name;
  panel.curves.push_back(measured_curve(fitted, axis));
  return panel;
}

Panel residual_panel(const FittedRecording& fitted, const MeasuredAxis& axis,
                     const std::vector<double>& model) {
  Panel panel;
  panel.title = "What the law leaves";
  panel.x.name = "time {/:Italic t} (s)";
  panel.y.name = axis.unit.empty() ? "residual" : fmt::format("residual ({})", axis.unit);
  Curve rest = measured_curve(fitted, axis);
  for (std::size_t i = 0; i < rest.y.size(); ++i) rest.y[i] -= model[i];
  rest.name = "residual";
  rest.remark = fmt::format("rms {} {}", rounded(fitted.fit.residual.rms / axis.unit_size, 3), axis.unit);
  panel.curves.push_back(std::move(rest));
  return panel;
}

/// Amplitudes in the axis's unit, growing to the right.
Panel decay_panel(const FittedRecording& fitted, const MeasuredAxis& axis) {
  Panel panel;
  panel.title = "Decay rate against amplitude";
  panel.x.name = axis.unit.empty() ? "amplitude" : fmt::format("amplitude ({})", axis.unit);
  panel.y.name = "decay rate (1/s)";
  Curve points, bars, law;
  double largest = 0, top = 0;
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  for (const AmplitudeRate& each : fitted.decay_by_amplitude) {
    const double A = each.amplitude / axis.unit_size;
    points.x.push_back(A);
    points.y.push_back(each.rate.value);
    const double low = each.rate.value - each.rate.standard_error,
                 high = each.rate.value + each.rate.standard_error;
    bars.x.insert(bars.x.end(), {A, A, A});
    bars.y.insert(bars.y.end(), {low, high, gap});
    largest = std::max(largest, A);
    top = std::max({top, high, each.law_rate});
  }
  const AmplitudeDecay decay = amplitude_decay(fitted.fit);
  const double smallest = *std::min_element(points.x.begin(), points.x.end());
  constexpr int steps = 200;
  for (int i = 0; i <= steps; ++i) {
    const double A = smallest * std::pow(largest / smallest, static_cast<double>(i) / steps);
    law.x.push_back(A);
    law.y.push_back(decay.rate(A * axis.unit_size));
  }
  law.role = "fitted";
  law.name = "fitted";
  law.remark = to_text(fitted.fit.law);
  bars.role = points.role = "measured";
  points.mark = Mark::dots;
  points.name = "measured";
  points.remark = fmt::format("{} stretches,\n\u00b1 one standard error", points.x.size());
  panel.x.low = panel.y.low = 0;
  panel.x.high = 1.05 * largest;
  panel.y.high = 1.08 * top;
  panel.curves = {std::move(law), std::move(bars), std::move(points)};
  return panel;
}

void append_panels(Figure& figure, const FittedRecording& fitted) {
  const MeasuredAxis axis = measured_axis(fitted);
  Panel motion = measured_panel(fitted, axis);
  motion.title = fmt::format("{}, run {}", fitted.series.column, fitted.series.run);
  if (fitted.fit.status != FitStatus::converged) {
    figure.panels.push_back(std::move(motion));
    return;
  }
  Curve model;
  model.x = fitted.series.t;
  model.y = axis.scaled(fitted_values(fitted));
  model.role = "fitted";
  model.name = "fitted";
  model.remark = to_text(fitted.fit.law);
  Panel residual = residual_panel(fitted, axis, model.y);
  add_motion(motion, std::move(model));
  figure.panels.push_back(std::move(motion));
  figure.panels.push_back(std::move(residual));
  if (fitted.decay_by_amplitude.size() >= 3) figure.panels.push_back(decay_panel(fitted, axis));
}

}  // namespace

Figure fit_figure(const std::vector<FittedRecording>& fits) {
  Figure figure;
  figure.id = "fit";
  figure.title = "Measured and fitted motion, the residual, and the decay rate against amplitude";
  figure.size = FigureSize::wide;
  for (const auto& fitted : fits)
    if (!fitted.series.t.empty()) append_panels(figure, fitted);
  return figure;
}

}  // namespace cromer::cli
