#include <algorithm>
#include <cmath>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/frequency_response.h"
#include "cromer/analysis/growth.h"
#include "cromer/analysis/steady_state.h"
#include "cromer/documents/described/simulate.h"
#include "cromer/model/law_force.h"
#include "cromer/study/collect.h"
#include "cromer/study/facts.h"
#include "cromer/tasks/simulate/run_energy.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

double largest_magnitude(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Where it is; not-finite values are passed over.
std::size_t largest(const std::vector<double>& values) {
  std::size_t at = 0;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] > values[at] || std::isnan(values[at])) at = i;
  return at;
}

/// What the energy of a free motion does.
void collect_energy(const std::string& name, const SimulatedRun& run, const std::vector<double>& energy,
                    Results& results) {
  const double period = natural_period(run.oscillator);
  if (run.drive.amplitude > 0 || run.general || !(period > 0) || !(energy.front() > 0)) return;
  const EnergyGrowth growth = energy_growth(run.oscillator, run.trajectory);
  const auto [least, most] = std::minmax_element(energy.begin(), energy.end());
  results.set(name + ".energy_start", energy.front(), "J");
  results.set(name + ".energy_end", energy.back(), "J");
  results.set(name + ".energy_ratio", energy.back() / energy.front());
  results.set(name + ".energy_factor_per_cycle", growth.factor_per_cycle(period));
  results.set(name + ".energy_doubling_time", growth.doubling_time(), "s");
  results.set(name + ".energy_swing", (*most - *least) / (*most + *least));
  results.set(name + ".energy_drift", std::expm1(growth.rate * run.outcome.t));
}

/// What a driven motion settles at, measured and exact.
void collect_steady(const std::string& name, const SimulatedRun& run, Results& results) {
  if (!(run.drive.amplitude > 0) || !(run.drive.frequency > 0)) return;
  const bool has_exact = is_linear(law_of(run.oscillator)) && run.oscillator.damping > 0;
  const SteadyState exact = frequency_response(run.oscillator, run.drive.amplitude, run.drive.frequency);
  if (has_exact) {
    results.set(name + ".exact.amplitude", exact.amplitude, "m");
    results.set(name + ".exact.phase", exact.phase_lag, "rad");
  }
  const auto measured = measure_steady_state(run.trajectory, run.drive);
  if (!measured) return;
  results.set(name + ".steady.amplitude", measured->amplitude, "m");
  results.set(name + ".steady.phase", measured->phase_lag, "rad");
  results.set(name + ".steady.change", measured->change);
  if (!has_exact) return;
  results.set(name + ".amplitude_error", measured->amplitude / exact.amplitude - 1);
  results.set(name + ".phase_error", measured->phase_lag - exact.phase_lag, "rad");
}

void collect_run(const std::string& name, const DescribedRun& all, Results& results) {
  const SimulatedRun& run = all.run;
  const Counts& counts = run.outcome.counts;
  const bool of_motion = run.transmission && run.transmission->of_motion;
  Facts(results, [of_motion](std::string_view unit) -> std::string_view {
    return unit != unit_sent ? unit : of_motion ? "m" : "N";
  }).set(name, all);
  if (counts.newton_iterations > 0)
    results.set(name + ".newton_per_step",
                static_cast<double>(counts.newton_iterations) / static_cast<double>(counts.accepted));
  else
    results.set(name + ".newton_per_step", std::string("–"));
  results.set(name + ".peak", largest_magnitude(run.trajectory.x), "m");
  results.set(name + ".peak_velocity", largest_magnitude(run.trajectory.v), "m/s");

  auto energy = energies(run);
  collect_energy(name, run, energy, results);
  collect_steady(name, run, results);
  results.set_column(name + ".t", run.trajectory.t, "s", "time *t*");
  results.set_column(name + ".x", run.trajectory.x, "m", "position *x*");
  results.set_column(name + ".v", run.trajectory.v, "m/s", "velocity *v*");
  results.set_column(name + ".energy", std::move(energy), "J", "energy *E*");
}

}  // namespace

void collect(const std::string& id, const SimulateResult& result, Results& results) {
  for (std::size_t i = 0; i < result.runs.size(); ++i)
    collect_run(id + "." + std::to_string(i + 1), DescribedRun{result.runs[i], result.options}, results);
}

void collect(const std::string& id, const ResonanceResult& resonance, Results& results) {
  const char* arrives = resonance.of_motion ? "m" : "N";
  results.set(id + ".points", static_cast<double>(resonance.curves.front().frequency.size()));
  for (std::size_t i = 0; i < resonance.curves.size(); ++i) {
    const ResonanceCurve& curve = resonance.curves[i];
    const std::string name = id + "." + std::to_string(i + 1);
    const std::size_t peak = largest(curve.amplitude), most = largest(curve.transmissibility);
    results.set(name + ".label", curve.method);
    results.set(name + ".damping_ratio", curve.damping_ratio);
    results.set(name + ".peak", curve.amplitude[peak], "m");
    results.set(name + ".peak_frequency", curve.frequency[peak], "rad/s");
    results.set(name + ".peak_transmissibility", curve.transmissibility[most]);
    results.set(name + ".peak_transmissibility_ratio", curve.frequency_ratio[most]);
    results.set(name + ".last_transmissibility", curve.transmissibility.back());
    results.set(name + ".peak_transmitted", curve.transmitted[largest(curve.transmitted)], arrives);
    results.set(name + ".last_transmitted", curve.transmitted.back(), arrives);
    results.set_column(name + ".frequency", curve.frequency, "rad/s", "drive frequency *ω*");
    results.set_column(name + ".frequency_ratio", curve.frequency_ratio, "", "frequency ratio *ω*/*ω*_{0}");
    results.set_column(name + ".amplitude", curve.amplitude, "m", "steady amplitude");
    results.set_column(name + ".phase", curve.phase, "rad", "phase lag *φ*");
    results.set_column(name + ".amplification", curve.amplification, "", "amplification");
    results.set_column(name + ".transmissibility", curve.transmissibility, "", "transmissibility");
    results.set_column(name + ".transmitted_phase", curve.transmitted_phase, "rad", "phase lag *φ*");
    results.set_column(name + ".transmitted", curve.transmitted, arrives,
                       resonance.of_motion ? "amplitude of the mass" : "force on the ground");
  }
}

void collect(const std::string& id, const LocalErrorResult& errors, Results& results) {
  for (std::size_t i = 0; i < errors.curves.size(); ++i) {
    const LocalErrorCurve& curve = errors.curves[i];
    const std::string name = id + "." + std::to_string(i + 1);
    results.set(name + ".label", curve.method);
    results.set(name + ".x_slope", curve.x_slope);
    results.set(name + ".v_slope", curve.v_slope);
    results.set(name + ".x_over_predicted", curve.x_over_predicted);
    results.set(name + ".v_over_predicted", curve.v_over_predicted);
    results.set_column(name + ".h", curve.h, "s", "step *h*");
    results.set_column(name + ".x_error", curve.x_error, "m", "error of position");
    results.set_column(name + ".v_error", curve.v_error, "m/s", "error of velocity");
  }
}

}  // namespace cromer::core
