// Steps of fixed length: the fast loop, which nothing interrupts, and the one that looks into every step,
// with events or while a mass slides with dry friction.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "cromer/base/dual.h"
#include "cromer/base/function_ref.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"
#include "cromer/run/course.h"
#include "cromer/run/event.h"
#include "cromer/run/keep.h"

namespace cromer::core {

/// A system that is asked at any times: itself.
template <class S>
class OffGrid {
 public:
  static constexpr int block = 128;
  OffGrid(const S& system, double) : system_(system) {}
  const S& from(double) { return system_; }

 private:
  const S& system_;
};

/// A system ready for a block of times t, t + spacing, ...: its own tabulated form if it has one, else
/// itself.
template <class S>
class OnGrid : public OffGrid<S> {
  using OffGrid<S>::OffGrid;
};

template <class S>
requires requires(const S& system) { system.on_grid(1.0).move_to(0.0); }
class OnGrid<S> {
 public:
  static constexpr int block = S::block;
  OnGrid(const S& system, double spacing) : tabulated_(system.on_grid(spacing)) {}
  const auto& from(double first) {
    tabulated_.move_to(first);
    return tabulated_;
  }

 private:
  decltype(std::declval<const S&>().on_grid(1.0)) tabulated_;
};

/// The steps and iterations that a run has taken.
struct Tally {
  long long accepted = 0;  ///< steps
  long long newton_iterations = 0;
};

/// Where a run stands. x and v lie apart on purpose: side by side, GCC keeps them in one vector register
/// through the whole loop, and its shuffles lengthen the way x -> v -> x that limits the speed (W1 took 57 us
/// instead of 45).
template <class Real, class Memory>
struct Progress {
  Real x;
  Memory memory;
  Tally tally;
  Real v;
};

/// Steps first to last - 1 of the grid from + n h. What changes is local here, so that it stays in registers;
/// not inlined for the reason above.
template <class S, class M, class Real, class Memory, class Recorder>
[[gnu::noinline]] Status advance(const S& system, const M& method, double from, double h, long long first,
                                 long long last, Progress<Real, Memory>& progress, Recorder& record) {
  State<Real> y{progress.x, progress.v};
  Memory memory = progress.memory;
  long long n = first, newton_iterations = 0;
  Status status = Status::reached_end;
  double t = from + static_cast<double>(n) * h;
  while (n < last) {
    Trial<Real> trial = method.step(system, t, h, y, memory);
    newton_iterations += trial.newton_iterations;
    if (!trial.converged) {
      status = Status::no_convergence;
      break;
    }
    if (!is_finite(trial.y)) {
      status = Status::not_finite;
      break;
    }
    y = std::move(trial.y);
    ++n;
    t = from + static_cast<double>(n) * h;
    record(t, y);
  }
  progress = {y.x,
              memory,
              {progress.tally.accepted + (n - first), progress.tally.newton_iterations + newton_iterations},
              y.v};
  return status;
}

/// Walks through the steps of a run in blocks: steps(first, last) takes steps first to last - 1 of the grid,
/// last_step(t, h) the shorter one from t that ends the run. Compiled once; y and evaluations of the outcome
/// are left to the caller.
Outcome walk_in_blocks(Interval interval, double step, int block, const Tally& tally,
                       FunctionRef<Status(long long first, long long last)> steps,
                       FunctionRef<Status(double t, double h)> last_step, const Watch& watch,
                       const Limits& limits);

/// Runs method on system over the interval in steps of `step` > 0 [s]; state n is at from + n step, never
/// accumulated. Allocates nothing. Interrupt and progress are looked at every hundred steps or so.
template <class S, class M, class Real, class Recorder>
requires Method<M, S, Real> Outcome take_uniform_steps(const S& system, const M& method, Interval interval,
                                                       const State<Real>& start, double step,
                                                       Recorder& record, const Watch& watch,
                                                       const Limits& limits) {
  // A method that asks at other times than a grid's gets the system as it is.
  using Grid = std::conditional_t<(M::info.divisions > 0), OnGrid<S>, OffGrid<S>>;
  constexpr int divisions = std::max(M::info.divisions, 1);
  static_assert(Grid::block < KeepEvery::most_between_pauses);
  Grid grid(system, step / divisions);

  auto memory = method.start(system, interval.from, start);
  Progress<Real, decltype(memory)> progress{start.x, memory, {}, start.v};
  record(interval.from, start);

  const auto steps = [&](long long first, long long last) {
    const Status status = advance(grid.from(interval.from + static_cast<double>(first) * step), method,
                                  interval.from, step, first, last, progress, record);
    pause(record);
    return status;
  };
  const auto last_step = [&](double t, double h) {
    const Trial<Real> trial =
        one_step(system, method, t, h, State<Real>{progress.x, progress.v}, progress.memory);
    progress.tally.newton_iterations += trial.newton_iterations;
    if (!trial.converged) return Status::no_convergence;
    if (!is_finite(trial.y)) return Status::not_finite;
    progress.x = trial.y.x;
    progress.v = trial.y.v;
    ++progress.tally.accepted;
    record(t + h, trial.y);
    pause(record);
    return Status::reached_end;
  };
  Outcome outcome = walk_in_blocks(interval, step, Grid::block / divisions, progress.tally, steps, last_step,
                                   watch, limits);
  outcome.y = {value_of(progress.x), value_of(progress.v)};
  outcome.counts.evaluations =
      M::info.evaluations_of(progress.tally.accepted, progress.tally.newton_iterations);
  return outcome;
}

/// A method at work on a system, their types erased: what the loop that looks into every step sees.
template <class Real>
class StepperFor {
 public:
  virtual ~StepperFor() = default;

