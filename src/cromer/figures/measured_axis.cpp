#include "cromer/figures/measured_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "cromer/documents/text/words.h"
#include "cromer/figures/length_unit.h"
#include "cromer/report/enhanced_text.h"
#include "cromer/tasks/fit/used_samples.h"

namespace cromer::core {
namespace {

std::string unit_of(const FittedRecording& fitted) {
  const std::string unit = fitted_unit(fitted);
  return unit.empty() && fitted.series.quantity == "position" ? "m" : unit;
}

bool in_degrees(const Series& series) {
  return series.unit.find("deg") != std::string::npos || series.unit.find("°") != std::string::npos;
}

/// Seconds, milliseconds or microseconds; from the first sample where ticks of the whole time would all read
/// alike.
void set_time(MeasuredAxis& axis, const std::vector<double>& t) {
  constexpr double far_from_zero = 20;  // durations
  if (t.empty()) return;
  const double duration = t.back() - t.front();
  std::string_view unit = "s";
  if (duration > 0 && duration < 0.5) {
    const bool milli = duration >= 5e-4;
    unit = milli ? "ms" : "µs";
    axis.time_unit = milli ? 1e-3 : 1e-6;
  }
  const bool far = std::abs(t.front()) > far_from_zero * duration;
  if (far) axis.time_from = t.front();
  axis.time_name = far ? fmt::format("time {{/:Italic t}} from {:.10g} s on ({})", axis.time_from, unit)
                       : fmt::format("time {{/:Italic t}} ({})", unit);
}

}  // namespace

std::vector<double> MeasuredAxis::displacements(std::vector<double> values) const {
  for (double& value : values) value = (value - equilibrium) / unit_size;
  return values;
}

std::vector<double> MeasuredAxis::scaled(std::vector<double> values) const {
  for (double& value : values) value /= unit_size;
  return values;
}

std::vector<double> MeasuredAxis::times(std::vector<double> t) const {
  for (double& each : t) each = (each - time_from) / time_unit;
  return t;
}

MeasuredAxis measured_axis(const FittedRecording& fitted) {
  MeasuredAxis axis;
  const bool centred = fitted.fit.status == FitStatus::converged;
  const Series& series = fitted.series;
  axis.equilibrium = centred ? fitted.fit.equilibrium().value : 0;
  const std::string si = unit_of(fitted);
  axis.unit = figure_text(si);
  if (series.to_si != 1 && !series.unit.empty()) {
    axis.unit = figure_text(series.unit);
    axis.unit_size = series.to_si;
  } else if (si == "m") {
    double size = 0;
    for (const double y : without_outliers(series).y) size = std::max(size, std::abs(y - axis.equilibrium));
    const LengthUnit unit = length_unit(size);
    axis.unit = unit.symbol;
    axis.unit_size = unit.metres;
  }
  const std::string quantity = series.quantity.empty() ? "reading" : series.quantity;
  axis.name = (quantity == "position" && centred ? "displacement {/:Italic x}" : figure_text(quantity)) +
              (axis.unit.empty() ? "" : " (" + axis.unit + ")");
  set_time(axis, series.t);
  return axis;
}

AmplitudeUnit amplitude_unit(const FittedRecording& fitted, double largest) {
  const Series& series = fitted.series;
  const std::string& quantity = series.quantity;
  if (quantity.starts_with("ang"))
    return in_degrees(series) ? AmplitudeUnit{"°", std::numbers::pi / 180} : AmplitudeUnit{"rad", 1};
  if (quantity == "position" && series.to_si != 1 && !series.unit.empty())
    return {figure_text(series.unit), series.to_si};
  if (quantity == "position" || quantity == "velocity" || quantity == "acceleration") {
    const LengthUnit unit = length_unit(largest);
    return {std::string(unit.symbol), unit.metres};
  }
  return {figure_text(series.unit), series.to_si};
}

}  // namespace cromer::core
