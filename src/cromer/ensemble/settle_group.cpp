#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>

#include "cromer/analysis/frequency_response.h"
#include "cromer/ensemble/fill_group.h"
#include "cromer/ensemble/run_group.h"

namespace cromer::core {
namespace {

using cromer_group::Group;

/// Steps of the longest window that any of the points asks for.
long long steps_for(std::span<const Point> points, double cycles) {
  double most = 1;
  for (const Point& point : points)
    most = std::max(most, cycles * 2 * std::numbers::pi / (point.drive.frequency * point.step));
  return static_cast<long long>(std::ceil(most * (1 - 1e-9)));
}

/// The third power of Hann's weights: a window holds whole cycles of some of its points only, and overtones,
/// or the energy's own swing at twice the frequency, leak into the others by less than 1e-7.
std::vector<double> window_weights(long long steps) {
  std::vector<double> weights(static_cast<std::size_t>(steps));
  for (long long n = 0; n < steps; ++n) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(n) + 0.5) / static_cast<double>(steps);
    const double hann = 1 - std::cos(angle);
    weights[static_cast<std::size_t>(n)] = hann * hann * hann;
  }
  return weights;
}

/// Mean and sinusoid of one member over a window.
struct Measured {
  double mean;
  std::complex<double> sinusoid;  ///< x = mean + re cos + im sin of the drive's angle
  double square;                  // [m^2] mean of x^2
  double energy;                  // [J]
};

Measured measure(const Group& group, int i, double weight, double mass) {
  const cromer_group::Sums& sums = group.sums;
  Eigen::Matrix3d normal;
  normal << weight, sums.c.of[i], sums.s.of[i], sums.c.of[i], sums.cc.of[i], sums.cs.of[i], sums.s.of[i],
      sums.cs.of[i], sums.ss.of[i];
  const Eigen::Vector3d fitted =
      normal.ldlt().solve(Eigen::Vector3d(sums.x.of[i], sums.xc.of[i], sums.xs.of[i]));
  return {fitted[0], {fitted[1], fitted[2]}, sums.xx.of[i] / weight, mass * sums.energy.of[i] / weight};
}

/// Whether numbers that come one after the other have come to rest: the changes still to come, as a geometric
/// series with the ratio of the last two, sum up to no more than the tolerance.
class Convergence {
 public:
  bool operator()(std::complex<double> value, double tolerance) {
    const double change = std::abs(value - last_), size = std::abs(value);
    const double ratio = change_ > 0 ? std::min(change / change_, 1.0) : 1;
    // At rounding level the ratio means nothing, and small changes that do not fall are what leaks.
    const bool leaks = ratio >= 1 && change <= tolerance * size;
    const bool falls =
        ratio < 1 && change * ratio / (1 - ratio) <= tolerance * size && change <= 10 * tolerance * size;
    const bool still = change <= 1e-12 * size || leaks || falls;
    last_ = value;
    change_ = change;
    return still && ++seen_ > 2;
  }

 private:
  std::complex<double> last_{};
  double change_ = 0;
  int seen_ = 0;
};

PointResult result_of(const Group& group, int i, const Point& point, const Measured& measured) {
  const Transmission answer = transmission(measured.sinusoid.real(), measured.sinusoid.imag());
  PointResult result;
  result.amplitude = answer.amplitude;
  result.phase_lag = answer.phase_lag;
  result.mean = measured.mean;
  result.rms = std::sqrt(measured.square);
  result.peak = group.peak.of[i];
  result.energy = measured.energy;
  result.end = {group.x.of[i], group.v.of[i]};
  result.end_time = group.steps * point.step;
  result.cycles = result.end_time * point.drive.frequency / (2 * std::numbers::pi);
  return result;
}

}  // namespace

bool settle_group(const KernelUnit& unit, std::span<const Point> points, const Stepping& stepping,
                  const Settling& settling, std::span<PointResult> results, const Watch& watch) {
  assert(points.size() == results.size());
  auto group = std::make_unique<Group>();
  fill_group(points, *group);
  const long long window = steps_for(points, settling.window);
  const std::vector<double> weights = window_weights(window);
  double weight = 0;
  for (const double w : weights) weight += w;

  if (settling.dropped && *settling.dropped > 0) {
    const long long dropped = steps_for(points, *settling.dropped);
    for (long long n = 0; n < dropped; n += window) {
      if (watch.interrupted()) return false;
      unit.advance(*group, order_of(stepping, std::min(window, dropped - n)));
    }
  }
  std::array<Convergence, cromer_group::size> motion, energy;
  std::array<bool, cromer_group::size> settled{};
  for (std::size_t left = points.size(); left > 0;) {
    if (watch.interrupted()) return false;
    group->peak = {};
    group->sums = {};
    unit.advance(*group, order_of(stepping, window, weights.data()));
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (settled[k]) continue;
      const int i = static_cast<int>(k);
      const Point& point = points[k];
      PointResult& result = results[k];
      if (const PointStatus status = status_of(*group, i); status != PointStatus::done) {
        result = {};
        result.status = status;
        settled[k] = true;
        --left;
        continue;
      }
      const Measured measured = measure(*group, i, weight, point.oscillator.mass);
      const bool still = motion[k](measured.sinusoid, settling.tolerance);
      const bool steady = energy[k](measured.energy, settling.tolerance);
      result = result_of(*group, i, point, measured);
      if (settling.dropped || (still && steady)) {
        settled[k] = true;
      } else if (result.cycles >= settling.most_cycles) {
        result.status = PointStatus::not_settled;
        settled[k] = true;
      }
      left -= settled[k];
    }
  }
  return true;
}

}  // namespace cromer::core
