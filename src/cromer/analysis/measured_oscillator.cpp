#include "cromer/analysis/measured_oscillator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/line.h"
#include "cromer/base/state.h"

namespace cromer::core {
namespace {

/// The parabola through three samples, the nearest first.
struct Parabola {
  std::array<double, 3> t;
  double value, slope, bend;  ///< at the first sample; of u = t - t[0]: value + slope u + bend u^2

  Parabola(const std::vector<double>& times, const std::vector<double>& y,
           const std::array<std::size_t, 3>& of)
      : t{times[of[0]], times[of[1]], times[of[2]]}, value(y[of[0]]) {
    const double first = (y[of[1]] - value) / (t[1] - t[0]), second = (y[of[2]] - value) / (t[2] - t[0]);
    bend = (second - first) / (t[2] - t[1]);
    slope = first - bend * (t[1] - t[0]);
  }
  double root() const {
    const double part = std::sqrt(std::max(0.0, slope * slope - 4 * bend * value));
    return t[0] - 2 * value / (slope + std::copysign(part, slope));
  }
  /// What an interpolation leaves out grows as this.
  double distance(double at) const { return std::abs((at - t[0]) * (at - t[1]) * (at - t[2])); }
};

constexpr std::size_t beside = 3;  // states on either side of a turning point

/// The polynomial through the states beside a turning point, of which state `i` is the last before it.
double position_at(const Trajectory& kept, std::size_t i, double t) {
  double sum = 0;
  for (std::size_t a = i + 1 - beside; a <= i + beside; ++a) {
    double part = kept.x[a];
    for (std::size_t b = i + 1 - beside; b <= i + beside; ++b)
      if (b != a) part *= (t - kept.t[b]) / (kept.t[a] - kept.t[b]);
    sum += part;
  }
  return sum;
}

/// Where the velocity is zero between two states with opposite signs. Of a first-order method velocity and
/// slope of the position differ by half a step: the velocity alone tells when, as it does of a release from
/// rest. Dry friction bends it sharply at its zero: it is followed there from either side by itself, and
/// what the two leave out cancels.
TurningPoint turn_between(const Trajectory& kept, std::size_t i) {
  const Parabola before(kept.t, kept.v, {i, i - 1, i - 2}), after(kept.t, kept.v, {i + 1, i + 2, i + 3});
  const auto within = [&](double t) { return std::clamp(t, kept.t[i], kept.t[i + 1]); };
  const double early = within(before.root()), late = within(after.root()), middle = (early + late) / 2;
  const double share = after.distance(middle) / (after.distance(middle) + before.distance(middle));
  const double t = late + share * (early - late);
  return {t, position_at(kept, i, t)};
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
    } else if (kept.v[i] * kept.v[i + 1] < 0 && i + 1 >= beside && i + beside < kept.size()) {
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
