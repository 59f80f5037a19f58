// --accuracy: the largest step with which a method keeps to the law over a run.
#include "cromer/tasks/simulate/simulate_setup.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "cromer/analysis/frequency_response.h"
#include "cromer/analysis/measured_oscillator.h"
#include "cromer/methods/all.h"
#include "cromer/model/law_force.h"
#include "cromer/model/linear_quantities.h"
#include "cromer/tasks/methods/method_effect.h"

namespace cromer::core {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double reference_tolerance = 1e-13;

/// The errors of a run with a step; the worst is infinite if it fails.
using Attempt = std::function<Accuracy(double step)>;

/// The longest step not above h that fills the run a whole number of times.
double whole_step(double h, double until) { return until / std::ceil(until / h * (1 - 1e-12)); }

/// The underdamped linear law of a free or harmonically driven run.
std::optional<LinearLaw<double>> oscillating_law(const SimulatedRun& run) {
  const Oscillator<double>& o = run.oscillator;
  if (run.general || !is_linear(law_of(o))) return std::nullopt;
  const LinearLaw<double> law = linear_law(o, run.drive);
  if (!(law.stiffness > law.decay_rate * law.decay_rate)) return std::nullopt;
  return law;
}

/// Errors over the run of a free motion with this frequency and decay rate.
Accuracy errors_of(const LinearLaw<double>& law, double until, double frequency, double decay_rate) {
  Accuracy found;
  found.frequency_error = std::abs(frequency / damped_frequency(law) - 1);
  const double off = decay_rate - law.decay_rate;
  if (law.decay_rate > 0) found.decay_error = std::abs(off / law.decay_rate);
  found.amplitude_error = std::abs(std::expm1(-off * until));
  return found;
}

/// The errors of the oscillator that the method simulates; nothing is run.
Accuracy predicted(const SimulatedRun& run, const LinearLaw<double>& law, double step) {
  Accuracy failed;
  failed.amplitude_error = infinite;
  const auto effect = method_effect(run.method, run.settings, law, step, false);
  if (!effect || !effect->effective.angular_frequency) return failed;
  Accuracy found =
      errors_of(law, run.until, *effect->effective.angular_frequency, *effect->effective.decay_rate);
  if (law.drive_amplitude > 0 && law.drive_frequency > 0 && law.decay_rate > 0) {
    if (!effect->effective.steady_state) return failed;
    const double exact =
        frequency_response(run.oscillator, run.drive.amplitude, run.drive.frequency).amplitude;
    found.amplitude_error =
        std::max(found.amplitude_error, std::abs(effect->effective.steady_state->amplitude / exact - 1));
  }
  return found;
}

/// One run of the options by this method with this step; empty if it did not reach its end.
std::optional<SimulatedRun> simulated(SimulateOptions options, const SimulatedRun& run,
                                      const std::string& method, double step, const Watch& watch) {
  options.accuracy.reset();
  options.compensated = false;
  options.sensor = {};
  options.every = 1;
  options.method = {method};
  if (!options.drive_frequency.empty()) options.drive_frequency = {run.drive.frequency};
  options.step = step;
  options.until = run.until;
  if (method == "dormand-prince") options.tolerance = reference_tolerance;
  auto result = simulate(options, without_progress(watch));
  if (!result || !result->ok()) return std::nullopt;
  return std::move(result->runs.front());
}

/// The predicted errors, but those of the free swing measured on a run.
Accuracy verified(const SimulateOptions& options, const SimulatedRun& run, const LinearLaw<double>& law,
                  double step, const Watch& watch) {
  Accuracy found = predicted(run, law, step);
  SimulateOptions free = options;
  SimulatedRun released = run;
  free.drive.clear();
  free.drive_amplitude = 0;
  free.drive_frequency.clear();
  free.drive_phase = 0;
  free.unbalance_mass.reset();
  free.eccentricity.reset();
  free.base_displacement.reset();
  released.drive = {};
  if (law.drive_amplitude > 0) {
    free.position = 1;
    free.velocity = 0;
  }
  const auto motion = simulated(free, released, run.method, step, watch);
  if (!motion) return found;
  const auto measured = measure_recurrence(motion->trajectory.x, step, damped_frequency(law));
  if (!measured) return found;
  const Accuracy seen = errors_of(law, run.until, measured->angular_frequency, measured->decay_rate);
  found.frequency_error = seen.frequency_error;
  found.decay_error = seen.decay_error;
  found.amplitude_error = std::max(found.amplitude_error, seen.amplitude_error);
  return found;
}

/// A trial run against the fine reference, at the trial's own rows.
Accuracy compared(const SimulateOptions& options, const SimulatedRun& run, double step, const Watch& watch) {
  Accuracy failed;
  failed.amplitude_error = infinite;
  const auto trial = simulated(options, run, run.method, step, watch);
  const auto truth = simulated(options, run, "dormand-prince", step, watch);
  if (!trial || !truth || trial->trajectory.size() != truth->trajectory.size()) return failed;
  Accuracy found;
  const bool driven = run.general || run.drive.amplitude > 0;
  const auto swing = driven ? std::nullopt : measure_oscillator(trial->trajectory);
  const auto reference = driven ? std::nullopt : measure_oscillator(truth->trajectory);
  if (reference) {
    if (!swing || swing->half_cycles != reference->half_cycles) return failed;
    found.frequency_error = std::abs(swing->angular_frequency / reference->angular_frequency - 1);
    const bool damped = law_of(run.oscillator).shares(dissipative_terms);
    if (damped) found.decay_error = std::abs(swing->decay_rate / reference->decay_rate - 1);
    found.amplitude_error = std::abs(swing->last_amplitude / reference->last_amplitude - 1);
    return found;
  }
  double off = 0, size = 0;
  for (std::size_t i = 0; i < trial->trajectory.size(); ++i) {
    off = std::max(off, std::abs(trial->trajectory.x[i] - truth->trajectory.x[i]));
    size = std::max(size, std::abs(truth->trajectory.x[i]));
  }
  found.amplitude_error = size > 0 ? off / size : 0;
  return found;
}

Error none(double asked, double step, double until) {
  return Error{"accuracy_out_of_reach",
               {{"accuracy", asked}, {"step", step}, {"steps", most_steps_of_a_run}, {"until", until}}};
}

/// The largest step below `longest` (within 1 %) whose errors keep to `asked`, and those of all shorter
/// steps. If `thorough`, eight shorter steps in a row are tried, else one.
Result<double> largest_step(const Attempt& trial, double asked, double longest, double until, bool thorough,
                            const Watch& watch) {
  const auto good = [&](double h) { return trial(whole_step(h, until)).worst() <= asked; };
  const double ratio = thorough ? 0.8 : 0.5;
  const int in_a_row = thorough ? 8 : 1;
  double low = 0, high = longest;
  int kept = 0;
  for (double h = longest; kept < in_a_row; h *= ratio) {
    if (watch.interrupted()) return Error{"interrupted"};
    // Shorter steps only confirm that all below are good: they are predicted, not run.
    if (until / (kept > 0 ? low : h) > most_steps_of_a_run) return none(asked, h, until);
    if (good(h)) {
      if (kept++ == 0) low = h;
    } else {
      kept = 0;
      high = h;
    }
  }
  while (high > 1.002 * low && !watch.interrupted()) {
    const double middle = std::sqrt(low * high);
    (good(middle) ? low : high) = middle;
  }
  return whole_step(low, until);
}

/// The largest step, to 1 %, that keeps all errors of the run within the accuracy asked for; empty for
/// `exact`, which has none. For a linear law under a harmonic drive it is solved from the oscillator that the
/// method really simulates, then measured on a free run. For other laws and drives it is found by halving,
/// each trial measured against a fine reference. An Error says why there is none. `options` are those of this
/// one run; their step is ignored.
Result<std::optional<Accuracy>> find_step(const SimulateOptions& options, const SimulatedRun& run,
                                          const Watch& watch) {
  if (run.method == "exact") return std::optional<Accuracy>{};
  const double asked = *options.accuracy;
  if (find_method(run.method)->is_adaptive())
    return Error{"accuracy_of_adaptive_method", {{"method", run.method}}};
  const auto law = oscillating_law(run);
  // run.step is the default here: 1/200 of the shorter period.
  const Attempt trial = law ? Attempt([&](double h) { return predicted(run, *law, h); })
                            : Attempt([&](double h) { return compared(options, run, h, watch); });
  auto step =
      largest_step(trial, asked, std::min(60 * run.step, run.until), run.until, law.has_value(), watch);
  if (!step) return step.error();
  Accuracy found = law ? verified(options, run, *law, *step, watch) : trial(*step);
  // The error of the run may lie slightly above the prediction.
  for (int tries = 0; found.worst() > asked && tries < 20; ++tries) {
    *step = whole_step(*step * 0.99, run.until);
    found = law ? verified(options, run, *law, *step, watch) : trial(*step);
  }
  if (found.worst() > asked) return none(asked, *step, run.until);
  found.asked = asked;
  found.step = *step;
  return std::optional<Accuracy>(found);
}

}  // namespace

double Accuracy::worst() const {
  return std::max({frequency_error.value_or(0), decay_error.value_or(0), amplitude_error});
}

Result<void> choose_steps(const SimulateOptions& options, std::vector<SimulatedRun>& runs,
                          const Watch& watch) {
  for (SimulatedRun& run : runs) {
    auto found = find_step(options, run, watch);
    if (!found) return found.error();
    run.accuracy = *found;
    if (!run.accuracy) continue;
    run.step = run.accuracy->step;
    SimulateOptions asked = options;
    asked.accuracy.reset();
    asked.step = run.step;
    asked.method = {run.method};
    if (auto good = set_up_runs(asked); !good) return good.error();
  }
  return {};
}

}  // namespace cromer::core