  /// From y at t to t + h; the next step goes on from there.
  virtual Trial<Real> step(double t, double h, const State<Real>& y) = 0;

  /// A step of length h from where the last one began: the result of a part of it. Changes nothing.
  virtual Trial<Real> part(double t, double h, const State<Real>& y) const = 0;

  /// The acceleration of its own that the method keeps from step to step; nullptr where it keeps none.
  virtual Real* carried() = 0;

  /// The system's.
  virtual Real acceleration(double t, const State<Real>& y) const = 0;

  virtual const MethodInfo& info() const = 0;

  /// No two zeros of the velocity lie closer together than this [s]; infinite where the system does not say
  /// (then the step is the caller's choice).
  virtual double zero_spacing() const = 0;

  /// Into how many parts a step must be divided so that no two zeros of the velocity fall into one. The first
  /// zero ends the phase, so that many parts cost nothing.
  long long parts_of_step(double h) const {
    return static_cast<long long>(std::min(1e15, 1 + std::floor(1.01 * h / zero_spacing())));
  }
};
using Stepper = StepperFor<double>;

/// system and method outlive it.
template <class S, class M, class Real>
requires Method<M, S, Real>
class StepperOf final : public StepperFor<Real> {
 public:
  /// For a run from y at t.
  StepperOf(const S& system, const M& method, double t, const State<Real>& y)
      : system_(system), method_(method), memory_(method.start(system, t, y)), before_(memory_) {}

  Trial<Real> step(double t, double h, const State<Real>& y) override {
    before_ = memory_;
    return one_step(system_, method_, t, h, y, memory_);
  }

  Trial<Real> part(double t, double h, const State<Real>& y) const override {
    auto copy = before_;
    return one_step(system_, method_, t, h, y, copy);
  }

  Real* carried() override {
    if constexpr (CarriesAcceleration<M, typename M::template Memory<Real>>)
      return &method_.carried(memory_);
    else
      return nullptr;
  }

  Real acceleration(double t, const State<Real>& y) const override {
    return system_.acceleration(t, y.x, y.v);
  }

