#include "cromer/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/length_unit.h"
#include "cromer/base/quantity.h"
#include "cromer/figures/motion_curves.h"
#include "cromer/figures/panels.h"
#include "cromer/report/enhanced_text.h"
#include "cromer/tasks/fit/decay_rates.h"

namespace cromer::core {
namespace {

Panel measured_panel(const FittedRecording& fitted, const MeasuredAxis& axis) {
  Panel panel;
  panel.x.name = axis.time_name;
  panel.y.name = axis.name;
  add_measured(panel, fitted, axis);
  return panel;
}

Panel residual_panel(const FittedRecording& fitted, MeasuredAxis axis) {
  // In the unit that suits the residuals if the file is in metres, else in the file's unit.
  if (fitted.series.quantity == "position" && fitted.series.to_si == 1) {
    const LengthUnit unit = length_unit(4 * fitted.fit.residual.rms);
    axis.unit = unit.symbol;
    axis.unit_size = unit.metres;
  }
  Panel panel;
  panel.title = "What the law leaves";
  panel.x.name = axis.time_name;
  panel.y.name = axis.unit.empty() ? "residual" : fmt::format("residual ({})", axis.unit);
  panel.curves.push_back(residual_curve(fitted, axis));
  panel.curves.back().remark =
      fmt::format("rms {} {}", rounded(fitted.fit.residual.rms / axis.unit_size, 3), axis.unit);
  return panel;
}

Curve fitted_look(const FittedRecording& fitted) {
  Curve look;
  look.role = "fitted";
  look.name = "fitted";
  look.remark = to_text(fitted.fit.law);
  return look;
}

/// Decay rate against the amplitude of the displacement: measured, with error bars, and by the law.
Panel decay_panel(const FittedRecording& fitted) {
  Panel panel;
  panel.title = "Decay rate against amplitude";
  double longest = 0;
  for (const AmplitudeRate& each : fitted.decay_by_amplitude) longest = std::max(longest, each.amplitude);
  const AmplitudeUnit unit = amplitude_unit(fitted, longest);
  panel.x.name = unit.symbol.empty() ? "amplitude" : fmt::format("amplitude ({})", unit.symbol);
  panel.y.name = "decay rate (1/s)";
  Curve points, bars, law = fitted_look(fitted);
  double largest = 0, top = 0;
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  for (const AmplitudeRate& each : fitted.decay_by_amplitude) {
    const double A = each.amplitude / unit.size;
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
    law.y.push_back(decay.rate(A * unit.size));
  }
  bars.role = points.role = "measured";
  points.mark = Mark::dots;
  points.name = "measured";
  points.remark = fmt::format("{} stretches,\n\u00b1 one standard error", points.x.size());
  panel.y.low = 0;
  panel.x.logarithmic = span_a_decade(fitted.decay_by_amplitude);
  if (!panel.x.logarithmic) panel.x.low = 0, panel.x.high = 1.05 * largest;
  panel.y.high = 1.08 * top;
  panel.curves = {std::move(law), std::move(bars), std::move(points)};
  return panel;
}

/// Whether it is drawn as an envelope.
bool add_law(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis) {
  const std::size_t first = panel.curves.size();
  const bool envelope = add_motion(panel, fitted, axis, law_motion(fitted, axis, true), fitted_look(fitted));
  if (envelope) panel.curves[first].remark += ", envelope";
  return envelope;
}

/// The largest swings of an irregular motion. `which` follows in the title: ", held out".
Panel swings_panel(const FittedRecording& fitted, std::string_view which) {
  const FittedRecording part = largest_swings(fitted);
  const MeasuredAxis axis = measured_axis(part);
  Panel panel = measured_panel(part, axis);
  const bool all = part.series.t.size() == fitted.series.t.size();
  panel.title = fmt::format("{}{}{}", run_title(part), which, all ? "" : ", about its largest swing");
  add_line(panel, part, axis, law_motion(part, axis, false), fitted_look(part));
  return panel;
}

/// The first swings, one by one, of a motion that is drawn as its envelope.
Panel first_panel(const FittedRecording& fitted) {
  const FittedRecording part = first_swings(fitted);
  const MeasuredAxis axis = measured_axis(part);
  Panel panel = measured_panel(part, axis);
  panel.title = "The first swings";
  add_line(panel, part, axis, law_motion(part, axis, true), fitted_look(part));
  return panel;
}

void append_panels(Figure& figure, const FittedRecording& fitted) {
  const MeasuredAxis axis = measured_axis(fitted);
  Panel motion = measured_panel(fitted, axis);
  motion.title = run_title(fitted);
  if (fitted.fit.status != FitStatus::converged) {
    motion.title += ": " + law_found(fitted);
    figure.panels.push_back(std::move(motion));
    return;
  }
  if (irregular(fitted)) {
    figure.panels.push_back(swings_panel(fitted, ""));
  } else {
    const bool envelope = add_law(motion, fitted, axis);
    figure.panels.push_back(std::move(motion));
    if (envelope) figure.panels.push_back(first_panel(fitted));
  }
  figure.panels.push_back(residual_panel(fitted, axis));
  if (fitted.held_out && !fitted.held_out->t.empty() && fitted.driven) {
    const FittedRecording held = held_out_part(fitted);
    figure.panels.push_back(swings_panel(held, ", held out"));
    figure.panels.push_back(residual_panel(held, measured_axis(held)));
    figure.panels.back().title = "What the law leaves of what was held out";
  }
  if (fitted.decay_by_amplitude.size() >= 3) figure.panels.push_back(decay_panel(fitted));
}

/// One small panel for each recording, with its title above.
Panel small_panel(const FittedRecording& fitted) {
  const MeasuredAxis axis = measured_axis(fitted);
  Panel panel = measured_panel(fitted, axis);
  const bool good = fitted.fit.status == FitStatus::converged;
  panel.title = figure_text(
      fmt::format("{}, run {}: {}", short_name(fitted.file), fitted.series.run, law_found(fitted)));
  if (good) add_law(panel, fitted, axis);
  return panel;
}

/// A grid of as many recordings as fit on a page.
void append_grid(Figure& figure, std::span<const FittedRecording> fits) {
  constexpr std::size_t most_panels = 24;
  std::size_t drawable = 0;
  for (const auto& fitted : fits) {
    if (fitted.series.t.empty() || drawable++ >= most_panels) continue;
    figure.panels.push_back(small_panel(fitted));
  }
  figure.columns = 3;
  figure.title = "Measured and fitted motions";
  move_names_to_key(figure);
  if (drawable > most_panels)
    figure.note = fmt::format("The first {} of {} recordings.", most_panels, drawable);
}

}  // namespace

Figure fit_figure(std::span<const FittedRecording> fits) {
  constexpr std::ptrdiff_t most_in_full = 3;  // recordings
  Figure figure;
  figure.id = "fit";
  figure.title = "Measured and fitted motion, the residual, and the decay rate against amplitude";
  figure.size = FigureSize::wide;
  const auto drawable = std::count_if(fits.begin(), fits.end(),
                                      [](const FittedRecording& fitted) { return !fitted.series.t.empty(); });
  if (drawable > most_in_full) {
    append_grid(figure, fits);
    return figure;
  }
  for (const auto& fitted : fits) {
    if (fitted.series.t.empty()) continue;
    const std::size_t first = figure.panels.size();
    append_panels(figure, fitted);
    if (drawable > 1)
      figure.panels[first].title = figure_text(short_name(fitted.file)) + ": " + figure.panels[first].title;
  }
  return figure;
}

}  // namespace cromer::core
