#include "cromer/tasks/network_run/network_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/methods/all.h"
#include "cromer/methods/vector_newton.h"
#include "cromer/model/linear_network.h"
#include "cromer/model/network_system.h"
#include "cromer/run/solve.h"
#include "cromer/tasks/methods/unused_by_method.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/network_run/network_stick_slip.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/early_end.h"
#include "cromer/tasks/simulate/simulate_setup.h"

namespace cromer::core {
namespace {

constexpr std::array network_options{"method", "step", "until", "tolerance",
                                     "every",  "beta", "gamma", "rho-inf"};

/// An upper bound of the highest natural frequency [rad/s], by Gershgorin's circles.
double frequency_bound(const Network& network) {
  std::vector<double> sums(network.masses.size());
  for (const NetworkLink& link : network.links) {
    const double stiffness = std::abs(slopes_at_rest(link.law).x);
    const bool between = link.from != ground && link.to != ground;
    for (const std::size_t end : {link.from, link.to})
      if (end != ground) sums[end] += (between ? 2 : 1) * stiffness / network.masses[end].mass;
  }
  return std::sqrt(*std::max_element(sums.begin(), sums.end()));
}

/// The longest and the shortest natural period [s] of small motions; 0 where there is none.
struct Periods {
  double longest = 0, shortest = 0;
};

Periods periods_of(const Network& network) {
  Periods periods;
  const UndampedModes modes = undamped_modes(linearised(network));
  for (const double square : modes.squares) {
    if (!(square > 1e-13 * modes.squares.back())) continue;
    const double period = two_pi / std::sqrt(square);
    if (periods.longest == 0) periods.longest = period;
    periods.shortest = period;
  }
  return periods;
}

Result<void> check_exact_network(const Network& network, const std::string& file) {
  const Law law = law_of(network).without(linear_terms);
  for (std::size_t i = 0; i < term_count; ++i)
    if (law.has(i)) return Error{"exact_of_linear_networks", {{"file", file}, {"term", term_infos[i].name}}};
  if (network.masses.size() > most_masses_for_modes)
    return Error{"too_many_masses_for_exact",
                 {{"masses", network.masses.size()}, {"most", most_masses_for_modes}}};
  return {};
}

bool stands_still(const Network& network) {
  for (const NetworkMass& mass : network.masses)
    if (mass.start.x != 0 || mass.start.v != 0 || mass.drive.amplitude != 0) return false;
  return true;
}

/// Fills in method, step and end, and tells how many states will be kept at most.
Result<std::size_t> set_up(NetworkRun& run, SimulateOptions options) {
  for (const Option& option : options_of(options))
    if (is_option_of_networks(option.name))
      if (auto good = check(option); !good) return good.error();
  if (options.method.size() > 1) return Error{"one_method_of_networks", {{"methods", options.method.size()}}};
  run.method = options.method.empty() ? "euler-cromer" : options.method.front();
  if (auto good = check_method_name(run.method); !good)
    return Error{"method_is_wrong", {{"what", good.error().notice}}};
  if (stands_still(run.network)) return Error{"network_stands_still", {{"file", run.file}}};
  if (run.method == "exact")
    if (auto good = check_exact_network(run.network, run.file); !good) return good.error();

  if (!options.step || !options.until) {
    if (run.network.masses.size() > most_masses_for_modes)
      return Error{"large_network_needs_step",
                   {{"masses", run.network.masses.size()}, {"most", most_masses_for_modes}}};
    Periods periods = periods_of(run.network);
    for (const NetworkMass& mass : run.network.masses)
      if (mass.drive.amplitude != 0 && mass.drive.frequency > 0) {
        const double period = two_pi / mass.drive.frequency;
        periods.shortest = periods.shortest > 0 ? std::min(periods.shortest, period) : period;
        if (periods.longest == 0) periods.longest = period;
      }
    if (periods.longest == 0) return Error{"network_without_period", {{"file", run.file}}};
    run.step = periods.shortest / default_steps_per_period;
    run.until = default_periods * periods.longest;
  }
  run.step = options.step.value_or(run.step);
  run.until = options.until.value_or(run.until);
  const MethodInfo& info = *find_method(run.method);
  run.tolerance = options.tolerance.value_or(info.is_adaptive() ? StepControl::default_tolerance
                                                                : NewtonOptions{}.tolerance);
  double numbers = 2 * static_cast<double>(run.network.masses.size()) + 2;
  for (const NetworkLink& link : run.network.links) numbers += law_of(link.law).has<Hysteresis>() ? 1 : 0;
  const auto states = kept_states(run.until, run.step, options.every);
  if (!states) return states.error();
  if (auto good = check_memory(static_cast<double>(*states), numbers, options.memory); !good)
    return good.error();
  return static_cast<std::size_t>(*states);
}

/// What a link stores [J]; `x_of` gives each mass' position, `present` are the terms of its law.
template <class Of>
double stored_energy(const NetworkLink& link, Law present, const Of& x_of) {
  const State<double> y{stretch(link.from, link.to, x_of), 0};
  return is_linear(present) ? energy<linear_terms>(0.0, link.law, present, y)
                            : energy<any_terms>(0.0, link.law, present, y);
}

/// Keeps every n-th state of a run, and the last. States come one by one and are kept in a column for each
/// mass, so they are gathered: to write one number at the end of each of many columns takes longer than the
/// step.
class NetworkRecorder {
 public:
  NetworkRecorder(const Network& network, long long every, std::size_t most, NetworkStates& kept)
      : network_(network), masses_(network.masses.size()), every_(every), kept_(kept) {
    for (auto* of : {&kept_.x, &kept_.v}) {
      of->resize(masses_);
      for (std::vector<double>& column : *of) column.reserve(most);
    }
    gathered_.resize(rows * 2 * masses_);
    for (std::size_t l = 0; l < network.links.size(); ++l) {
      present_.push_back(law_of(network.links[l].law));
      if (present_.back().has<Hysteresis>()) kept_.inner.push_back({.link = l});
    }
  }

