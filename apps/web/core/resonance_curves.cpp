#include "resonance_curves.h"

#include "cromer/tasks/simulate/run_effect.h"
#include "cromer/tasks/simulate/simulate_setup.h"
#include "settled_curve.h"

namespace cromer::core::page {
namespace {

/// `run` has an effect of its own.
MethodResonance closed_form_curve(SimulatedRun run, const Grid& frequencies) {
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
