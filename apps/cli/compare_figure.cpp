#include "compare_figure.h"

#include <fmt/format.h>

#include <cmath>

#include "cromer/base/quantity.h"
#include "measured_axis.h"

namespace cromer::cli {
namespace {

/// How far the amplitude is off at the end, in words.
std::string at_the_end(double ratio) {
  if (!std::isfinite(ratio)) return "ends early";
  const double off = std::abs(ratio - 1);
  if (off < 5e-3) return "within 0.5 % at the end";
  return fmt::format("{} % too {} at the end", rounded(100 * off, 2), ratio > 1 ? "large" : "small");
}

/// The law in its own colour; one constant rate, which is there to be compared with it, in the method's,
/// dashed.
Curve simulated(const ComparedCurve& compared, const MeasuredAxis& axis) {
  const bool constant = compared.label.find("constant") != std::string::npos;
  Curve curve;
  curve.x = compared.trajectory.t;
  curve.y = axis.scaled(compared.trajectory.x);
  curve.role = constant ? compared.method : "fitted";
  curve.name = constant ? "one constant rate" : compared.label;
  curve.remark = at_the_end(compared.amplitude_ratio_end);
  curve.dashed = constant;
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
    Panel panel;
    if (comparisons.size() > 1) panel.title = fmt::format("Run {}", comparison.recording.series.run);
    panel.x.name = "time {/:Italic t} (s)";
    panel.y.name = axis.name;
    panel.curves.push_back(measured_curve(comparison.recording, axis));
    // The law first: it lies below.
    for (auto each = comparison.curves.rbegin(); each != comparison.curves.rend(); ++each)
      add_motion(panel, simulated(*each, axis));
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

}  // namespace cromer::cli
