// The loop for steps of fixed length that nothing interrupts: the fast one.
#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>

#include "cromer/base/dual.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/state.h"
#include "cromer/methods/method.h"
#include "cromer/run/course.h"
#include "cromer/run/outcome.h"
#include "cromer/run/steps.h"

namespace cromer {

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

/// Where a run stands. x and v lie apart on purpose: side by side, GCC keeps them in one vector register
/// through the whole loop, and its shuffles lengthen the way x -> v -> x that limits the speed (W1 took 57 us
/// instead of 45).
template <class Real, class Memory>
struct Progress {
  Real x;
  Memory memory;
  long long accepted = 0;
  long long newton_iterations = 0;
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
  progress = {y.x, memory, progress.accepted + (n - first), progress.newton_iterations + newton_iterations,
              y.v};
  return status;
}

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
  constexpr int block = Grid::block / divisions;
  Grid grid(system, step / divisions);

  const Steps steps = count_steps(interval, step);
  const long long whole = std::min(steps.whole, limits.steps);
  const auto time = [&](long long n) { return interval.from + static_cast<double>(n) * step; };

  auto memory = method.start(system, interval.from, start);
  Progress<Real, decltype(memory)> progress{start.x, memory, 0, 0, start.v};
  record(interval.from, start);

  Outcome outcome;
  Status& status = outcome.status;
  for (long long n = 0; n < whole && status == Status::reached_end; n += block) {
    if (watch.interrupted()) {
      outcome.interrupted = true;
      status = Status::stopped_by_event;
      break;
    }
    if (watch.progress && n % (64 * block) == 0)
      watch.progress(static_cast<double>(n) / static_cast<double>(steps.count()));
    status = advance(grid.from(time(n)), method, interval.from, step, n, std::min(n + block, whole), progress,
                     record);
  }
  outcome.t = time(progress.accepted);
  if (status == Status::reached_end && whole < steps.count()) {
    if (whole == limits.steps) {
      status = Status::step_limit;
    } else if (status = advance(system, method, outcome.t, steps.last, 0, 1, progress, record);
               status == Status::reached_end) {
      outcome.last_step = steps.last;
      outcome.t += steps.last;
    }
  }
  if (status == Status::reached_end && watch.progress) watch.progress(1.0);

  outcome.y = {value_of(progress.x), value_of(progress.v)};
  outcome.step = progress.accepted;
  outcome.counts = {.accepted = progress.accepted,
                    .rejected = 0,
                    .evaluations = M::info.evaluations_of(progress.accepted, progress.newton_iterations),
                    .newton_iterations = progress.newton_iterations};
  return outcome;
}

}  // namespace cromer
