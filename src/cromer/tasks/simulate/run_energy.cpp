#include "cromer/tasks/simulate/run_energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/energy_balance.h"
#include "cromer/analysis/exact_energy_balance.h"
#include "cromer/base/pi.h"
#include "cromer/methods/all.h"
#include "cromer/model/general_drive.h"
#include "cromer/model/law_force.h"
#include "cromer/model/linear_quantities.h"
#include "cromer/tasks/simulate/drive_setup.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

double spacing_of(const Trajectory& kept) { return kept.size() > 1 ? kept.t[1] - kept.t[0] : 0; }

bool dense_enough(const SimulatedRun& run, double period, double states) {
  return run.outcome.status == Status::reached_end && run.trajectory.size() > 1 &&
         (period == 0 || spacing_of(run.trajectory) * states <= period * (1 + 1e-9));
}

/// From the kept states first to last, both included, and the final state if last is the last one kept.
/// `force` is per unit mass.
template <class F>
EnergyBalance from_states(const SimulatedRun& run, const F& force, std::size_t first, std::size_t last) {
  const Trajectory& kept = run.trajectory;
  const auto newtons = [&](double t) { return run.oscillator.mass * force(t); };
  EnergyLedger ledger(newtons, run.oscillator, spacing_of(kept));
  for (std::size_t i = first; i <= last; ++i) ledger(kept.t[i], {kept.x[i], kept.v[i]});
  if (last + 1 == kept.size() && run.outcome.t > kept.t.back()) ledger(run.outcome.t, run.outcome.y);
  return ledger.balance();
}

/// Indices of the kept states at the breaks of the force. Empty if a break falls between two states, where
/// the quadrature would go wrong.
template <class F>
std::optional<std::vector<std::size_t>> states_at_breaks(const SimulatedRun& run, const F& force) {
  constexpr double same = 1e-6;  // of a spacing
  const double spacing = spacing_of(run.trajectory), end = run.trajectory.t.back();
  std::vector<std::size_t> found;
  for (double at = force.next_break(-spacing); at < end; at = force.next_break(at)) {
    const double index = std::round(at / spacing);
    if (std::abs(at - index * spacing) > same * spacing) return std::nullopt;
    if (index > 0) found.push_back(static_cast<std::size_t>(index));
  }
  return found;
}

/// From break to break, for a force that has few.
template <class F>
std::optional<EnergyBalance> from_stretches(const SimulatedRun& run, const F& force) {
  const auto breaks = states_at_breaks(run, force);
  if (!breaks) return std::nullopt;
  const Trajectory& kept = run.trajectory;
  EnergyBalance sum;
  std::size_t first = 0;
  for (std::size_t i = 0; i <= breaks->size(); ++i) {
    const std::size_t last = i < breaks->size() ? (*breaks)[i] : kept.size() - 1;
    if (last == first) continue;
    const auto smooth = force.within(0.5 * (kept.t[first] + kept.t[first + 1]));
    const EnergyBalance part = from_states(run, smooth, first, last);
    if (first == 0) sum.start = part.start;
    sum.end = part.end;
    sum.drive += part.drive;
    for_each_resistance([&]<class R>() { sum.taken.of<R>() += part.taken.of<R>(); });
    first = last;
  }
  return sum;
}

/// The force must know the closed form of its motion. If it has breaks, from break to break.
template <class F>
EnergyBalance from_closed_form(const SimulatedRun& run, const F& force, double panel) {
  const Oscillator<double>& o = run.oscillator;
  const LinearLaw<double> law = linear_law(o);
  const Trajectory& kept = run.trajectory;
  const auto motion = [&](double t) {
    const auto after = std::upper_bound(kept.t.begin(), kept.t.end(), t);
    const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - kept.t.begin() - 1, 0));
    return force.propagate(law, kept.t[i], t, State<double>{kept.x[i], kept.v[i]});
  };
  const auto newtons = [&](const F& smooth) { return [&](double t) { return o.mass * smooth(t); }; };
  const double end = run.outcome.t;
  Power work{};
  if constexpr (requires { force.within(0.0); }) {
    double from = 0;
    while (from < end) {
      const double until = std::min(force.next_break(from), end);
      const F smooth = force.within(0.5 * (from + until));
      work = work + exact_work(newtons(smooth), motion, from, until, panel);
      from = until;
    }
  } else {
    work = exact_work(newtons(force), motion, 0, end, panel);
  }
  return energy_balance(o, run.start, motion(end), work);
}

/// With dry friction, which `exact` takes only without a drive.
EnergyBalance from_arcs(const SimulatedRun& run) {
  return with_terms(run.oscillator, run.drive, [&](const auto& system) {
    if constexpr (requires { exact_friction_balance(system, run.oscillator, run.start, run.until); })
      return exact_friction_balance(system, run.oscillator, run.start, run.until);
    return EnergyBalance{};
  });
}

/// The modified energy is positive, and the motion bounded, for w h < 2.
bool conserves_modified_energy(const SimulatedRun& run) {
  const Oscillator<double>& o = run.oscillator;
  return run.method == EulerCromer::info.name && !run.general && terms_of(o, run.drive) == Terms{} &&
         o.stiffness > 0 && o.stiffness * run.step * run.step < 4 * o.mass;
}

/// Number of kept states without the last, if only part of a step led to it.
std::size_t states_of_whole_steps(const SimulatedRun& run) {
  const bool partly = run.outcome.last_step > 0 ||
                      (run.outcome.status == Status::stopped_by_event && !run.outcome.interrupted);
  const std::size_t size = run.trajectory.size();
  return size - (partly && size > 0 && run.trajectory.t.back() == run.outcome.t);
}

}  // namespace

