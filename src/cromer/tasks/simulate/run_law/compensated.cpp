// States in compensated sums, by the same methods. Few sets of terms and one type of force serve all laws:
// what a long run costs is its increments, not its drive.
#include "cromer/base/compensated.h"

#include <cassert>

#include "cromer/base/function_ref.h"
#include "cromer/tasks/simulate/run_law/units.h"

namespace cromer::core {
namespace {

using AnyForce = FunctionRef<double(double t)>;

/// Hands rounded states on.
struct Rounded {
  KeepEvery& keep;

  void operator()(double t, const State<Compensated>& y) const { keep(t, {y.x.value, y.v.value}); }
  void pause() const { keep.pause(); }
};

template <Terms terms>
Outcome run_terms(const LawRun& run, AnyForce force, KeepEvery& keep, const Watch& watch) {
  const DrivenOscillator<double, terms, AnyForce> system(divided_by_mass(run.oscillator), force);
  const State<Compensated> start{run.start.x, run.start.v};
  return visit_method(run.method, run.settings, [&]<class M>(const M& method) {
    Outcome outcome;
    if constexpr (M::info.takes_fixed_steps())
      outcome = solve(system, method, run.interval, start, run.control, Rounded{keep}, watch);
    else
      assert(false && "the method does not add up increments");
    return outcome;
  });
}

template <bool driven>
Outcome run_under(const LawRun& run, AnyForce force, KeepEvery& keep, const Watch& watch) {
  const Law present = law_of(run.oscillator);
  if (present == law_of("spring")) return run_terms<Terms{.drive = driven}>(run, force, keep, watch);
  if (is_linear(present))
    return run_terms<Terms{.drive = driven, .law = linear_terms}>(run, force, keep, watch);
  return run_terms<Terms{.drive = driven, .law = any_terms}>(run, force, keep, watch);
}

}  // namespace

Outcome run_compensated(const LawRun& run, KeepEvery& keep, const Watch& watch) {
  assert(!run.general && "no sums under drives that jump");
  const HarmonicForce<double> force = force_of(run.drive, run.oscillator.mass);
  return run.drive.amplitude != 0 ? run_under<true>(run, force, keep, watch)
                                  : run_under<false>(run, force, keep, watch);
}

}  // namespace cromer::core