  const MethodInfo& info() const override { return M::info; }

  double zero_spacing() const override {
    if constexpr (requires { system_.zero_spacing(); }) return system_.zero_spacing();
    return std::numeric_limits<double>::infinity();
  }

 private:
  const S& system_;
  const M& method_;
  typename M::template Memory<Real> memory_, before_;
};

/// Goes on from where the course stands, from row to row, until the last one, the end of the phase (rest, or
/// phase_end [s], to 1e-9 of a step), or an early end. A phase that begins between two rows first makes a
/// shorter step to the next: a method's partial step is as good as its step, so phases and events keep its
/// order. The stepper has been started where the course stands. A Look of another number than Real is not
/// asked.
///
/// Euler-Cromer moves through a whole step with the velocity at its end. Where the end of a phase cut a step
/// in two it would move through the first part with the velocity at the cut, which at a turning point is
/// none: each turn would add (step times frequency) squared / 3 to the energy, in the mean, and nothing else
/// of the method does. What the first part lacks is added.
template <class Real, class Look, class Recorder>
void take_searched_steps(StepperFor<Real>& stepper, const Rows& rows, const Look& look, Course<Real>& course,
                         const Recorder& record, const Watch& watch, const Limits& limits,
                         double phase_end = std::numeric_limits<double>::infinity()) {
  const auto count = [&](const Trial<Real>& trial) {
    course.counts.newton_iterations += trial.newton_iterations;
    course.counts.evaluations += stepper.info().evaluations_of(1, trial.newton_iterations);
    return trial;
  };
  if (course.at_rest && stepper.info().moves_with_last_velocity())
    course.y.x = course.y.x + course.cut_after * course.cut_before * stepper.acceleration(course.t, course.y);
  course.at_rest = false;
  // An end that is a row but for rounding is that row.
  const double soon = phase_end - same_time * rows.step;
  while (course.goes_on(rows) && !course.at_rest && course.t < soon) {
    course.look_up(rows, watch, limits);
    if (course.status != Status::reached_end) return;
    const bool to_row = rows.time(course.row + 1) <= phase_end + same_time * rows.step;
    const double next = to_row ? rows.time(course.row + 1) : phase_end;
    const double h = to_row && course.t == rows.time(course.row) ? rows.spacing(course.row) : next - course.t;
    if (!(h > 0)) {  // a phase ended just on the row
      ++course.row;
      record(course.t, course.y);
      continue;
    }
    const Trial<Real> trial = count(stepper.step(course.t, h, course.y));
    if (!trial.converged) {
      course.status = Status::no_convergence;
      return;
    }
    if (!is_finite(trial.y)) {
      course.status = Status::not_finite;
      return;
    }
    CutOf<Real> cut{.y = trial.y};
    if constexpr (std::is_same_v<Real, typename Look::Number>) {
      const auto partly = [&](double theta) { return count(stepper.part(course.t, theta * h, course.y)).y; };
      cut = look_inside(look, course.t, h, course.y, trial.y, stepper.parts_of_step(h), partly, partly);
    }
    ++course.counts.accepted;
    const bool whole = cut.theta == 1;
    course.t = whole ? next : course.t + cut.theta * h;
    course.y = cut.y;
    course.at_rest = cut.at_rest;
    course.cut_after = cut.theta * h;
    course.cut_before = h - course.cut_after;
    if (cut.stopped) course.status = Status::stopped_by_event;
    if (whole && to_row) ++course.row;
    if ((whole && to_row) || cut.stopped) record(course.t, course.y);
  }
}

/// The same for one number, compiled once.
void take_fixed_steps(Stepper& stepper, const Rows& rows, const Lookout& look, Course<double>& course,
                      AnyRecorder record, const Watch& watch, const Limits& limits,
                      double phase_end = std::numeric_limits<double>::infinity());

}  // namespace cromer::core