std::vector<double> energies(const SimulatedRun& run) {
  std::vector<double> values(run.trajectory.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = energy(run.oscillator, State<double>{run.trajectory.x[i], run.trajectory.v[i]});
  return values;
}

std::optional<EnergyBalance> energy_balance_of(const SimulatedRun& run) {
  const double period = shorter_period(natural_period(run.oscillator), drive_period(run));
  const bool closed = run.method == "exact";
  const Law law = law_of(run.oscillator);
  const bool rubs = law.has<Friction>();
  // A hysteretic force does not follow from the states.
  if (law.has<Hysteresis>()) return std::nullopt;
  if (!dense_enough(run, period, closed ? 0 : 20)) return std::nullopt;
  if (closed && rubs) return from_arcs(run);
  const double spacing = spacing_of(run.trajectory);
  const double m = run.oscillator.mass;
  if (!run.general) {
    const HarmonicForce<double> force{run.drive.amplitude / m, run.drive.frequency, run.drive.phase};
    if (closed) return from_closed_form(run, force, period > 0 ? period / 4 : spacing);
    return from_states(run, force, 0, run.trajectory.size() - 1);
  }
  if constexpr (each_set_of_terms)  // the page drives by sines only
    return std::visit(
        [&](const auto& drive) -> std::optional<EnergyBalance> {
          const auto force = force_of(drive, m);
          if constexpr (HasClosedForm<std::remove_const_t<decltype(force)>, double>)
            if (closed)
              return from_closed_form(run, force, period > 0 ? std::min(period / 4, spacing) : spacing);
          // A recording has a break at each sample, but hardly a jump.
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(drive)>, SampledDrive>)
            return from_states(run, force, 0, run.trajectory.size() - 1);
          else
            return from_stretches(run, force);
        },
        *run.general);
  return std::nullopt;
}

std::optional<MethodEnergy> method_energy_of(const SimulatedRun& run) {
  if (!run.measured || !run.energy_balance || run.trajectory.size() < 2) return std::nullopt;
  const double made = run.energy_balance->method();
  if (run.method == "exact") return MethodEnergy{made, 0};
  // Eighths of the first half cycle, and the quarters of the last one.
  const std::vector<double>& t = run.trajectory.t;
  const double quarter = two_pi / 4 / run.measured->angular_frequency, end = run.outcome.t;
  std::array<double, 10> made_until{};
  for (std::size_t i = 0; i < made_until.size(); ++i) {
    const auto step = static_cast<double>(i + 1);
    const double until = i < 8 ? step * quarter / 4 : end - (11 - step) * quarter;
    const auto last = std::lower_bound(t.begin(), t.end(), until) - t.begin();
    const auto no_force = [](double) { return 0.0; };
    made_until[i] = from_states(run, no_force, 0, static_cast<std::size_t>(last)).method();
  }
  const double ends = made + made_until[8], between = 2 * made_until[9];
  const double mean = (ends + between) / 4, comes = std::abs(ends - between) / 4;
  // A symplectic method loses nothing: what its first cycle shows is where in it the motion began.
  if (find_method(run.method)->symplectic) {
    const double first =
        std::accumulate(made_until.begin(), made_until.begin() + 8, -0.5 * made_until[7]) / 8;
    const auto [least, most] = std::minmax_element(made_until.begin(), made_until.begin() + 8);
    const double at_first = (std::max(*most, 0.0) - std::min(*least, 0.0)) / 2;
    const double lasting = mean - first, swings = std::max({comes, at_first, std::abs(made)});
    return MethodEnergy{std::abs(lasting) < 0.05 * swings ? 0 : lasting, swings};  // not known any better
  }
  // Of a growth without end nothing comes and goes.
  return MethodEnergy{comes < 0.05 * std::abs(made) ? made : mean, comes};
}

std::optional<MeasuredOscillator> measured_oscillator_of(const SimulatedRun& run) {
  const bool driven = run.general || run.drive.amplitude > 0;
  const Oscillator<double>& o = run.oscillator;
  if (driven || is_linear(law_of(o))) return std::nullopt;
  if (!dense_enough(run, natural_period(o), 8)) return std::nullopt;
  return measure_oscillator(run.trajectory);
}

std::optional<ModifiedEnergy> modified_energy_of(const SimulatedRun& run) {
  if (!conserves_modified_energy(run)) return std::nullopt;
  const std::size_t size = states_of_whole_steps(run);
  if (size < 2) return std::nullopt;
  const auto state = [&](std::size_t i) { return State<double>{run.trajectory.x[i], run.trajectory.v[i]}; };
  const auto modified = [&](std::size_t i) { return modified_energy(run.oscillator, run.step, state(i)); };
  ModifiedEnergy found{
      .start = modified(0), .end = modified(size - 1), .states = static_cast<long long>(size)};
  if (!(found.start > 0)) return std::nullopt;
  Drift drift;
  double least = energy(run.oscillator, state(0)), most = least;
  for (std::size_t i = 0; i < size; ++i) {
    drift(modified(i));
    least = std::min(least, energy(run.oscillator, state(i)));
    most = std::max(most, energy(run.oscillator, state(i)));
  }
  found.drift = drift.largest();
  found.energy_swing = (most - least) / (most + least);
  return found;
}

Notice modified_energy_notice(const SimulatedRun& run) {
  if (!run.modified_energy) return {};
  const ModifiedEnergy& found = *run.modified_energy;
  return Notice{"conserves_modified_energy",
                {{"run", run.label},
                 {"energy", found.start},
                 {"drift", found.drift},
                 {"states", found.states},
                 {"sums", run.compensated ? Notice{"of_compensated_sums"} : Notice{}},
                 {"swing", 100 * found.energy_swing}}};
}

}  // namespace cromer::core
