#include "cromer/figures/motion_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "cromer/analysis/envelope.h"
#include "cromer/base/length_unit.h"
#include "cromer/base/pi.h"
#include "cromer/documents/text/words.h"
#include "cromer/figures/panels.h"
#include "cromer/identify/motion/motion_model.h"
#include "cromer/report/enhanced_text.h"
#include "cromer/report/thinning.h"
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

/// Times count from the first sample if all ticks would read alike otherwise.
void set_time(MeasuredAxis& axis, const std::vector<double>& t) {
  constexpr double far_from_zero = 20;  // durations
  if (t.empty()) return;
  const double duration = t.back() - t.front();
  const auto [unit, seconds] = time_unit(duration);
  axis.time_unit = seconds;
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

std::string run_title(const FittedRecording& fitted) {
  const std::string& column = fitted.series.column;
  const std::size_t unit = column.ends_with(')') ? column.rfind(" (") : column.npos;
  return figure_text(fmt::format("{}, run {}", column.substr(0, unit), fitted.series.run));
}

std::string law_found(const FittedRecording& fitted) {
  if (fitted.fit.status == FitStatus::converged) return to_text(fitted.fit.law);
  std::string why(fitted.status());
  std::replace(why.begin(), why.end(), '_', ' ');
  if (fitted.modes.size() == 2) return "no single law: two modes swing";
  return fmt::format("no law found ({})", why);
}

MeasuredAxis measured_axis(const FittedRecording& fitted) {
  MeasuredAxis axis;
  const bool centred = fitted.fit.status == FitStatus::converged;
  const Series& series = fitted.series;
  axis.equilibrium = centred ? fitted.fit.equilibrium().value : 0;
  const std::string si = unit_of(fitted);
  axis.unit = figure_text(si.empty() ? series.unit : si);
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

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_swings = 20;       // with more, the lines of two motions run into each other
constexpr std::size_t columns = 2000;         // more than a figure has pixels
constexpr double smooth_points = 100;         // of a period
constexpr std::size_t most_points = 400'000;  // of a smooth curve

/// The motion with a NaN in each gap.
SampledMotion broken_at_gaps(const SampledMotion& motion, const std::vector<Gap>& gaps) {
  SampledMotion broken;
  std::size_t gap = 0;
  for (std::size_t i = 0; i < motion.t.size(); ++i) {
    while (gap < gaps.size() && motion.t[i] >= gaps[gap].t + 0.5 * gaps[gap].length) {
      if (!broken.t.empty()) {
        broken.t.push_back(broken.t.back());
        broken.y.push_back(none);
      }
      ++gap;
    }
    broken.t.push_back(motion.t[i]);
    broken.y.push_back(motion.y[i]);
  }
  return broken;
}

/// The stretches between NaNs.
std::vector<SampledMotion> stretches_of(const SampledMotion& motion) {
  std::vector<SampledMotion> stretches(1);
  for (std::size_t i = 0; i < motion.t.size(); ++i) {
    if (!std::isfinite(motion.y[i])) {
      if (!stretches.back().t.empty()) stretches.emplace_back();
      continue;
    }
    stretches.back().t.push_back(motion.t[i]);
    stretches.back().y.push_back(motion.y[i]);
  }
  return stretches;
}

/// Keeps only the outermost turning point of each window: a driven motion may turn more than once in a
/// period.
void outermost(std::vector<double>& t, std::vector<double>& x, double window, double sign) {
  std::vector<double> kept_t, kept_x;
  for (std::size_t i = 0; i < t.size();) {
    std::size_t best = i, end = i;
    for (; end < t.size() && t[end] < t[i] + window; ++end)
      if (sign * x[end] > sign * x[best]) best = end;
    kept_t.push_back(t[best]);
    kept_x.push_back(x[best]);
    i = end;
  }
  t = std::move(kept_t);
  x = std::move(kept_x);
}

double period_of(const FittedRecording& fitted) {
  double w = fitted.fit.swing_frequency().value;
  if (const Estimate* drive = fitted.fit.find("drive_frequency")) w = std::min(w, drive->value);
  return w > 0 ? two_pi / w : 0;
}

void append(Curve& curve, const MeasuredAxis& axis, const std::vector<double>& t,
            const std::vector<double>& y) {
  if (!curve.x.empty()) {
    curve.x.push_back(curve.x.back());
    curve.y.push_back(none);
  }
  const std::vector<double> at = axis.times(t);
  for (const std::size_t i : extremes(at, y, columns)) {
    curve.x.push_back(at[i]);
    curve.y.push_back(y[i]);
  }
}

/// Times of a free motion close enough for a smooth curve, with none inside the gaps.
std::vector<double> smooth_times(const FittedRecording& fitted) {
  const std::vector<double>& t = fitted.series.t;
  const double duration = t.back() - t.front(), period = period_of(fitted);
  const double spacing = period / smooth_points;
  if (!(spacing > 0) || duration / spacing > static_cast<double>(most_points)) return t;
  if (static_cast<double>(t.size()) * spacing > duration && fitted.series.gaps.empty()) return t;
  const auto steps = static_cast<std::size_t>(std::ceil(duration / spacing));
  std::vector<double> fine;
  std::size_t gap = 0;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double at =
        i == steps ? t.back() : t.front() + static_cast<double>(i) * duration / static_cast<double>(steps);
    const auto& gaps = fitted.series.gaps;
    while (gap < gaps.size() && at >= gaps[gap].t + gaps[gap].length) ++gap;
    const bool inside = gap < gaps.size() && at > gaps[gap].t;
    if (!inside || i == steps) fine.push_back(at);
  }
  return fine;
}

/// The values of the column by the free law, less the equilibrium.
std::vector<double> free_values(const FittedRecording& fitted, const std::vector<double>& t) {
  const std::vector<double> zeros(t.size(), 0.0);
  const int derivative = std::max(0, derivative_order(fitted.series.quantity));
  std::vector<double> values =
      motion_residuals(fitted.fit.motion, {}, {t, zeros, 0, derivative}, fitted.fit.step);
  for (double& value : values) value = -value - fitted.fit.equilibrium().value;
  values.resize(t.size(), none);
  return values;
}

/// The samples of the fit, broken where samples are missing.
Curve measured_curve(const FittedRecording& fitted, const MeasuredAxis& axis) {
  const FittedSamples good = without_outliers(fitted.series);
  Curve curve = measured_dots(fitted, axis, {good.t, axis.displacements(good.y)});
  curve.name = "measured";
  curve.remark = samples_in_words(good.t.size());
  return curve;
}

}  // namespace

