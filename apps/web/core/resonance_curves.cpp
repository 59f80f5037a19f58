#include "resonance_curves.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cromer/analysis/steady_state.h"
#include "cromer/base/pi.h"
#include "cromer/methods/dormand_prince.h"
#include "cromer/tasks/simulate/run_effect.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core::page {
namespace {

/// By the closed form of the effective oscillator, which `run` has.
MethodResonance closed_form_curve(SimulatedRun run, const Grid& frequencies) {
  MethodResonance curve{.method = run.method};
  if (const auto now = effect_of(run); now && now->effective.steady_state)
    curve.at_drive = now->effective.steady_state->amplitude;
  for (std::uint64_t i = 0; i < frequencies.size(); ++i) {
    run.drive.frequency = frequencies[i];
    const auto effect = effect_of(run);
    // Whether free motions die away does not depend on the drive: no other frequency will do.
    if (!effect || !effect->effective.steady_state) return {.method = run.method, .settled = false};
    curve.frequency.push_back(frequencies[i]);
    curve.amplitude.push_back(effect->effective.steady_state->amplitude);
    curve.phase.push_back(effect->effective.steady_state->phase_lag);
  }
  return curve;
}

constexpr double first_cycles = 32, most_cycles = 512;
constexpr int window = 10;          // [cycles] that are measured
constexpr double states_kept = 24;  // per cycle
constexpr double most_steps = 1e7;
constexpr double agreement = 1e-3;  // between the amplitudes of two windows

using Settled = std::optional<MeasuredSteadyState>;

double period(double frequency) { return two_pi / frequency; }

/// The least number of steps that a curve takes.
double steps_of(double step, const Grid& frequencies) {
  double time = 0;
  for (std::uint64_t i = 0; i < frequencies.size(); ++i) time += 2 * first_cycles * period(frequencies[i]);
  return time / step;
}

/// Runs for `cycles` and measures the last of them; `options` then start where the run ended. Empty if the
/// run ends early or a cycle has too few states.
Result<Settled> go_on(SimulateOptions& options, double cycles) {
  const double w = options.drive_frequency.front();
  const double row = *options.step * static_cast<double>(options.every);
  options.until = std::ceil(cycles * period(w) / row) * row;
  const auto simulated = simulate(options);
  if (!simulated) return simulated.error();
  const SimulatedRun& run = simulated->runs.front();
  if (!run.done()) return Settled{};
  const auto measured = measure_steady_state(run.trajectory, run.drive, window);
  if (!measured) return Settled{};
  options.position = run.outcome.y.x;
  options.velocity = run.outcome.y.v;
  options.drive_phase = std::remainder(run.drive.phase + w * run.outcome.t, two_pi);
  return Settled{*measured};
}

/// The settled motion; empty if it does not settle.
Result<Settled> settle(SimulateOptions options) {
  double amplitude = -1, cycles = first_cycles;
  for (double passed = 0; passed < most_cycles; passed += cycles) {
    cycles = std::max(cycles, passed);
    const auto steady = go_on(options, cycles);
    if (!steady || !*steady) return steady;
    const double now = (*steady)->amplitude;
    if ((*steady)->settled() && std::abs(now - amplitude) <= agreement * now) return steady;
    amplitude = now;
  }
  return Settled{};
}

/// By stepping from rest at each frequency, with the method and the step of `run`; dormand-prince with a
/// tolerance of 1e-6 if the options give none. A point has settled when two windows of ten cycles of the
/// drive agree in amplitude to a thousandth; it is left out if it has not after 512 cycles. A curve that
/// would take more than ten million steps is not begun.
Result<MethodResonance> settled_curve(const SimulateOptions& options, const SimulatedRun& run,
                                      const Grid& frequencies) {
  MethodResonance curve{.method = run.method};
  const bool chooses_its_steps = run.method == DormandPrince::info.name;
  if (!chooses_its_steps && steps_of(run.step, frequencies) > most_steps)
    return MethodResonance{.method = run.method, .settled = false, .too_many_steps = true};
  SimulateOptions at_rest = options;
  at_rest.method = {run.method};
  at_rest.position = at_rest.velocity = 0;
  if (chooses_its_steps && !options.tolerance) at_rest.tolerance = 1e-6;
  const auto settled_at = [&](double w) {
    at_rest.drive_frequency = {w};
    at_rest.step = chooses_its_steps ? period(w) / states_kept : run.step;
    at_rest.every = std::max(1LL, static_cast<long long>(period(w) / (states_kept * *at_rest.step)));
    return settle(at_rest);
  };
  for (std::uint64_t i = 0; i < frequencies.size(); ++i) {
    const double w = frequencies[i];
    const auto steady = settled_at(w);
    if (!steady) return steady.error();
    if (!*steady) continue;
    curve.frequency.push_back(w);
    curve.amplitude.push_back((*steady)->amplitude);
    curve.phase.push_back((*steady)->phase_lag);
  }
  curve.settled = curve.frequency.size() > 1;
  const double drive = run.drive.frequency;
  if (chooses_its_steps || 2 * first_cycles * period(drive) / run.step <= most_steps)
    if (const auto now = settled_at(drive); now && *now) curve.at_drive = (*now)->amplitude;
  return curve;
}

}  // namespace

Result<std::vector<MethodResonance>> resonance_curves(const SimulateOptions& options,
                                                      const Grid& frequencies) {
  SimulateOptions one_step = options;
  one_step.until = options.step;
  const auto runs = set_up_runs(one_step);
  if (!runs) return runs.error();
  if (!(runs->front().drive.amplitude > 0)) return Error{"nothing_drives_it"};
  std::vector<MethodResonance> curves;
  for (const SimulatedRun& run : *runs) {
    if (effect_of(run)) {
      curves.push_back(closed_form_curve(run, frequencies));
      continue;
    }
    const auto curve = settled_curve(options, run, frequencies);
    if (!curve) return curve.error();
    curves.push_back(*curve);
  }
  return curves;
}

}  // namespace cromer::core::page
