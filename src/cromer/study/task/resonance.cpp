#include "cromer/study/task/resonance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cromer/analysis/frequency_response.h"
#include "cromer/analysis/steady_state.h"
#include "cromer/model/terms.h"
#include "cromer/study/task/simulate_setup.h"

namespace cromer {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double transient_left = 1e-6;
constexpr int measured_cycles = 4;

Result<void> check(const ResonanceOptions& options, const Oscillator<double>& law) {
  if (!(options.frequency_from > 0)) return Error{"--frequency-from: it must be positive"};
  if (!(options.frequency_to > options.frequency_from))
    return Error{"--frequency-to: it must be above --frequency-from"};
  if (options.points < 2) return Error{"--points: at least 2"};
  if (!options.simulate.drive.empty() && options.simulate.drive != "harmonic")
    return Error{"--drive: a resonance curve is that of a harmonic force"};
  if (!options.simulate.drive_file.empty() || !options.simulate.base_motion.empty())
    return Error{"--drive-file, --base-motion: a resonance curve is that of a harmonic force"};
  if (!(options.simulate.drive_amplitude > 0))
    return Error{"--drive-amplitude: a resonance curve needs a force"};
  if (const std::string_view term = why_not_exact(law); !term.empty())
    return Error{fmt::format("--{}: this resonance curve is of the linear law", term)};
  if (!(law.damping > 0))
    return Error{"--damping: without damping no transient dies down, and there is no steady amplitude"};
  if (!(law.stiffness > 0)) return Error{"--stiffness: without a spring there is no resonance"};
  return {};
}

/// The slowest decay rate of the free motion [1/s].
double slowest_decay(const Oscillator<double>& law) {
  const double b = law.damping / (2 * law.mass), w2 = law.stiffness / law.mass;
  return b * b <= w2 ? b : w2 / (b + std::sqrt(b * b - w2));
}

/// Options of the one run at w: from the exact steady motion, so that only the method's own difference has to
/// die down.
SimulateOptions run_at(const ResonanceOptions& options, const Oscillator<double>& law,
                       const std::string& method, double w) {
  SimulateOptions run = options.simulate;
  const SteadyState exact = frequency_response(law, run.drive_amplitude, w);
  const double start = run.drive_phase - exact.phase_lag;
  run.method = {method};
  run.drive_frequency = {w};
  run.position = exact.amplitude * std::cos(start);
  run.velocity = -exact.amplitude * w * std::sin(start);
  run.until = std::log(1 / transient_left) / slowest_decay(law) + (measured_cycles + 1) * two_pi / w;
  return run;
}

Result<SteadyState> settle(const ResonanceOptions& options, const Oscillator<double>& law,
                           const std::string& method, double w, const Watch& watch) {
  if (method == "exact") return frequency_response(law, options.simulate.drive_amplitude, w);
  auto simulated = simulate(run_at(options, law, method, w), Watch{watch.interrupt, {}});
  if (!simulated) return simulated.error();
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const SimulatedRun& run = simulated->runs.front();
  if (run.outcome.status != Status::reached_end) return SteadyState{nothing, nothing};
  const auto measured = measure_steady_state(run.trajectory, run.drive, measured_cycles);
  if (!measured) return measured.error();
  if (!measured->settled()) return SteadyState{nothing, nothing};
  return SteadyState{measured->amplitude, measured->phase_lag};
}

}  // namespace

Result<ResonanceResult> resonance(const ResonanceOptions& options, const Watch& watch) {
  // A run at the first frequency has every other option checked and every default filled in.
  SimulateOptions first = options.simulate;
  first.drive_frequency = {options.frequency_from};
  const auto runs = set_up_runs(first);
  if (!runs) return runs.error();
  const Oscillator<double> law = runs->front().oscillator;
  if (const auto good = check(options, law); !good) return good.error();

  ResonanceResult result;
  std::vector<std::string> methods;
  for (const SimulatedRun& run : *runs) methods.push_back(run.method);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    ResonanceCurve curve{.method = methods[m], .frequency = {}, .amplitude = {}, .phase = {}};
    for (long long i = 0; i < options.points; ++i) {
      if (watch.interrupted()) return Error{"interrupted"};
      const double share = static_cast<double>(i) / static_cast<double>(options.points - 1);
      const double w = options.frequency_from + share * (options.frequency_to - options.frequency_from);
      const auto steady = settle(options, law, methods[m], w, watch);
      if (!steady) return steady.error();
      curve.frequency.push_back(w);
      curve.amplitude.push_back(steady->amplitude);
      curve.phase.push_back(steady->phase_lag);
      if (watch.progress)
        watch.progress((static_cast<double>(m) + share) / static_cast<double>(methods.size()));
    }
    const auto unsettled =
        std::count_if(curve.amplitude.begin(), curve.amplitude.end(), [](double a) { return std::isnan(a); });
    if (unsettled > 0)
      result.warnings.push_back(
          fmt::format("{} did not settle at {} of {} frequencies: its own damping is negative or its steps "
                      "are too long there",
                      methods[m], unsettled, options.points));
    result.curves.push_back(std::move(curve));
  }
  return result;
}

}  // namespace cromer
