#include "cromer/tasks/fit/fitted_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/analysis/swing.h"
#include "cromer/base/pi.h"
#include "cromer/identify/least_squares/normal_equations.h"
#include "cromer/identify/motion/parameter_unit.h"
#include "cromer/tasks/fit/fitted_quantities.h"
#include "cromer/tasks/fit/used_samples.h"

namespace cromer::core {
namespace {

/// A level and a sinusoid, fitted to the samples of a sliding window. Its sums take in each sample once and
/// drop it once, whatever the window's length.
class SlidingSinusoid {
 public:
  /// Values far from 0, beside their swing, cost its sums digits.
  SlidingSinusoid(const FittedSamples& samples, double w) : samples_(samples), w_(w) {}

  /// Moves the window to samples [first, last); neither end may go back.
  void move_to(std::size_t first, std::size_t last) {
    // Samples that come and go leave rounding errors: the sums are made afresh once in every window's length.
    if (first >= fresh_at_) {
      sums_ = {};
      first_ = last_ = first;
      fresh_at_ = std::max(first + 1, last);
    }
    for (; last_ < last; ++last_) take(last_, 1);
    for (; first_ < first; ++first_) take(first_, -1);
  }

  /// The slope at time `at` of E + A cos(w s) + B sin(w s), s = t - at.
  double slope(double at) const {
    const auto n = static_cast<double>(last_ - first_);
    const double phase = w_ * (at - samples_.t.front()), c = std::cos(phase), s = std::sin(phase);
    const double c2 = c * c - s * s, s2 = 2 * c * s;
    const Sums& m = sums_;
    const double cosine = m.c * c + m.s * s, sine = m.s * c - m.c * s;
    const double twice = m.c2 * c2 + m.s2 * s2, product = 0.5 * (m.s2 * c2 - m.c2 * s2);
    SquareMatrix matrix{};
    const double entries[3][3] = {
        {n, cosine, sine}, {cosine, 0.5 * (n + twice), product}, {sine, product, 0.5 * (n - twice)}};
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) matrix[j][k] = entries[j][k];
    Parameters right{};
    right[0] = m.y;
    right[1] = m.yc * c + m.ys * s;
    right[2] = m.ys * c - m.yc * s;
    const ScaledCholesky factor(matrix, 3, 0, all_free);
    return factor.ok() ? w_ * factor.solve(right)[2] : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  struct Sums {
    double c = 0, s = 0, c2 = 0, s2 = 0, y = 0, yc = 0, ys = 0;
  };

  void take(std::size_t i, double sign) {
    const double phase = w_ * (samples_.t[i] - samples_.t.front());
    const double c = std::cos(phase), s = std::sin(phase), y = samples_.y[i];
    sums_.c += sign * c;
    sums_.s += sign * s;
    sums_.c2 += sign * (c * c - s * s);
    sums_.s2 += sign * 2 * c * s;
    sums_.y += sign * y;
    sums_.yc += sign * y * c;
    sums_.ys += sign * y * s;
  }

  const FittedSamples& samples_;
  double w_;
  std::size_t first_ = 0, last_ = 0, fresh_at_ = 0;
  Sums sums_;
};

/// The slopes of the series.
std::vector<double> local_slopes(const Series& series, double w) {
  const double half = pi / w;
  const FittedSamples good = without_outliers(series);
  SlidingSinusoid window(good, w);
  std::vector<double> v(series.t.size(), std::numeric_limits<double>::quiet_NaN());
  std::size_t first = 0, last = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    while (first < good.t.size() && good.t[first] < series.t[i] - half) ++first;
    while (last < good.t.size() && good.t[last] <= series.t[i] + half) ++last;
    // A window that is cut off at the record's end would be lopsided.
    const bool whole = series.t[i] - half >= series.t.front() && series.t[i] + half <= series.t.back();
    if (!whole || last < first + 8) continue;
    window.move_to(first, last);
    v[i] = window.slope(series.t[i]);
  }
  return v;
}

std::vector<double> residuals_of(const DrivenMotion& driven, const Series& series) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < std::min(driven.motion.size(), series.y.size()); ++i)
    residuals.push_back(series.y[i] - driven.motion[i]);
  return residuals;
}

}  // namespace

std::vector<double> energies_of(const FittedRecording& fitted, const std::vector<double>& x,
                                const std::vector<double>& v) {
  const Swing<double> swing{fitted.fit.motion.per_mass};
  const Estimate* stiffness = fitted.find("stiffness");
  const double mass = stiffness ? stiffness->value / swing.per_mass.stiffness : 1;
  std::vector<double> energies;
  for (std::size_t i = 0; i < std::min(x.size(), v.size()); ++i)
    energies.push_back(mass * (0.5 * v[i] * v[i] + swing.potential(x[i])));
  return energies;
}

FittedMotion law_motion(const FittedRecording& fitted) {
  const Series& series = fitted.series;
  const LawFit& fit = fitted.fit;
  const int derivative = std::max(0, derivative_order(series.quantity));
  const Trajectory law = fitted.driven ? fitted.driven->states : motion_of(fit, series.t);
  FittedMotion motion;
  motion.residual = fitted.driven ? residuals_of(*fitted.driven, series)
                                  : residuals_of(fit, {series.t, series.y, 0, derivative});
  const std::size_t n = std::min(law.x.size(), motion.residual.size());
  const auto first = [n](const std::vector<double>& all) {
    return std::vector<double>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
  };
  motion.residual.resize(n);
  motion.t = first(series.t);
  motion.measured = first(series.y);
  motion.x = first(law.x);
  motion.v = first(law.v);
  return motion;
}

FittedMotion fitted_motion(const FittedRecording& fitted) {
  FittedMotion motion = law_motion(fitted);
  motion.per_mass = fitted.find("stiffness") == nullptr;
  motion.energy = energies_of(fitted, motion.x, motion.v);
  const Series& series = fitted.series;
  if (derivative_order(series.quantity) <= 0 && !fitted.driven) {
    Series rest = series;
    rest.y = motion.residual;
    rest.y.resize(rest.t.size(), std::numeric_limits<double>::quiet_NaN());
    motion.local_velocity = local_slopes(rest, fitted.fit.motion.angular_frequency());
    motion.local_velocity.resize(motion.t.size());
    for (std::size_t i = 0; i < motion.t.size(); ++i) motion.local_velocity[i] += motion.v[i];
  }
  return motion;
}

MotionUnits motion_units(const FittedRecording& fitted) {
  MotionUnits units;
  units.measured = unit_of(fitted.series);
  units.displacement = displacement_unit(units.measured, derivative_order(fitted.series.quantity));
  if (!units.displacement.empty()) units.velocity = units.displacement + "/s";
  if (units.displacement == "m")
    units.energy = fitted.find("stiffness") ? "J" : "J/kg";
  else if (units.displacement == "rad")
    units.energy = "J/(kg m²)";
  return units;
}

}  // namespace cromer::core