  void operator()(double t, const State<MassVector>& y) {
    last_ = y;
    if (--until_next_ > 0) return;
    until_next_ = every_;
    kept_.t.push_back(t);
    double* row = &gathered_[row_ * 2 * masses_];
    for (std::size_t i = 0; i < masses_; ++i) {
      row[i] = y.x.first[i];
      row[masses_ + i] = y.v.first[i];
    }
    if (++row_ == rows) write();
    for (std::size_t l = 0; l < kept_.inner.size(); ++l) {
      const NetworkLink& link = network_.links[kept_.inner[l].link];
      // The inner state is the force over this mass: see InnerLink.
      const double mass = network_.masses[link.to != ground ? link.to : link.from].mass;
      kept_.inner[l].force.push_back(mass * y.v.second[l]);
    }
    kept_.energy.push_back(energy_of(y));
  }

  /// To be called at the end.
  State<MassVector> finish() {
    write();
    return std::move(last_);
  }

 private:
  static constexpr std::size_t rows = 32;

  void write() {
    const auto append = [&](std::vector<double>& column, std::size_t place) {
      for (std::size_t r = 0; r < row_; ++r) column.push_back(gathered_[r * 2 * masses_ + place]);
    };
    for (std::size_t i = 0; i < masses_; ++i) append(kept_.x[i], i);
    for (std::size_t i = 0; i < masses_; ++i) append(kept_.v[i], masses_ + i);
    row_ = 0;
  }

  /// Kinetic energy, and what the links store [J].
  double energy_of(const State<MassVector>& y) const {
    double sum = 0;
    for (std::size_t i = 0; i < masses_; ++i)
      sum += network_.masses[i].mass * (y.v.first[i] * y.v.first[i]) / 2;
    for (std::size_t l = 0; l < network_.links.size(); ++l)
      sum += stored_energy(network_.links[l], present_[l], [&](std::size_t i) { return y.x.first[i]; });
    return sum;
  }

