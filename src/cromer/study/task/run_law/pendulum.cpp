#include "cromer/model/pendulum.h"
#include "cromer/study/task/run_law/units.h"
#include "cromer/study/task/run_pendulum.h"

namespace cromer {

Outcome run_pendulum(const LawRun& run, KeepEvery& keep, const Watch& watch) {
  // One system for all smooth terms: a term that is absent costs less here than a unit of its own would.
  constexpr Terms terms{.damping = true, .cubic = true, .drag = true};
  const Oscillator<double> per_mass = divided_by_mass(run.oscillator);
  Oscillator<double> rest = per_mass;
  rest.stiffness = 0;
  const Pendulum smooth(DrivenOscillator<double, terms>(rest, {}), per_mass.stiffness);
  const auto by = by_method(run, keep, watch);
  if (per_mass.friction == 0 && per_mass.static_friction == 0) return by(smooth);
  return by(DryFriction(smooth, per_mass.friction, per_mass.static_friction));
}

}  // namespace cromer
