#include "cromer/tasks/curves/work_precision.h"

#include <algorithm>
#include <cmath>

#include "cromer/analysis/line.h"
#include "cromer/methods/all.h"
#include "cromer/model/law_force.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

constexpr double finest = 1e-14;

/// The last state, and the largest position and velocity on the way.
struct Truth {
  State<double> end;
  double position = 0, velocity = 0;
};

Result<Truth> truth_of(const SimulateOptions& options, const SimulatedRun& run) {
  SimulateOptions reference = options;
  reference.compensated = false;
  reference.step = run.step;
  const bool closed = std::string_view(why_not_exact(run.oscillator)).empty() && !run.general;
  reference.method = {closed ? "exact" : "dormand-prince"};
  if (!closed) reference.tolerance = finest;
  const auto result = simulate(reference);
  if (!result) return result.error();
  if (!result->ok()) return Error{"reference_run_failed", {{"what", result->runs.front().message}}};
  const SimulatedRun& fine = result->runs.front();
  Truth truth{fine.outcome.y, 0, 0};
  for (const double x : fine.trajectory.x) truth.position = std::max(truth.position, std::abs(x));
  for (const double v : fine.trajectory.v) truth.velocity = std::max(truth.velocity, std::abs(v));
  return truth;
}

double slope_of(const WorkPrecisionCurve& curve) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < curve.error.size(); ++i)
    if (curve.error[i] > 1e-10 && curve.error[i] < 1e-3) {
      x.push_back(std::log(curve.evaluations[i]));
      y.push_back(std::log(curve.error[i]));
    }
  return x.size() > 1 ? fit_line(x, y).slope : 0;
}

}  // namespace

Result<WorkPrecisionResult> work_precision(const WorkPrecisionOptions& options, const Watch& watch) {
  if (!(options.longest > 0)) return Error{"longest_not_positive"};
  if (options.halvings < 1 || options.halvings > 30) return Error{"halvings_out_of_range"};
  const auto runs = set_up_runs(options.simulate);
  if (!runs) return runs.error();
  const SimulatedRun& first = runs->front();
  const auto truth = truth_of(options.simulate, first);
  if (!truth) return truth.error();

  WorkPrecisionResult result;
  for (std::size_t m = 0; m < runs->size(); ++m) {
    const SimulatedRun& run = (*runs)[m];
    const bool adaptive = find_method(run.method)->is_adaptive();
    WorkPrecisionCurve curve;
    curve.method = run.method;
    for (long long i = 0; i <= options.halvings; ++i) {
      if (watch.interrupted()) return Error{"interrupted"};
      SimulateOptions trial = options.simulate;
      trial.method = {run.method};
      const double step = first.step * default_steps_per_period * options.longest;
      // A step that fills the run a whole number of times still does when halved.
      trial.step =
          adaptive ? first.until : first.until / (std::ceil(first.until / step) * std::ldexp(1.0, int(i)));
      if (adaptive)
        trial.tolerance = std::max(finest, std::pow(10, -2 - static_cast<double>(i)));
      else
        trial.tolerance = 1e-15;
      trial.every = 1'000'000'000;
      const auto simulated = simulate(trial);
      if (!simulated) return simulated.error();
      const SimulatedRun& done = simulated->runs.front();
      if (done.outcome.status != Status::reached_end) continue;
      const double error = std::max(std::abs(done.outcome.y.x - truth->end.x) / truth->position,
                                    std::abs(done.outcome.y.v - truth->end.v) / truth->velocity);
      if (!(error < 10)) continue;
      curve.evaluations.push_back(static_cast<double>(done.outcome.counts.evaluations));
      curve.error.push_back(error);
      if (watch.progress)
        watch.progress(
            (static_cast<double>(m) + static_cast<double>(i) / static_cast<double>(options.halvings)) /
            static_cast<double>(runs->size()));
    }
    curve.slope = slope_of(curve);
    result.curves.push_back(std::move(curve));
  }
  return result;
}

}  // namespace cromer::core
