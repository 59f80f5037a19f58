#include "fit_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/quantity.h"
#include "cromer/identify/free_motion.h"
#include "measured_axis.h"

namespace cromer::cli {
namespace {

/// The fitted displacements at the measured times.
std::vector<double> fitted_motion(const FittedRecording& fitted) {
  if (fitted.forced) {
    std::vector<double> x = fitted.forced->motion;
    for (double& value : x) value -= fitted.fit.equilibrium.value;
    return x;
  }
  const FreeDecay& fit = fitted.fit;
  const MotionParameters motion{.angular_frequency = fit.angular_frequency.value,
                                .decay_rate = fit.decay_rate.value,
                                .drag = fit.drag ? fit.drag->value : 0,
                                .cubic = fit.cubic ? fit.cubic->value : 0,
                                .equilibrium = fit.equilibrium.value,
                                .position = fit.position.value,
                                .velocity = fit.velocity.value};
  const auto& t = fitted.series.t;
  return free_motion(motion, t, motion_step(motion.angular_frequency, t.back() - t.front(), 1e-6)).x;
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
  model.y = axis.scaled(fitted_motion(fitted));
  model.role = "fitted";
  model.name = "fitted";
  model.remark = to_text(fitted.fit.law);
  Panel residual = residual_panel(fitted, axis, model.y);
  add_motion(motion, std::move(model));
  figure.panels.push_back(std::move(motion));
  figure.panels.push_back(std::move(residual));
}

}  // namespace

Figure fit_figure(const std::vector<FittedRecording>& fits) {
  Figure figure;
  figure.id = "fit";
  figure.title = "Measured and fitted motion, and the residual";
  figure.size = FigureSize::wide;
  for (const auto& fitted : fits)
    if (!fitted.series.t.empty()) append_panels(figure, fitted);
  return figure;
}

}  // namespace cromer::cli
