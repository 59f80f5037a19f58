#include "cromer/analysis/steady_state.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cromer/base/pi.h"

namespace cromer::core {
namespace {

struct Sinusoid {
  double mean, cosine, sine, residual;

  double amplitude() const { return std::hypot(cosine, sine); }
};

/// With Hann's weights: the window holds whole cycles only to within a step, and of overtones little leaks
/// in.
Sinusoid fit_sinusoid(const Trajectory& y, const HarmonicDrive<double>& drive, std::size_t first,
                      std::size_t last) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const auto basis = [&](std::size_t i) {
    const double angle = drive.frequency * y.t[i] + drive.phase;
    return Eigen::Vector3d(1, std::cos(angle), std::sin(angle));
  };
  for (std::size_t i = first; i < last; ++i) {
    const double place = (static_cast<double>(i - first) + 0.5) / static_cast<double>(last - first);
    const Eigen::Vector3d u = basis(i), weighted = (1 - std::cos(two_pi * place)) * u;
    normal += weighted * u.transpose();
    right += y.x[i] * weighted;
  }
  const Eigen::Vector3d c = normal.ldlt().solve(right);
  double squares = 0;
  for (std::size_t i = first; i < last; ++i) {
    const double r = y.x[i] - c.dot(basis(i));
    squares += r * r;
  }
  return {c[0], c[1], c[2], std::sqrt(squares / static_cast<double>(last - first))};
}

/// How many states lie a whole step after the one before: all, or all but the last. What a method settles at
/// depends on its step, so the state after a shorter one lies on another steady motion.
std::size_t evenly_spaced(const Trajectory& y) {
  const std::size_t n = y.size();
  const double last = y.t[n - 1] - y.t[n - 2], before = y.t[n - 2] - y.t[n - 3];
  return last < before * (1 - 1e-6) ? n - 1 : n;
}

}  // namespace

Result<MeasuredSteadyState> measure_steady_state(const Trajectory& trajectory,
                                                 const HarmonicDrive<double>& drive, int cycles) {
  if (!(drive.amplitude != 0 && drive.frequency > 0)) return Error{"no_harmonic_drive"};
  if (trajectory.size() < 8) return Error{"too_few_states_for_steady"};
  const double period = two_pi / drive.frequency;
  const std::size_t last = evenly_spaced(trajectory);
  const double end = trajectory.t[last - 1];
  // A sample early at the start may belong to the window by rounding only.
  const double slack = 1e-9 * period;
  const auto since = [&](double t) {
    return static_cast<std::size_t>(std::lower_bound(trajectory.t.begin(), trajectory.t.end(), t - slack) -
                                    trajectory.t.begin());
  };
  const int available =
      static_cast<int>(std::min(1e6, std::floor((end - trajectory.t.front()) / period + 1e-9)));
  const int used = std::min(std::max(cycles, 2), available) / 2 * 2;
  if (used < 2) return Error{"run_shorter_than_two_periods"};
  const std::size_t first = since(end - used * period);
  if (last - first < 4 * static_cast<std::size_t>(used)) return Error{"too_few_states_a_period"};

  const Sinusoid whole = fit_sinusoid(trajectory, drive, first, last);
  const std::size_t middle = since(end - used / 2 * period);
  const Sinusoid first_half = fit_sinusoid(trajectory, drive, first, middle),
                 second_half = fit_sinusoid(trajectory, drive, middle, last);
  const double before = first_half.amplitude(), after = second_half.amplitude();

  // a cos u + b sin u = X cos(u - delta)
  const Transmission answer = transmission(whole.cosine, whole.sine);
  MeasuredSteadyState measured;
  measured.amplitude = answer.amplitude;
  measured.phase_lag = answer.phase_lag;
  measured.mean = whole.mean;
  measured.residual = whole.residual;
  measured.change = after > 0 ? (after - before) / after : 0;
  measured.growth = after > 0 ? (second_half.residual - first_half.residual) / after : 0;
  measured.cycles = used;
  return measured;
}

}  // namespace cromer::core
