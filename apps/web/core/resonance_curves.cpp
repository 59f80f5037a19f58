#include "resonance_curves.h"

#include "cromer/study/task/run_effect.h"
#include "cromer/study/task/simulate_setup.h"

namespace cromer::page {
namespace {

MethodResonance curve_of(SimulatedRun run, const Grid& frequencies) {
  MethodResonance curve{.method = run.method};
  for (std::uint64_t i = 0; i < frequencies.size(); ++i) {
    run.drive.frequency = frequencies[i];
    const auto effect = effect_of(run);
    // Whether a motion dies away does not depend on what drives it.
    if (!effect || !effect->effective.steady_state) return {.method = run.method, .settled = false};
    curve.frequency.push_back(frequencies[i]);
    curve.amplitude.push_back(effect->effective.steady_state->amplitude);
    curve.phase.push_back(effect->effective.steady_state->phase_lag);
  }
  return curve;
}

}  // namespace

Result<std::vector<MethodResonance>> resonance_curves(const SimulateOptions& options,
                                                      const Grid& frequencies) {
  const auto runs = set_up_runs(options);
  if (!runs) return runs.error();
  const SimulatedRun& first = runs->front();
  if (first.oscillator.cubic != 0 || first.oscillator.drag != 0 || first.oscillator.friction != 0)
    return Error{"a resonance curve in closed form needs a linear law: no drag, friction or cubic stiffness"};
  if (!(first.drive.amplitude > 0)) return Error{"--drive-amplitude: nothing drives it"};
  std::vector<MethodResonance> curves;
  for (const SimulatedRun& run : *runs) curves.push_back(curve_of(run, frequencies));
  return curves;
}

}  // namespace cromer::page
