#include "cromer/analysis/measured_oscillator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/line.h"
#include "cromer/base/state.h"

namespace cromer::core {
namespace {

/// Where the cubic through two states (v of opposite signs) turns.
TurningPoint turn_between(const Trajectory& kept, std::size_t i) {
  const double h = kept.t[i + 1] - kept.t[i], rise = kept.x[i + 1] - kept.x[i];
  const double v0 = h * kept.v[i], v1 = h * kept.v[i + 1];
  // x(s) = x0 + v0 s + b s^2 + c s^3, s from 0 to 1; its slope changes sign once.
  const double b = 3 * rise - 2 * v0 - v1, c = v0 + v1 - 2 * rise;
  const double root = std::sqrt(std::max(0.0, b * b - 3 * c * v0));
  // Of the two forms of the root, the one without cancellation.
  double s = b >= 0 ? -v0 / (b + root) : (root - b) / (3 * c);
  if (!(s >= 0 && s <= 1)) s = b >= 0 ? (-root - b) / (3 * c) : v0 / (root - b);
  if (!(s >= 0 && s <= 1)) s = v0 / (v0 - v1);
  return {kept.t[i] + s * h, kept.x[i] + s * (v0 + s * (b + s * c))};
}

/// The turning point at a state whose velocity is zero. A mass that stays there came to rest between this
/// state and the one before: slowed evenly, it went on for twice the distance over the speed before.
TurningPoint rests_from(const Trajectory& kept, std::size_t i) {
  TurningPoint turn{kept.t[i], kept.x[i]};
  if (i == 0 || (i + 1 < kept.size() && kept.v[i + 1] != 0)) return turn;
  const double slowing = 2 * (kept.x[i] - kept.x[i - 1]) / kept.v[i - 1];
  if (slowing >= 0 && slowing < kept.t[i] - kept.t[i - 1]) turn.t = kept.t[i - 1] + slowing;
  return turn;
}

}  // namespace

std::vector<TurningPoint> turning_points(const Trajectory& kept) {
  std::vector<TurningPoint> found;
  for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
    if (kept.v[i] == 0) {
      if (i == 0 ? kept.v[1] != 0 : kept.v[i - 1] != 0) found.push_back(rests_from(kept, i));
    } else if (kept.v[i] * kept.v[i + 1] < 0) {
      found.push_back(turn_between(kept, i));
    }
  }
  return found;
}

std::optional<MeasuredOscillator> measure_oscillator(const Trajectory& trajectory) {
  const std::vector<TurningPoint> turns = turning_points(trajectory);
  if (turns.size() < 3) return std::nullopt;
  std::vector<double> middle, logarithm;
  for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
    const double amplitude = std::abs(turns[i + 1].x - turns[i].x) / 2;
    if (!(amplitude > 0)) return std::nullopt;
    middle.push_back((turns[i].t + turns[i + 1].t) / 2);
    logarithm.push_back(std::log(amplitude));
  }
  const auto half_cycles = static_cast<int>(middle.size());
  return MeasuredOscillator{
      .angular_frequency = std::numbers::pi * half_cycles / (turns.back().t - turns.front().t),
      .decay_rate = -fit_line(middle, logarithm).slope,
      .first_amplitude = std::exp(logarithm.front()),
      .last_amplitude = std::exp(logarithm.back()),
      .half_cycles = half_cycles};
}

std::optional<Recurrence> measure_recurrence(const std::vector<double>& x, double spacing,
                                             double angular_frequency) {
  const double radian = 1 / (angular_frequency * spacing);
  if (!(radian > 0) || radian > static_cast<double>(x.size())) return std::nullopt;
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(radian)));
  if (x.size() < 3 * stride + 2) return std::nullopt;
  // x[i + 2 s] = p x[i + s] - q x[i]: normal equations, each row over its own size so that a decayed end
  // counts as much as the start.
  double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
  for (std::size_t i = 0; i + 2 * stride < x.size(); ++i) {
    const double size = std::hypot(x[i], x[i + stride]);
    if (!(size > 0)) continue;
    const double a = x[i + stride] / size, b = x[i] / size, c = x[i + 2 * stride] / size;
    aa += a * a;
    ab += a * b;
    bb += b * b;
    ac += a * c;
    bc += b * c;
  }
  const double determinant = aa * bb - ab * ab;
  if (!(determinant > 0)) return std::nullopt;
  const double p = (ac * bb - bc * ab) / determinant, q = -(aa * bc - ab * ac) / determinant;
  const double discriminant = q - p * p / 4;
  if (!(q > 0 && discriminant > 0)) return std::nullopt;
  const double length = static_cast<double>(stride) * spacing;
  return Recurrence{std::atan2(std::sqrt(discriminant), p / 2) / length, -std::log(q) / (2 * length)};
}

EnergyGrowth energy_growth(const Oscillator<double>& oscillator, const Trajectory& trajectory) {
  std::vector<double> logarithm(trajectory.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i)
    logarithm[i] = std::log(energy(oscillator, State<double>{trajectory.x[i], trajectory.v[i]}));
  return {fit_line(trajectory.t, logarithm).slope};
}

}  // namespace cromer::core