  const Network& network_;
  std::size_t masses_;
  long long every_, until_next_ = 1;
  NetworkStates& kept_;
  std::vector<Law> present_;      // in each link
  std::vector<double> gathered_;  // rows of x, then v, of each mass
  std::size_t row_ = 0;
  State<MassVector> last_;
};

/// The run itself.
template <class M, class Recorder>
Outcome solved(const M& method, const NetworkRun& run, Recorder& record, const Watch& watch) {
  const Interval interval{0, run.until};
  const State<MassVector> start = start_of(run.network);
  const StepControl control(run.step, M::info.is_adaptive() ? run.tolerance : StepControl::default_tolerance);
  if constexpr (M::info.is_exact()) {
    const LinearNetwork linear = linearised(run.network);
    const UndampedModes modes = undamped_modes(linear);
    if (const std::vector<double> damping = modal_damping(linear, modes); !damping.empty())
      return solve(NetworkByModes(run.network, modes, damping), method, interval, start, control, record,
                   watch);
    return solve(NetworkByExponential(run.network), method, interval, start, control, record, watch);
  } else {
    if (law_of(run.network).has<Friction>())
      return solve_with_contacts(run.network, method, interval, start, control, record, watch);
    return solve(NetworkSystem<>(run.network), method, interval, start, control, record, watch);
  }
}

/// By the ledgers of single oscillators: a mass without springs under its drive, a link without mass.
NetworkEnergy energy_over(const Network& network, const NetworkStates& kept, double spacing) {
  NetworkEnergy sum;
  const auto follow = [&](const auto& force, const Oscillator<double>& law, const auto& state) {
    EnergyLedger ledger(force, law, spacing);
    for (std::size_t n = 0; n < kept.t.size(); ++n) ledger(kept.t[n], state(n));
    return ledger.balance();
  };
  const auto add = [&](const EnergyBalance& balance) {
    sum.start += balance.start;
    sum.end += balance.end;
    sum.taken += balance.taken.sum();
  };
  // Without a drive or a resistance there is no work.
  const std::size_t last = kept.t.size() - 1;
  const auto stores = [&](const Oscillator<double>& law, const auto& state) {
    return energy_balance(law, state(0), state(last), Power{});
  };
  for (std::size_t i = 0; i < network.masses.size(); ++i) {
    const auto& [amplitude, frequency, phase] = network.masses[i].drive;
    const Oscillator<double> law{.mass = network.masses[i].mass, .stiffness = 0};
    const auto state = [&](std::size_t n) { return State<double>{kept.x[i][n], kept.v[i][n]}; };
    const EnergyBalance balance = amplitude != 0
                                      ? follow(HarmonicForce<double>{amplitude, frequency, phase}, law, state)
                                      : stores(law, state);
    add(balance);
    sum.drive += balance.drive;
  }
  for (const NetworkLink& link : network.links) {
    Oscillator<double> law = link.law;
    law.mass = 0;
    const auto state = [&](std::size_t n) {
      return State<double>{stretch(link.from, link.to, [&](std::size_t i) { return kept.x[i][n]; }),
                           stretch(link.from, link.to, [&](std::size_t i) { return kept.v[i][n]; })};
    };
    LinkEnergy& of_link = sum.of_links.emplace_back();
    const EnergyBalance balance =
        law_of(law).shares(resistances) ? follow([](double) { return 0.0; }, law, state) : stores(law, state);
    of_link.end = balance.end;
    of_link.taken = balance.taken.sum();
    add(balance);
  }
  for (const InnerForce& inner : kept.inner) {
    // As a drive that pulls against the link. How much of this work it could give back is not known.
    const NetworkLink& link = network.links[inner.link];
    std::size_t n = 0;
    const double work =
        -follow([&](double) { return -inner.force[n]; }, {.mass = 0, .stiffness = 0},
                [&](std::size_t at) {
                  n = at;
                  return State<double>{
                      0, stretch(link.from, link.to, [&](std::size_t i) { return kept.v[i][at]; })};
                })
             .drive;
    sum.of_links[inner.link].taken += work;
    sum.taken += work;
  }
  return sum;
}

/// Says that a step is beyond the stability of a network of few masses.
void add_stability(NetworkRun& run, const SimulateOptions& options) {
  constexpr std::size_t few = 60;
  const MethodInfo& info = *find_method(run.method);
  if (!info.takes_fixed_steps() || run.network.masses.size() > few) return;
  const auto modes = network_modes(run.network, run.file,
                                   {.method = {run.method},
                                    .step = run.step,
                                    .beta = options.beta,
                                    .gamma = options.gamma,
                                    .rho_inf = options.rho_inf});
  if (!modes) return;
  for (const Notice& notice : modes->notices)
    if (notice.code == "method_unstable_on_network" || notice.code == "slow_modes_lost")
      run.notices.push_back(notice);
}

/// As of a single mass: the run ends at the last kept state whose energy is a number.
void cut_at_overflow(NetworkRun& run, long long every) {
  NetworkStates& kept = run.states;
  std::size_t size = 0;
  while (size < kept.t.size() && std::isfinite(kept.energy[size])) ++size;
  if (size == kept.t.size() || size == 0) return;
  kept.t.resize(size);
  kept.energy.resize(size);
  for (auto* of : {&kept.x, &kept.v})
    for (std::vector<double>& values : *of) values.resize(size);
  for (InnerForce& each : kept.inner) each.force.resize(size);
  run.outcome.status = Status::not_finite;
  run.outcome.t = kept.t.back();
  run.outcome.step = static_cast<long long>(size - 1) * every;
  for (std::size_t i = 0; i < run.last.size(); ++i) run.last[i] = {kept.x[i].back(), kept.v[i].back()};
}

}  // namespace

bool NetworkRun::takes_steps() const { return find_method(method)->takes_fixed_steps(); }

bool is_option_of_networks(std::string_view option) {
  return std::find(network_options.begin(), network_options.end(), option) != network_options.end();
}

Result<NetworkRun> run_network(const Network& network, const std::string& file,
                               const SimulateOptions& options, const Watch& watch) {
  NetworkRun run{.file = file, .network = network};
  const auto most_states = set_up(run, options);
  if (!most_states) return most_states.error();
  add_stability(run, options);
  say_unused_by_method(run.method, options, run.notices);
  if (Notice shorter = shorter_last_step(options, run.until, run.step, run.method); !shorter.empty())
    run.notices.push_back(std::move(shorter));
  NetworkRecorder record(run.network, options.every, *most_states, run.states);
  MethodSettings settings = settings_of(options, run.method);
  run.outcome = visit_method(run.method, settings,
                             [&](const auto& method) { return solved(method, run, record, watch); });
  const State<MassVector> last = record.finish();
  for (std::size_t i = 0; i < network.masses.size(); ++i)
    run.last.push_back({last.x.first[i], last.v.first[i]});
  cut_at_overflow(run, options.every);
  run.message = early_end(run.outcome);
  const double spacing = run.step * static_cast<double>(options.every);
  constexpr std::size_t few_states = 8;  // the sums over them are no integrals
  if (spacing * frequency_bound(network) < 0.5 && run.states.t.size() > few_states) {
    NetworkEnergy energy = energy_over(network, run.states, spacing);
    // The exact solution makes nothing: what the sums leave over is the links'.
    if (find_method(run.method)->is_exact()) energy.taken = energy.drive - (energy.end - energy.start);
    run.energy = std::move(energy);
  }
  return run;
}

Result<std::vector<NetworkRun>> run_network_by_each(const Network& network, const std::string& file,
                                                    const SimulateOptions& options, const Watch& watch) {
  std::vector<NetworkRun> runs;
  const std::size_t count = std::max<std::size_t>(1, options.method.size());
  for (std::size_t m = 0; m < count && (m == 0 || !watch.interrupted()); ++m) {
    SimulateOptions by_one = options;
    by_one.memory = options.memory / static_cast<double>(count);
    if (!options.method.empty()) by_one.method = {options.method[m]};
    auto run = run_network(network, file, by_one, watch);
    if (!run) return run.error();
    runs.push_back(*std::move(run));
  }
  return runs;
}

std::vector<double> stored_by(const NetworkRun& run, std::size_t link) {
  const NetworkLink& of = run.network.links[link];
  const Law present = law_of(of.law);
  std::vector<double> stored;
  for (std::size_t n = 0; n < run.states.t.size(); ++n)
    stored.push_back(stored_energy(of, present, [&](std::size_t i) { return run.states.x[i][n]; }));
  return stored;
}

}  // namespace cromer::core
