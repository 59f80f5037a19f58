#include "cromer/tasks/simulate/run_law.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "cromer/analysis/swing.h"
#include "cromer/model/law_force.h"
#include "cromer/tasks/simulate/run_law/units.h"

namespace cromer::core {

Outcome run_law(const LawRun& run, KeepEvery& keep, const Watch& watch) {
  if (run.compensated) return run_compensated(run, keep, watch);
  if (law_of(run.oscillator).has<Hysteresis>()) return run_hysteresis(run, keep, watch);
  if (run.general)
    return std::visit([&](const auto& drive) { return run_driven(run, drive, keep, watch); }, *run.general);
  const Terms present = terms_of(run.oscillator, run.drive);
  if (present.law.has<Friction>()) return run_friction(run, keep, watch);
  return present.drive ? run_harmonic(run, keep, watch) : run_free(run, keep, watch);
}

long long steps_within_swing(const Oscillator<double>& law, const State<double>& start, double amplitude,
                             double times, double step, long long most) {
  KeepEvery keep(1, Steps{most});
  run_law({.oscillator = law,
           .method = "forward-euler",
           .interval = {0, static_cast<double>(most) * step},
           .start = start,
           .control = step},
          keep);
  const Trajectory run = keep.take();
  const Swing<double> swing{law};
  const double growth = std::max(0.0, -law.damping / (2 * law.mass));
  const auto is_within = [&](std::size_t i) {
    const double share = std::abs(run.x[i]) / (amplitude * std::exp(growth * run.t[i]));
    return share <= 1 || (share <= times && swing.pull(run.x[i]) * run.x[i] > 0);
  };
  std::size_t within = 0;
  while (within < run.size() && is_within(within)) ++within;
  return std::clamp<long long>(static_cast<long long>(within) - 1, 1, most);
}

}  // namespace cromer::core