Curve measured_dots(const FittedRecording& fitted, const MeasuredAxis& axis, const SampledMotion& motion) {
  Curve curve;
  for (const SampledMotion& stretch : stretches_of(broken_at_gaps(motion, fitted.series.gaps)))
    append(curve, axis, stretch.t, stretch.y);
  curve.role = "measured";
  curve.mark = Mark::dots;
  return curve;
}

Curve residual_curve(const FittedRecording& fitted, const MeasuredAxis& axis) {
  const FittedSamples good = without_outliers(fitted.series);
  const SampledMotion law = law_motion(fitted, axis, false);
  const std::vector<double> measured = axis.displacements(good.y);
  SampledMotion rest;
  for (std::size_t i = 0; i < law.t.size() && rest.t.size() < good.t.size(); ++i) {
    if (law.t[i] != good.t[rest.t.size()]) continue;
    rest.y.push_back(measured[rest.t.size()] - law.y[i]);
    rest.t.push_back(law.t[i]);
  }
  Curve curve = measured_dots(fitted, axis, rest);
  curve.name = "residual";
  return curve;
}

void add_measured(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis) {
  panel.curves.push_back(measured_curve(fitted, axis));
  const Series& series = fitted.series;
  SampledMotion aside;
  for (const Outlier& outlier : series.outliers) {
    if (outlier.t < series.t.front() || outlier.t > series.t.back()) continue;
    aside.t.push_back(outlier.t);
    aside.y.push_back(outlier.value);
  }
  if (aside.t.empty()) return;
  Curve crosses;
  crosses.x = axis.times(aside.t);
  crosses.y = axis.displacements(aside.y);
  crosses.role = "set-aside";
  crosses.name = "set aside";
  crosses.remark = samples_in_words(crosses.x.size());
  crosses.remark_outside = ",\nat the edge: beyond it";
  crosses.mark = Mark::crosses;
  crosses.sets_axes = false;
  panel.curves.push_back(std::move(crosses));
}

SampledMotion law_motion(const FittedRecording& fitted, const MeasuredAxis& axis, bool smooth) {
  if (!fitted.driven) {
    const std::vector<double> t = smooth ? smooth_times(fitted) : fitted.series.t;
    return {t, axis.scaled(free_values(fitted, t))};
  }
  std::vector<double> y = fitted.driven->motion;
  y.resize(fitted.series.t.size(), none);
  return {fitted.series.t, axis.displacements(std::move(y))};
}

