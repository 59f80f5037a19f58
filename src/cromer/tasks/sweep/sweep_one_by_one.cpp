#include <algorithm>
#include <cmath>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/steady_state.h"
#include "cromer/base/pi.h"
#include "cromer/run/keep.h"
#include "cromer/tasks/simulate/run_law.h"
#include "cromer/tasks/sweep/sweep_rows.h"

namespace cromer::core {
namespace {

PointStatus status_of(const Outcome& outcome) {
  switch (outcome.status) {
    case Status::reached_end:
    case Status::stopped_by_event:
      return PointStatus::done;
    case Status::no_convergence:
      return PointStatus::no_convergence;
    default:
      return PointStatus::not_finite;
  }
}

struct Run {
  Outcome outcome;
  Trajectory window;  ///< the states from a time on
  double peak = 0, energy = 0, square = 0;
};

/// Runs to `until` [s], and keeps what follows `from` [s].
Run run_to(const SweepWork& work, const SweepPoint& at, double from, double until, const Watch& watch) {
  const Point& point = at.point;
  Run run;
  double states = 0;
  const auto look_at = [&](double t, const State<double>& y) {
    if (t < from) return;
    run.window.t.push_back(t);
    run.window.x.push_back(y.x);
    run.window.v.push_back(y.v);
    run.peak = std::max(run.peak, std::abs(y.x));
    run.energy += energy(point.oscillator, y);
    run.square += y.x * y.x;
    ++states;
  };
  KeepEvery keep(look_at);
  run.outcome = run_law({.oscillator = point.oscillator,
                         .drive = point.drive,
                         .method = work.method,
                         .settings = at.settings,
                         .interval = {0, until},
                         .start = point.start,
                         .control = {point.step, at.settings.newton.tolerance}},
                        keep, {watch.interrupt, {}});
  run.energy /= std::max(states, 1.0);
  run.square /= std::max(states, 1.0);
  return run;
}

PointResult result_of(const Point& point, const Run& run) {
  PointResult result;
  result.status = status_of(run.outcome);
  result.end_time = run.outcome.t;
  if (result.status != PointStatus::done) return result;
  result.end = run.outcome.y;
  result.peak = run.peak;
  result.energy = energy(point.oscillator, run.outcome.y);
  return result;
}

}  // namespace

std::optional<PointResult> run_point(const SweepWork& work, const SweepPoint& at, const Watch& watch) {
  const Point& point = at.point;
  if (work.way != SweepWay::one_by_one || work.runs_to_end()) {
    const Run run = run_to(work, at, 0, at.until, watch);
    if (run.outcome.interrupted) return std::nullopt;
    return result_of(point, run);
  }
  // Twice as long each time, until amplitude and energy stay.
  const double period = two_pi / point.drive.frequency;
  const double window = 2 * std::ceil(work.settling.window / 2) * period;
  double cycles = work.settling.dropped.value_or(32), amplitude = 0;
  for (;; cycles *= 2) {
    const double until = cycles * period + window;
    const Run run = run_to(work, at, until - window - point.step, until, watch);
    if (run.outcome.interrupted) return std::nullopt;
    PointResult result = result_of(point, run);
    if (result.status != PointStatus::done) return result;
    const auto steady =
        measure_steady_state(run.window, point.drive, static_cast<int>(std::lround(window / period)));
    if (!steady) {
      result.status = PointStatus::not_settled;
      return result;
    }
    result.amplitude = steady->amplitude;
    result.phase_lag = steady->phase_lag;
    result.mean = steady->mean;
    result.rms = std::sqrt(run.square);
    result.energy = run.energy;
    result.cycles = cycles;
    // The window holds whole cycles only to within a step: overtones leak in by some 1e-5.
    const double tolerance = std::max(work.settling.tolerance, 1e-5);
    if (work.settling.dropped || std::abs(steady->amplitude - amplitude) <= tolerance * steady->amplitude)
      return result;
    if (2 * cycles > work.settling.most_cycles) {
      result.status = PointStatus::not_settled;
      return result;
    }
    amplitude = steady->amplitude;
  }
}

}  // namespace cromer::core
