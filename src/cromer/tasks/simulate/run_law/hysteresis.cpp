// A force with memory: states that carry its inner state along, by the same methods. One type of force
// serves all drives: hysteresis itself costs more.
#include "cromer/model/hysteretic_oscillator.h"

#include <cassert>
#include <limits>
#include <utility>
#include <variant>

#include "cromer/base/coupled.h"
#include "cromer/tasks/simulate/run_law/units.h"

namespace cromer::core {
namespace {

/// Any drive as a function of time, per unit mass.
class ForceOfAnyDrive {
 public:
  using Drives =
      std::variant<HarmonicForce<double>, PulseForce<double>, ChirpForce<double>, SampledForce<double>>;

  explicit ForceOfAnyDrive(Drives force) : force_(std::move(force)) {}

  double operator()(double t) const {
    return std::visit([&](const auto& force) { return double(force(t)); }, force_);
  }
  double next_break(double t) const {
    return std::visit(
        [&](const auto& force) {
          if constexpr (requires { force.next_break(t); }) return double(force.next_break(t));
          return std::numeric_limits<double>::infinity();
        },
        force_);
  }
  ForceOfAnyDrive within(double t) const {
    return ForceOfAnyDrive(std::visit(
        [&](const auto& force) {
          if constexpr (requires { force.within(t); }) return Drives(force.within(t));
          return Drives(force);
        },
        force_));
  }
  bool is_smooth_in_steps(double step) const {
    return std::visit(
        [&](const auto& force) {
          if constexpr (requires { force.is_smooth_in_steps(step); }) return force.is_smooth_in_steps(step);
          return false;
        },
        force_);
  }

 private:
  Drives force_;
};

ForceOfAnyDrive force_of(const LawRun& run) {
  const double m = run.oscillator.mass;
  if (!run.general) return ForceOfAnyDrive(cromer::core::force_of(run.drive, m));
  return std::visit([&](const auto& drive) { return ForceOfAnyDrive(cromer::core::force_of(drive, m)); },
                    *run.general);
}

/// Hands position and velocity on.
struct WithoutInnerState {
  KeepEvery& keep;

  void operator()(double t, const State<Coupled<double>>& y) const { keep(t, {y.x.first, y.v.first}); }
  void pause() const { keep.pause(); }
};

}  // namespace

Outcome run_hysteresis(const LawRun& run, KeepEvery& keep, const Watch& watch) {
  assert((!run.events || run.events->events.empty()) && "events are for doubles");
  const HystereticOscillator system(divided_by_mass(run.oscillator), force_of(run));
  const State<Coupled<double>> start{{run.start.x, 0}, {run.start.v, 0}};
  return visit_method(run.method, run.settings, [&](const auto& method) {
    return solve(system, method, run.interval, start, run.control, WithoutInnerState{keep}, watch);
  });
}

}  // namespace cromer::core