bool irregular(const FittedRecording& fitted) { return is_recorded(fitted.fit.drive.kind); }

FittedRecording largest_swings(const FittedRecording& fitted) {
  constexpr double periods = 12;  // to each side
  FittedRecording part = fitted;
  const FittedSamples good = without_outliers(fitted.series);
  double at = fitted.series.t.front(), largest = 0;
  for (std::size_t i = 0; i < good.t.size(); ++i) {
    const double size = std::abs(good.y[i] - fitted.fit.equilibrium().value);
    if (size > largest) largest = size, at = good.t[i];
  }
  const std::vector<double>& t = fitted.series.t;
  const double reach = periods * period_of(fitted);
  if (reach == 0) return part;
  const auto first = std::lower_bound(t.begin(), t.end(), at - reach) - t.begin(),
             last = std::upper_bound(t.begin(), t.end(), at + reach) - t.begin();
  for (std::vector<double>* values : {&part.series.t, &part.series.y, &part.driven->motion}) {
    if (values->size() < t.size()) continue;
    values->erase(values->begin() + last, values->end());
    values->erase(values->begin(), values->begin() + first);
  }
  const auto outside = [&](const auto& mark) {
    return mark.t < part.series.t.front() || mark.t > part.series.t.back();
  };
  auto& gaps = part.series.gaps;
  gaps.erase(std::remove_if(gaps.begin(), gaps.end(), outside), gaps.end());
  return part;
}

FittedRecording first_swings(const FittedRecording& fitted) {
  constexpr double periods = 6;
  FittedRecording part = fitted;
  std::vector<double>& t = part.series.t;
  const double end = t.front() + periods * period_of(fitted);
  if (end == t.front()) return part;
  t.erase(std::upper_bound(t.begin(), t.end(), end), t.end());
  part.series.y.resize(t.size());
  if (part.driven) part.driven->motion.resize(std::min(part.driven->motion.size(), t.size()));
  const auto later = [&](const auto& mark) { return mark.t > t.back(); };
  std::erase_if(part.series.gaps, later);
  std::erase_if(part.series.outliers, later);
  return part;
}

FittedRecording held_out_part(const FittedRecording& fitted) {
  FittedRecording part = fitted;
  part.series.t = fitted.held_out->t;
  part.series.y = fitted.held_out->measured;
  part.driven->motion = fitted.held_out->law;
  part.series.gaps.clear();
  part.series.outliers.clear();
  part.fit.residual.rms = fitted.held_out->rms;
  return part;
}

void add_line(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis,
              const SampledMotion& motion, Curve look) {
  for (const SampledMotion& stretch : stretches_of(broken_at_gaps(motion, fitted.series.gaps)))
    append(look, axis, stretch.t, stretch.y);
  panel.curves.push_back(std::move(look));
  for (Curve& curve : panel.curves) curve.always_dots = curve.role == "measured";  // seen on the line
}

bool add_motion(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis, SampledMotion motion,
                const Curve& look) {
  const std::vector<SampledMotion> stretches = stretches_of(broken_at_gaps(motion, fitted.series.gaps));
  std::vector<Envelope> around;
  std::size_t swings = 0;
  const double duration = fitted.series.t.back() - fitted.series.t.front();
  const double window = std::max(fitted.driven ? 0.7 * period_of(fitted) : 0, duration / 500);
  bool enough = true;
  for (const SampledMotion& stretch : stretches) {
    around.push_back(envelope(stretch.t, stretch.y));
    Envelope& e = around.back();
    swings += e.top.size();
    outermost(e.top_t, e.top, window, 1);
    outermost(e.bottom_t, e.bottom, window, -1);
    enough = enough && !e.bottom.empty() && !e.top.empty();
  }
  Curve line = look, below = look;
  if (swings <= most_swings || !enough) {
    for (const SampledMotion& stretch : stretches) append(line, axis, stretch.t, stretch.y);
    panel.curves.push_back(std::move(line));
    return false;
  }
  below.name = below.remark = "";
  for (const Envelope& e : around) {
    append(line, axis, e.top_t, e.top);
    append(below, axis, e.bottom_t, e.bottom);
  }
  panel.curves.push_back(std::move(line));
  panel.curves.push_back(std::move(below));
  return true;
}

}  // namespace cromer::core
