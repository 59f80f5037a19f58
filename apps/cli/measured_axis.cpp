#include "measured_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/analysis/envelope.h"
#include "length_unit.h"
#include "words.h"

namespace cromer::cli {
namespace {

// With more, the lines of two motions run into each other.
constexpr std::size_t most_swings = 20;

std::string unit_of(const FittedRecording& fitted) {
  const std::string unit = fitted_unit(fitted);
  return unit.empty() && fitted.series.quantity == "position" ? "m" : unit;
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

MeasuredAxis measured_axis(const FittedRecording& fitted) {
  MeasuredAxis axis;
  const bool centred = fitted.fit.status == FitStatus::converged;
  axis.equilibrium = centred ? fitted.fit.equilibrium.value : 0;
  axis.unit = unit_of(fitted);
  double size = 0;
  for (const double y : fitted.series.y) size = std::max(size, std::abs(y - axis.equilibrium));
  if (axis.unit == "m") {
    const LengthUnit unit = length_unit(size);
    axis.unit = unit.symbol;
    axis.unit_size = unit.metres;
  }
  const std::string quantity = fitted.series.quantity.empty() ? "reading" : fitted.series.quantity;
  axis.name = (quantity == "position" && centred ? "displacement {/:Italic x}" : quantity) +
              (axis.unit.empty() ? "" : " (" + axis.unit + ")");
  return axis;
}

Curve measured_curve(const FittedRecording& fitted, const MeasuredAxis& axis) {
  Curve curve;
  curve.x = fitted.series.t;
  curve.y = axis.displacements(fitted.series.y);
  curve.role = "measured";
  curve.name = "measured";
  curve.remark = fmt::format("{} samples", fitted.series.t.size());
  curve.mark = Mark::dots;
  return curve;
}

void add_motion(Panel& panel, Curve motion) {
  Envelope around = envelope(motion.x, motion.y);
  if (around.top.size() <= most_swings || around.bottom.empty()) {
    panel.curves.push_back(std::move(motion));
    return;
  }
  Curve below = motion;
  below.name = below.remark = "";
  below.x = std::move(around.bottom_t);
  below.y = std::move(around.bottom);
  motion.x = std::move(around.top_t);
  motion.y = std::move(around.top);
  panel.curves.push_back(std::move(motion));
  panel.curves.push_back(std::move(below));
}

}  // namespace cromer::cli
