#include "cromer/tasks/sweep/sweep.h"

#include <algorithm>
#include <optional>

#include "cromer/run/keep.h"
#include "cromer/tasks/simulate/run_law.h"
#include "cromer/tasks/sweep/sweep_rows.h"

namespace cromer::core {
namespace {

constexpr std::size_t block = 4096;              // states
constexpr std::uint64_t points_counted = 10000;  // of a longer sweep

/// Keeps every n-th state and hands on whole blocks.
class Blocks {
 public:
  Blocks(long long every, const TrajectorySink& sink) : every_(every), sink_(sink) {}

  void begin() { next_ = 1; }

  void take(const std::vector<double>& values, double t, const State<double>& y) {
    if (--next_ > 0) return;
    next_ = every_;
    states_.t.push_back(t);
    states_.x.push_back(y.x);
    states_.v.push_back(y.v);
    if (states_.size() == block) hand_on(values);
  }

  void hand_on(const std::vector<double>& values) {
    if (!error_ && states_.size() > 0)
      if (auto good = sink_(values, states_); !good) error_ = good.error();
    states_.t.clear(), states_.x.clear(), states_.v.clear();
  }

  const std::optional<Error>& error() const { return error_; }

 private:
  long long every_, next_ = 1;
  const TrajectorySink& sink_;
  Trajectory states_{};
  std::optional<Error> error_{};
};

}  // namespace

Result<double> count_trajectory_states(const SweepPlan& plan, long long every) {
  const SweepWork& work = *plan.work;
  if (!work.runs_to_end()) return Error{"trajectories_have_no_end"};
  SweepPoints points(work.base, work.axes);
  std::vector<double> values(work.axes.size());
  const std::uint64_t looked_at = std::min(points_counted, plan.rows.rows);
  double states = 0;
  for (std::uint64_t i = 0; i < looked_at; ++i) {
    points.values_of(i * (plan.rows.rows / looked_at), values.data());
    if (const auto at = points.at(values.data()))
      states +=
          static_cast<double>(number_of_kept_states(count_steps({0, at->until}, at->point.step), every));
  }
  return states * (static_cast<double>(plan.rows.rows) / static_cast<double>(looked_at));
}

Result<SweptTrajectories> run_trajectories(const SweepPlan& plan, long long every, const TrajectorySink& sink,
                                           const Watch& watch) {
  const SweepWork& work = *plan.work;
  SweptTrajectories result;
  SweepPoints points(work.base, work.axes);
  std::vector<double> values(work.axes.size());
  Blocks blocks(every, sink);
  for (std::uint64_t row = 0; row < plan.rows.rows; ++row) {
    if (watch.progress) watch.progress(static_cast<double>(row) / static_cast<double>(plan.rows.rows));
    points.values_of(row, values.data());
    const auto at = points.at(values.data());
    if (!at) {  // nothing to choose a step by
      ++result.failed;
      continue;
    }
    blocks.begin();
    const auto take = [&](double t, const State<double>& y) { blocks.take(values, t, y); };
    KeepEvery keep{AnyRecorder(take)};
    const Outcome outcome = run_law({.oscillator = at->point.oscillator,
                                     .drive = at->point.drive,
                                     .method = work.method,
                                     .settings = at->settings,
                                     .interval = {0, at->until},
                                     .start = at->point.start,
                                     .control = {at->point.step, at->settings.newton.tolerance}},
                                    keep, {watch.interrupt, {}});
    blocks.hand_on(values);
    if (blocks.error()) return *blocks.error();
    if (outcome.interrupted) {
      result.interrupted = true;
      return result;
    }
    ++(outcome.status == Status::reached_end ? result.points : result.failed);
  }
  return result;
}

}  // namespace cromer::core
