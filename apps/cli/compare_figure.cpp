#include "compare_figure.h"

#include <fmt/format.h>

#include "measured_axis.h"

namespace cromer::cli {
namespace {

/// A simulation with one constant rate keeps its method's colour, dashed.
Curve simulated(const ComparedCurve& compared, const MeasuredAxis& axis) {
  Curve curve;
  curve.x = compared.trajectory.t;
  curve.y = axis.scaled(compared.trajectory.x);
  curve.role = compared.method;
  curve.name = compared.method;
  curve.remark = fmt::format("{:.3g} of the measured\namplitude at the end", compared.amplitude_ratio_end);
  curve.dashed = compared.label.find("constant") != std::string::npos;
  return curve;
}

}  // namespace

Figure compare_figure(const std::vector<CompareResult>& comparisons) {
  Figure figure;
  figure.id = "compare";
  figure.title = "Measured motion and simulations of it";
  figure.size = FigureSize::wide;
  for (const auto& comparison : comparisons) {
    if (comparison.recording.series.t.empty()) continue;
    const MeasuredAxis axis = measured_axis(comparison.recording);
    const Series& series = comparison.recording.series;
    for (const auto& compared : comparison.curves) {
      Panel panel;
      panel.title =
          fmt::format("{}imulated with {}",
                      comparisons.size() > 1 ? fmt::format("Run {}: s", series.run) : "S", compared.label);
      panel.x.name = "time {/:Italic t} (s)";
      panel.y.name = axis.name;
      panel.curves.push_back(measured_curve(comparison.recording, axis));
      panel.curves.push_back(simulated(compared, axis));
      figure.panels.push_back(std::move(panel));
    }
  }
  return figure;
}

}  // namespace cromer::cli
