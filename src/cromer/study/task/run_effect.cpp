#include "cromer/study/task/run_effect.h"

#include <fmt/format.h>

#include "cromer/study/task/simulate.h"

namespace cromer {
namespace {

LinearLaw<double> law_of(const SimulatedRun& run) {
  const double m = run.oscillator.mass;
  return {.decay_rate = run.oscillator.damping / (2 * m),
          .stiffness = run.oscillator.stiffness / m,
          .drive_amplitude = run.drive.amplitude / m,
          .drive_frequency = run.drive.frequency,
          .drive_phase = run.drive.phase};
}

}  // namespace

std::optional<MethodEffect> effect_of(const SimulatedRun& run) {
  const Oscillator<double>& law = run.oscillator;
  if (law.drag != 0 || law.friction != 0 || law.static_friction != 0 || law.cubic != 0) return std::nullopt;
  return method_effect(run.method, run.settings, law_of(run), run.step, false);
}

std::string effect_in_words(const SimulatedRun& run) {
  if (!run.effect) return "";
  std::string words = run.label + " " + in_words(*run.effect, law_of(run));
  if (const auto& steady = run.effect->effective.steady_state)
    words += fmt::format("; will settle at {:.6g} m, {:.4g} rad behind the drive", steady->amplitude,
                         steady->phase_lag);
  return words;
}

}  // namespace cromer
