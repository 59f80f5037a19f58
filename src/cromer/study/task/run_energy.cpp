#include "cromer/study/task/run_energy.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <variant>

#include "cromer/analysis/energy_ledger.h"
#include "cromer/analysis/exact_energy_balance.h"
#include "cromer/analysis/exact_friction_balance.h"
#include "cromer/model/general_drive.h"
#include "cromer/model/terms.h"
#include "cromer/study/task/drive_setup.h"
#include "cromer/study/task/simulate_setup.h"

namespace cromer {
namespace {

double spacing_of(const Trajectory& kept) { return kept.size() > 1 ? kept.t[1] - kept.t[0] : 0; }

/// The shorter of natural and drive period [s]; 0 where there is none.
double shortest_period(const SimulatedRun& run) {
  const double natural = natural_period(run.oscillator), drive = drive_period(run);
  return natural > 0 && drive > 0 ? std::min(natural, drive) : std::max(natural, drive);
}

bool dense_enough(const SimulatedRun& run, double period, double states) {
  return run.outcome.status == Status::reached_end && run.trajectory.size() > 1 &&
         (period == 0 || spacing_of(run.trajectory) * states <= period * (1 + 1e-9));
}

template <class F>
EnergyBalance from_states(const SimulatedRun& run, const F& force) {
  const Trajectory& kept = run.trajectory;
  EnergyLedger ledger(force, run.oscillator, spacing_of(kept));
  for (std::size_t i = 0; i < kept.size(); ++i) ledger(kept.t[i], {kept.x[i], kept.v[i]});
  if (run.outcome.t > kept.t.back()) ledger(run.outcome.t, run.outcome.y);
  return ledger.balance();
}

/// The force must know the closed form of its own motion.
template <class F>
EnergyBalance from_closed_form(const SimulatedRun& run, const F& force, double panel) {
  const Oscillator<double>& o = run.oscillator;
  const LinearLaw<double> law{.decay_rate = o.damping / (2 * o.mass), .stiffness = o.stiffness / o.mass};
  const Trajectory& kept = run.trajectory;
  const auto per_mass = [&](double t) { return o.mass * force(t); };
  const auto motion = [&](double t) {
    const auto after = std::upper_bound(kept.t.begin(), kept.t.end(), t);
    const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - kept.t.begin() - 1, 0));
    return force.propagate(law, kept.t[i], t, State<double>{kept.x[i], kept.v[i]});
  };
  return exact_energy_balance(per_mass, o, motion, run.outcome.t, panel);
}

/// With dry friction, which `exact` takes without a drive only.
EnergyBalance from_arcs(const SimulatedRun& run) {
  return with_terms(run.oscillator, run.drive, [&](const auto& system) {
    if constexpr (requires { exact_friction_balance(system, run.oscillator, run.start, run.until); })
      return exact_friction_balance(system, run.oscillator, run.start, run.until);
    return EnergyBalance{};
  });
}

}  // namespace

std::optional<EnergyBalance> energy_balance_of(const SimulatedRun& run) {
  const double period = shortest_period(run);
  const bool closed = run.method == "exact";
  const bool rubs = run.oscillator.friction > 0 || run.oscillator.static_friction > 0;
  if (!dense_enough(run, period, closed ? 0 : 20)) return std::nullopt;
  if (closed && rubs) return from_arcs(run);
  const double spacing = spacing_of(run.trajectory);
  const double m = run.oscillator.mass;
  if (!run.general) {
    const HarmonicForce<double> force{run.drive.amplitude / m, run.drive.frequency, run.drive.phase};
    if (closed) return from_closed_form(run, force, period > 0 ? period / 4 : spacing);
    return from_states(run, [&](double t) { return m * force(t); });
  }
  return std::visit(
      [&](const auto& drive) {
        const auto force = force_of(drive, m);
        if constexpr (HasClosedForm<std::remove_const_t<decltype(force)>, double>)
          if (closed)
            return from_closed_form(run, force, period > 0 ? std::min(period / 4, spacing) : spacing);
        return from_states(run, [&](double t) { return m * force(t); });
      },
      *run.general);
}

std::optional<MeasuredOscillator> measured_oscillator_of(const SimulatedRun& run) {
  const bool driven = run.general || run.drive.amplitude > 0;
  const Oscillator<double>& o = run.oscillator;
  if (driven || (o.cubic == 0 && o.drag == 0 && o.friction == 0)) return std::nullopt;
  if (!dense_enough(run, natural_period(o), 8)) return std::nullopt;
  return measure_oscillator(run.trajectory);
}

}  // namespace cromer
