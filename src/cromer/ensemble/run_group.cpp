#include "cromer/ensemble/run_group.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <complex>
#include <memory>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/frequency_response.h"
#include "cromer/base/pi.h"
#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/law_force.h"
#include "cromer/run/course.h"

namespace cromer::core {

static_assert(term_count <= cromer_group::most_terms);

void fill_group(std::span<const Point> points, cromer_group::Group& group) {
  assert(!points.empty() && points.size() <= static_cast<std::size_t>(cromer_group::size));
  group = {};
  for (int i = 0; i < cromer_group::size; ++i) {
    const Point& point = points[std::min<std::size_t>(i, points.size() - 1)];
    const Oscillator<double> per_mass = divided_by_mass(point.oscillator);
    for_each_term([&]<class T>() {
      group.coefficients[place_of_term<T>].of[i] = per_mass.*T::template members<double>[0];
    });
    const HarmonicForce<double> force = force_of(point.drive, point.oscillator.mass);
    group.drive_amplitude.of[i] = force.amplitude;
    group.drive_frequency.of[i] = force.frequency;
    group.drive_phase.of[i] = force.phase;
    group.step.of[i] = point.step;
    group.x.of[i] = point.start.x;
    group.v.of[i] = point.start.v;
    const Terms terms = terms_of(point.oscillator, point.drive);
    assert(smooth_terms.contains(terms.law));
    group.driven |= terms.drive;
    group.law |= terms.law.terms;
  }
}

cromer_group::Order order_of(const Stepping& stepping, long long steps, const double* weights) {
  const auto place = std::find(method_names.begin(), method_names.end(), stepping.method);
  assert(place != method_names.end());
  return {static_cast<unsigned>(place - method_names.begin()),
          stepping.settings.newton.tolerance,
          stepping.settings.beta,
          stepping.settings.gamma,
          stepping.settings.rho_inf,
          steps,
          weights};
}

namespace {

using cromer_group::Group;

constexpr long long steps_between_looks = 1 << 16;  // at the interrupt

/// not_finite or no_convergence if that is so of the i-th member; else done.
PointStatus status_of(const cromer_group::Group& group, int i) {
  if (group.failed.of[i] != 0) return PointStatus::no_convergence;
  return std::isfinite(group.x.of[i] - group.v.of[i]) ? PointStatus::done : PointStatus::not_finite;
}

/// Takes the shorter step that ends some runs, with all members: a run of its own, in which the drive goes
/// on where it was.
std::unique_ptr<Group> with_last_step(const Group& group, const KernelUnit& unit, const Stepping& stepping,
                                      const std::array<double, cromer_group::size>& last) {
  auto ended = std::make_unique<Group>(group);
  for (int i = 0; i < cromer_group::size; ++i) {
    ended->drive_phase.of[i] += group.drive_frequency.of[i] * (group.steps * group.step.of[i]);
    ended->step.of[i] =
        last[static_cast<std::size_t>(i)] > 0 ? last[static_cast<std::size_t>(i)] : group.step.of[i];
  }
  ended->steps = 0;
  unit.advance(*ended, order_of(stepping, 1));
  return ended;
}

PointResult result_of(const Group& group, int i, const Point& point, double end) {
  PointResult result;
  result.status = status_of(group, i);
  result.end_time = end;
  if (result.status != PointStatus::done) return result;
  result.peak = group.peak.of[i];
  result.end = {group.x.of[i], group.v.of[i]};
  result.energy = energy(point.oscillator, result.end);
  return result;
}

/// Steps of the longest window that any of the points asks for.
long long steps_for(std::span<const Point> points, double cycles) {
  double most = 1;
  for (const Point& point : points)
    most = std::max(most, cycles * two_pi / (point.drive.frequency * point.step));
  return static_cast<long long>(std::ceil(most * (1 - 1e-9)));
}

/// The third power of Hann's weights: a window holds whole cycles of some of its points only, and overtones,
/// or the energy's own swing at twice the frequency, leak into the others by less than 1e-7.
std::vector<double> window_weights(long long steps) {
  std::vector<double> weights(static_cast<std::size_t>(steps));
  for (long long n = 0; n < steps; ++n) {
    const double angle = two_pi * (static_cast<double>(n) + 0.5) / static_cast<double>(steps);
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

/// Whether a sequence of numbers has converged: the changes still to come, as a geometric series with the
/// ratio of the last two, sum up to no more than the tolerance.
class Convergence {
 public:
  bool operator()(std::complex<double> value, double tolerance) {
    const double change = std::abs(value - last_), size = std::abs(value);
    const double ratio = change_ > 0 ? std::min(change / change_, 1.0) : 1;
    // At rounding level the ratio means nothing. Small changes that do not fall are leakage.
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
  result.cycles = result.end_time * point.drive.frequency / two_pi;
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

bool run_group(const KernelUnit& unit, std::span<const Point> points, const Stepping& stepping,
               std::span<const double> until, std::span<PointResult> results, const Watch& watch) {
  assert(points.size() == results.size() && points.size() == until.size());
  auto group = std::make_unique<Group>();
  fill_group(points, *group);
  for (std::size_t k = 0; k < points.size(); ++k) group->peak.of[k] = std::abs(points[k].start.x);

  std::array<long long, cromer_group::size> whole{};
  std::array<double, cromer_group::size> last{};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Steps steps = count_steps({0, until[k]}, points[k].step);
    whole[k] = steps.whole;
    last[k] = steps.last;
  }
  const auto members = static_cast<std::ptrdiff_t>(points.size());
  const long long most = *std::max_element(whole.begin(), whole.begin() + members);
  for (long long taken = 0;;) {
    // To where the next member ends.
    long long next = most;
    for (std::size_t k = 0; k < points.size(); ++k)
      if (whole[k] >= taken) next = std::min(next, whole[k]);
    while (taken < next) {
      if (watch.interrupted()) return false;
      const long long steps = std::min(next - taken, steps_between_looks);
      unit.advance(*group, order_of(stepping, steps));
      taken += steps;
    }
    std::unique_ptr<Group> ended;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (whole[k] != taken) continue;
      const int i = static_cast<int>(k);
      if (last[k] > 0 && !ended) ended = with_last_step(*group, unit, stepping, last);
      results[k] = result_of(last[k] > 0 ? *ended : *group, i, points[k], until[k]);
    }
    if (taken == most) return true;
    // Members that have ended are skipped from now on.
    for (std::size_t k = 0; k < points.size(); ++k)
      if (whole[k] == taken) whole[k] = -1;
  }
}

}  // namespace cromer::core
