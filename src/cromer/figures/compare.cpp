#include "cromer/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/base/quantity.h"
#include "cromer/figures/motion_curves.h"

namespace cromer::core {
namespace {

/// The error of the amplitude at the end, in words.
std::string at_the_end(const ComparedCurve& curve) {
  if (curve.diverged) return "runs away: step too long";
  if (!curve.complete) return "ends early";
  if (curve.measured_at_rest) return curve.at_rest ? "stops as measured" : "swings on after the stop";
  const double ratio = curve.amplitude_ratio_end, off = std::abs(ratio - 1);
  if (off < 5e-3) return "within 0.5 % at the end";
  return fmt::format("{} % too {} at the end", rounded(100 * off, 2), ratio > 1 ? "large" : "small");
}

/// Method and step, if the method itself changes the amplitude visibly.
std::string by_its_method(const ComparedCurve& curve) {
  if (!curve.complete || curve.diverged || !(std::abs(curve.method_amplitude_ratio - 1) > 5e-3)) return "";
  return fmt::format("by {} in steps of {} s:\n", curve.method, rounded(curve.step, 3));
}

/// The law in the colour of fits; one constant decay rate dashed, in the colour of its method.
Curve look_of(const ComparedCurve& compared) {
  const bool constant = compared.label.code == "one_constant_decay_rate";
  Curve look;
  look.role = constant ? compared.method : "fitted";
  look.name = constant ? "one constant rate" : to_text(compared.law);
  look.remark = by_its_method(compared) + at_the_end(compared);
  look.dashed = constant;
  look.sets_axes = !compared.diverged;
  return look;
}

}  // namespace

Figure compare_figure(std::span<const CompareResult> comparisons) {
  Figure figure;
  figure.id = "compare";
  figure.title = "Measured motion and simulations of it";
  figure.size = FigureSize::wide;
  constexpr std::size_t most_in_full = 3, most_panels = 24;
  const auto drawable = static_cast<std::size_t>(
      std::count_if(comparisons.begin(), comparisons.end(),
                    [](const CompareResult& each) { return !each.recording.series.t.empty(); }));
  const bool grid = drawable > most_in_full;
  if (grid) {
    figure.columns = 3;
    figure.note =
        "Dots: measured. Line, or envelope: the law. Dashed: one constant rate. Crosses: set aside.";
    if (drawable > most_panels)
      figure.note += fmt::format(" The first {} of {} runs.", most_panels, drawable);
  }
  for (const auto& comparison : comparisons) {
    if (comparison.recording.series.t.empty() || figure.panels.size() == most_panels) continue;
    const MeasuredAxis axis = measured_axis(comparison.recording);
    Panel panel;
    if (comparisons.size() > 1) panel.title = fmt::format("Run {}", comparison.recording.series.run);
    panel.x.name = axis.time_name;
    panel.y.name = axis.name;
    add_measured(panel, comparison.recording, axis);
    // In reverse order, so that the law lies below.
    for (auto each = comparison.curves.rbegin(); each != comparison.curves.rend(); ++each)
      add_motion(panel, comparison.recording, axis, {each->trajectory.t, axis.scaled(each->trajectory.x)},
                 look_of(*each));
    if (grid) {
      panel.title += ": " + to_text(comparison.recording.fit.law);
      for (Curve& curve : panel.curves) curve.name = curve.remark = "";
    }
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

}  // namespace cromer::core
