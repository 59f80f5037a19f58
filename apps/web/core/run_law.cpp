// Runs of any law under a harmonic drive or none. This file replaces tasks/simulate/run_law, which has code
// for each kind of law, method and drive.
#include "cromer/tasks/simulate/run_law.h"

#include <cassert>

#include "any_method.h"
#include "cromer/methods/dormand_prince.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace cromer::core {
namespace {

/// The same as take_uniform_steps.
Outcome uniform_steps(AnyTerms& system, Stepper& stepper, const LawRun& run, KeepEvery& keep,
                      const Watch& watch) {
  const double step = run.control.step, from = run.interval.from;
  const MethodInfo& info = stepper.info();
  const int divisions = std::max(info.divisions, 1);
  const bool on_grid = info.divisions > 0 && system.driven();
  TabulatedForce<double> table(on_grid ? system.force() : HarmonicForce<double>{}, step / divisions);

  State<double> y = run.start;
  Tally tally;
  keep(from, y);
  const auto take = [&](double t, double h, double end) {
    const Trial<double> trial = stepper.step(t, h, y);
    tally.newton_iterations += trial.newton_iterations;
    if (!trial.converged) return Status::no_convergence;
    if (!is_finite(trial.y)) return Status::not_finite;
    y = trial.y;
    ++tally.accepted;
    keep(end, y);
    return Status::reached_end;
  };
  const auto steps = [&](long long first, long long last) {
    if (on_grid) table.move_to(from + static_cast<double>(first) * step);
    system.look_up_drive(on_grid ? &table : nullptr);
    Status status = Status::reached_end;
    for (long long n = first; n < last && status == Status::reached_end; ++n)
      status = take(from + static_cast<double>(n) * step, step, from + static_cast<double>(n + 1) * step);
    keep.pause();
    system.look_up_drive(nullptr);
    return status;
  };
  const auto last_step = [&](double t, double h) {
    const Status status = take(t, h, t + h);
    keep.pause();
    return status;
  };
  Outcome outcome = walk_in_blocks(run.interval, step, TabulatedForce<double>::block / divisions, tally,
                                   steps, last_step, watch, {});
  outcome.y = y;
  outcome.counts.evaluations = info.evaluations_of(tally.accepted, tally.newton_iterations);
  return outcome;
}

/// The same as solve() of a FrictionSystem.
Outcome slip_and_stick(const AnyFriction& system, const LawRun& run, KeepEvery& keep, const Watch& watch) {
  const Rows rows{run.interval, run.control.step};
  Course<double> course{run.interval.from, run.start};
  const auto record = [&](double t, const State<double>& y) {
    keep(t, y);
    keep.pause();
  };
  record(course.t, course.y);
  const auto slide = [&](int direction) {
    const AnyTerms smooth = system.sliding(direction);
    const auto stepper = page::stepper_of(run.method, run.settings, smooth, course.t, course.y);
    take_fixed_steps(*stepper, rows, {direction, nullptr}, course, record, watch, {});
  };
  stick_and_slip(system, rows, course, slide, record, watch);
  return course.outcome(rows, watch);
}

Outcome run_terms(AnyTerms smooth, const Oscillator<double>& per_mass, const LawRun& run, KeepEvery& keep,
                  const Watch& watch) {
  const bool rubs = per_mass.friction != 0 || per_mass.static_friction != 0;
  const AnyFriction rubbing(smooth, per_mass.friction, per_mass.static_friction);
  if (run.method == DormandPrince::info.name) {
    const DormandPrince method;
    return rubs ? solve(rubbing, method, run.interval, run.start, run.control, keep, watch)
                : solve(smooth, method, run.interval, run.start, run.control, keep, watch);
  }
  if (rubs) return slip_and_stick(rubbing, run, keep, watch);
  const auto stepper = page::stepper_of(run.method, run.settings, smooth, run.interval.from, run.start);
  return uniform_steps(smooth, *stepper, run, keep, watch);
}

}  // namespace

Outcome run_law(const LawRun& run, KeepEvery& keep, const Watch& watch) {
  assert(!run.compensated && !run.general && (!run.events || run.events->events.empty()));
  const Oscillator<double> per_mass = divided_by_mass(run.oscillator);
  return run_terms(AnyTerms(per_mass, force_of(run.drive, run.oscillator.mass)), per_mass, run, keep, watch);
}

}  // namespace cromer::core
