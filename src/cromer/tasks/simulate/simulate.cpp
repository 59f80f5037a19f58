#include "cromer/tasks/simulate/simulate.h"

#include <cmath>

#include "cromer/analysis/energy.h"
#include "cromer/base/interrupt.h"
#include "cromer/model/sensor.h"
#include "cromer/run/keep.h"
#include "cromer/tasks/simulate/early_end.h"
#include "cromer/tasks/simulate/run_effect.h"
#include "cromer/tasks/simulate/run_energy.h"
#include "cromer/tasks/simulate/run_law.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {

Notice early_end(const Outcome& outcome) {
  switch (outcome.status) {
    case Status::reached_end:
      return {};
    case Status::stopped_by_event:
      if (!outcome.interrupted) return {};
      return Notice{"run_interrupted", {{"t", outcome.t}, {"step", outcome.step}}};
    case Status::step_limit:
      return Notice{"run_at_step_limit", {{"t", outcome.t}, {"step", outcome.step}}};
    case Status::step_too_small:
      return Notice{"run_step_too_small", {{"t", outcome.t}, {"step", outcome.step}}};
    case Status::no_convergence:
      return Notice{"run_without_convergence", {{"t", outcome.t}, {"step", outcome.step}}};
    case Status::not_finite:
      return Notice{"run_diverged", {{"t", outcome.t}, {"step", outcome.step}}};
  }
  return {};
}

namespace {

/// A state whose energy overflows is as bad as one that is not finite: the run ends at the last kept state
/// before it.
void end_before_overflow(SimulatedRun& run, long long every) {
  Trajectory& kept = run.trajectory;
  const auto overflows = [&](const State<double>& y) { return !std::isfinite(energy(run.oscillator, y)); };
  std::size_t size = 0;
  while (size < kept.size() && !overflows({kept.x[size], kept.v[size]})) ++size;
  if (size == kept.size() && !overflows(run.outcome.y)) return;
  kept.t.resize(size);
  kept.x.resize(size);
  kept.v.resize(size);
  run.outcome.status = Status::not_finite;
  run.outcome.t = kept.t.back();
  run.outcome.y = {kept.x.back(), kept.v.back()};
  run.outcome.step = static_cast<long long>(size - 1) * every;
  run.outcome.last_step = 0;
}

void integrate(SimulatedRun& run, long long every, const Watch& watch) {
  const Interval interval{0, run.until};
  KeepEvery keep(every, count_steps(interval, run.step));
  run.outcome = run_law({.oscillator = run.oscillator,
                         .drive = run.drive,
                         .general = run.general ? &*run.general : nullptr,
                         .method = run.method,
                         .settings = run.settings,
                         .interval = interval,
                         .start = run.start,
                         .control = {run.step, run.tolerance},
                         .events = &run.events,
                         .compensated = run.compensated},
                        keep, watch);
  run.trajectory = keep.take();
  end_before_overflow(run, every);
  run.message = early_end(run.outcome);
}

std::vector<double> readings(const Trajectory& trajectory, const SensorOptions& options) {
  SensorReadings sensor({options.noise, options.resolution, options.offset, options.seed});
  std::vector<double> samples;
  samples.reserve(trajectory.size());
  for (const double x : trajectory.x) samples.push_back(sensor.next(x));
  return samples;
}

SimulateOptions with_defaults(SimulateOptions options, const SimulatedRun& run) {
  options.stiffness = run.oscillator.stiffness;
  options.damping = run.oscillator.damping;
  options.position = run.start.x;
  options.velocity = run.start.v;
  if (options.method.empty()) options.method = {run.method};
  options.tolerance = run.tolerance;
  return options;
}

}  // namespace

Result<SimulateResult> simulate(const SimulateOptions& options, const Watch& watch) {
  auto runs = set_up_runs(options);
  if (!runs) return runs.error();
  if (options.accuracy)
    if (auto good = choose_steps(options, *runs, watch); !good) return good.error();
  for (auto& run : *runs) {
    run.effect = effect_of(run);
    if (!options.motion_only) run.transmission = transmission_of(options, run);
  }
  SimulateResult result;
  result.notices = setup_notices(options, *runs);
  result.options = with_defaults(options, runs->front());
  result.runs = *std::move(runs);
  const auto all = static_cast<double>(result.runs.size());
  double done = 0;
  for (SimulatedRun& run : result.runs) {
    integrate(run, options.every, part_of(watch, done / all, (done + 1) / all));
    ++done;
    if (run.events.missed > 0)
      result.notices.push_back(Notice{
          "events_not_listed",
          {{"run", run.label}, {"listed", EventLog::most}, {"events", EventLog::most + run.events.missed}}});
    if (!options.motion_only) {
      run.energy_balance = energy_balance_of(run);
      run.modified_energy = modified_energy_of(run);
      run.measured = measured_oscillator_of(run);
    }
    if (options.sensor.used) run.sensor = readings(run.trajectory, options.sensor);
  }
  return result;
}

}  // namespace cromer::core
