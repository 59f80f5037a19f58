#include <algorithm>
#include <cmath>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/frequency_response.h"
#include "cromer/analysis/measured_oscillator.h"
#include "cromer/analysis/phase.h"
#include "cromer/analysis/steady_state.h"
#include "cromer/base/extent.h"
#include "cromer/documents/described/simulate.h"
#include "cromer/documents/words/words.h"
#include "cromer/model/law_force.h"
#include "cromer/study/collect.h"
#include "cromer/study/facts.h"
#include "cromer/tasks/simulate/run_effect.h"
#include "cromer/tasks/simulate/run_energy.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

double largest_magnitude(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// The energy of a free motion with one period.
void collect_energy(const std::string& name, const SimulatedRun& run, const std::vector<double>& energy,
                    Results& results) {
  const double period = natural_period(run.oscillator);
  if (run.drive.amplitude > 0 || run.general || !(period > 0) || !(energy.front() > 0)) return;
  const EnergyGrowth growth = energy_growth(run.oscillator, run.trajectory);
  const auto [least, most] = extent_of(energy);
  results.set(name + ".energy_start", energy.front(), "J");
  results.set(name + ".energy_end", energy.back(), "J");
  results.set(name + ".energy_ratio", energy.back() / energy.front());
  results.set(name + ".energy_factor_per_cycle", growth.factor_per_cycle(period));
  results.set(name + ".energy_doubling_time", growth.doubling_time(), "s");
  results.set(name + ".energy_swing", (most - least) / (most + least));
  results.set(name + ".energy_drift", std::expm1(growth.rate * run.outcome.t));
}

/// The steady state of a driven motion, measured and exact.
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

  if (const Notice effect = effect_notice(run); !effect.empty())
    results.set(name + ".effect",
                in_words(Notice{"report_method_does", {{"what", effect}}}, {results.language()}));
  const double period = natural_period(run.oscillator);
  if (period > 0)
    results.set_column(name + ".phase", followed_phase(run.trajectory.x, run.trajectory.v, two_pi / period),
                       "rad", "phase");

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

}  // namespace cromer::core
