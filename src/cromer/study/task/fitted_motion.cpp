#include "cromer/study/task/fitted_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/study/task/used_samples.h"

namespace cromer {
namespace {

int derivative_order(std::string_view quantity) {
  if (quantity.find("velocity") != std::string_view::npos) return 1;
  return quantity.find("acceleration") != std::string_view::npos ? 2 : 0;
}

/// The slope at `at` of E + A cos(w s) + B sin(w s), s = t - at, fitted to samples [first, last).
double local_slope(const FittedSamples& series, std::size_t first, std::size_t last, double at, double w) {
  Parameters right{};
  SquareMatrix matrix{};
  for (std::size_t i = first; i < last; ++i) {
    const double phase = w * (series.t[i] - at);
    const double row[] = {1, std::cos(phase), std::sin(phase)};
    for (int j = 0; j < 3; ++j) {
      right[j] += row[j] * series.y[i];
      for (int k = 0; k < 3; ++k) matrix[j][k] += row[j] * row[k];
    }
  }
  std::array<bool, max_parameters> all{};
  all.fill(true);
  const ScaledCholesky factor(matrix, 3, 0, all);
  return factor.ok() ? w * factor.solve(right)[2] : std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> local_velocities(const Series& series, double w) {
  const double half = std::numbers::pi / w;
  const FittedSamples good = without_outliers(series);
  std::vector<double> v(series.t.size(), std::numeric_limits<double>::quiet_NaN());
  std::size_t first = 0, last = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    while (first < good.t.size() && good.t[first] < series.t[i] - half) ++first;
    while (last < good.t.size() && good.t[last] <= series.t[i] + half) ++last;
    // A window that is cut at the record's end would lean on one side.
    const bool whole = series.t[i] - half >= series.t.front() && series.t[i] + half <= series.t.back();
    if (whole && last - first >= 8) v[i] = local_slope(good, first, last, series.t[i], w);
  }
  return v;
}

}  // namespace

FittedMotion fitted_motion(const FittedRecording& fitted) {
  const Series& series = fitted.series;
  const FreeDecay& fit = fitted.fit;
  const MotionParameters p = fit.motion();
  const int derivative = derivative_order(series.quantity);
  const Trajectory law = motion_of(fit, series.t);
  FittedMotion motion;
  motion.residual = motion_residuals(p, {series.t, series.y, 0, derivative}, fit.step);
  const std::size_t n = std::min(law.t.size(), motion.residual.size());
  const auto first = [n](const std::vector<double>& all) {
    return std::vector<double>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
  };
  motion.residual.resize(n);
  motion.t = first(series.t);
  motion.measured = first(series.y);
  motion.x = first(law.x);
  motion.v = first(law.v);
  const double w2 = p.angular_frequency * p.angular_frequency;
  double mass = 1;
  if (const Estimate* stiffness = fitted.find("stiffness")) {
    mass = stiffness->value / w2;
    motion.per_mass = false;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double x = motion.x[i], x2 = x * x, sine = std::sin(0.5 * x);
    const double potential = p.pendulum ? 2 * w2 * sine * sine : 0.5 * w2 * x2 + 0.25 * p.cubic * x2 * x2;
    motion.energy.push_back(mass * (0.5 * motion.v[i] * motion.v[i] + potential));
  }
  if (derivative == 0) {
    motion.local_velocity = local_velocities(series, p.angular_frequency);
    motion.local_velocity.resize(n);
  }
  return motion;
}

}  // namespace cromer
