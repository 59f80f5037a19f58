// The loop for steps of fixed length that nothing interrupts: the fast one.
#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>

#include "cromer/base/dual.h"
#include "cromer/base/function_ref.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"
#include "cromer/run/course.h"
#include "cromer/run/keep.h"
#include "cromer/run/outcome.h"
#include "cromer/run/stepper.h"
#include "cromer/run/steps.h"

namespace cromer::core {

/// A system for any times: itself.
template <class S>
class OffGrid {
 public:
  static constexpr int block = 128;
  OffGrid(const S& system, double) : system_(system) {}
  const S& from(double) { return system_; }

 private:
  const S& system_;
};

/// A system ready for times t, t + spacing, ..., block of them: its own tabulated form if it has one, else
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

/// What a run has taken.
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
    const Trial<Real> trial = method.step(system, t, h, y, memory);
    newton_iterations += trial.newton_iterations;
    if (!trial.converged) {
      status = Status::no_convergence;
      break;
    }
    if (!is_finite(trial.y)) {
      status = Status::not_finite;
      break;
    }
    y = trial.y;
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

}  // namespace cromer::core
