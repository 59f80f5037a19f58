#include "cromer/tasks/simulate/simulate_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/analysis/energy.h"
#include "cromer/base/bytes.h"
#include "cromer/base/pi.h"
#include "cromer/methods/all.h"
#include "cromer/model/law_force.h"
#include "cromer/model/terms.h"
#include "cromer/model/terms/coefficient_unit.h"
#include "cromer/run/step_control.h"
#include "cromer/run/steps.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/drive_setup.h"
#include "cromer/tasks/simulate/event_option.h"
#include "cromer/tasks/simulate/run_effect.h"
#include "cromer/tasks/simulate/run_law.h"

namespace cromer::core {
namespace {

bool is_adaptive(std::string_view name) { return find_method(name)->error_order > 0; }

Result<void> check_ranges(SimulateOptions options) {
  for (const auto& option : options_of(options))
    if (auto good = check(option); !good) return good;
  return {};
}

/// At most one of the options that set the same thing.
Result<void> check_alternatives(const SimulateOptions& o) {
  if (o.stiffness && o.natural_frequency)
    return Error{"--stiffness and --natural-frequency both set the spring; give one of them"};
  if (o.static_friction && *o.static_friction < o.law.friction)
    return Error{fmt::format("--static-friction: it must be at least --friction ({} N), not {} N",
                             shortest(o.law.friction), shortest(*o.static_friction))};
  if (o.damping.has_value() + o.damping_ratio.has_value() + o.quality_factor.has_value() > 1)
    return Error{"--damping, --damping-ratio and --quality-factor all set the damping; give one of them"};
  if (o.step && o.accuracy) return Error{"--step and --accuracy both set the step; give one of them"};
  return {};
}

/// Energies are part of the answer, so they must be numbers too.
Result<void> check_start(const SimulatedRun& run) {
  if (std::isfinite(energy(run.oscillator, run.start))) return {};
  return Error{
      fmt::format("--position: the energy at the start (x = {} m, v = {} m/s) is beyond the largest number",
                  shortest(run.start.x), shortest(run.start.v))};
}

/// Where a body that x = 0 pushes away comes to rest [m]: the first such place on either side, looked for
/// over twenty decades; 0 where there is none.
double bottom_of_well(const Oscillator<double>& oscillator) {
  constexpr double nearest = 1e-10, farthest = 1e10;
  for (const double side : {1.0, -1.0}) {
    const auto pulls_back = [&](double x) { return restoring_force(oscillator, side * x) * side >= 0; };
    double from = nearest;
    while (from < farthest && !pulls_back(2 * from)) from *= 2;
    if (!(from < farthest) || pulls_back(from)) continue;
    double to = 2 * from;
    for (double middle = (from + to) / 2; from < middle && middle < to; middle = (from + to) / 2)
      (pulls_back(middle) ? to : from) = middle;
    return side * to;
  }
  return 0;
}

/// Fills step and until of one run.
Result<void> set_times(const SimulateOptions& o, SimulatedRun& run) {
  const double natural = natural_period(run.oscillator);
  const double drive = drive_period(run);
  if (o.drive_record) {
    // A whole number of steps from sample to sample.
    const double spacing = o.drive_record->spacing;
    run.step = o.step.value_or(
        natural > 0 ? spacing / std::ceil(default_steps_per_period * spacing / natural * (1 - 1e-9))
                    : spacing);
    run.until = o.until.value_or(drive_end(run));
    return {};
  }
  if (!(default_step(natural, drive) > 0) && !(o.step && o.until)) return no_period(run.oscillator, o);
  run.step = o.step.value_or(default_step(natural, drive));
  run.until = o.until.value_or(std::max(default_end(natural, drive), drive_end(run)));
  return {};
}

Result<void> check_exact(const SimulatedRun& run) {
  const Oscillator<double>& law = run.oscillator;
  const std::string_view option = why_not_exact(law);
  if (run.method != "exact" || option.empty()) return {};
  if (option == Friction::coefficients[0].option) {
    if (run.drive.amplitude == 0 && !run.general) return {};
    return Error{fmt::format(
        "--method exact: with friction ({} N) there is no closed form under a drive; leave one of them "
        "out or choose another method, for instance dormand-prince",
        shortest(law.friction))};
  }
  std::string value;
  for_each_term([&]<class T>() {
    if (T::coefficients[0].option == option)
      value =
          fmt::format("{} {}", shortest(law.*T::template members<double>[0]), unit_of(T::coefficients[0]));
  });
  return Error{fmt::format(
      "--method exact: there is no closed form with {} ({}); leave it out or choose another method, "
      "for instance rk4 with a short step",
      option, value)};
}

/// What the states that carry an inner state along are not made for.
Result<void> check_hysteresis(const SimulateOptions& o, const SimulatedRun& run) {
  const Law law = law_of(run.oscillator);
  if (!law.has<Hysteresis>()) return {};
  if (!each_set_of_terms)
    return Error{"--hysteresis-stiffness: the page does not run a force with memory; take cromer simulate"};
  const auto refuse = [](std::string_view other) {
    return Error{
        fmt::format("--hysteresis-stiffness and --{} are not for one run; leave one of them out", other)};
  };
  if (law.has<Friction>()) return refuse(o.law.friction != 0 ? "friction" : "static-friction");
  if (o.compensated) return refuse("compensated");
  if (!o.event.empty()) return refuse("event");
  return {};
}

/// Compensated sums are for states that grow by increments, in steps that nothing cuts short.
Result<void> check_compensated(const SimulateOptions& o, const SimulatedRun& run) {
  if (!o.compensated) return {};
  if (!takes_compensated_sums(*find_method(run.method)))
    return Error{fmt::format(
        "--compensated: {} {}; leave it out or choose another method, for instance "
        "euler-cromer",
        run.method,
        is_adaptive(run.method) ? "chooses its own steps, whose errors are larger than those of the sums"
                                : "adds nothing up, it takes each state from the closed form")};
  if (law_of(run.oscillator).has<Friction>())
    return Error{
        fmt::format("--compensated: with --friction ({} N) steps end where the mass stops; leave one of them "
                    "out",
                    shortest(std::max(run.oscillator.friction, run.oscillator.static_friction)))};
  if (run.general)
    return Error{
        fmt::format("--compensated: under {} steps end where the drive jumps or bends; leave one of them out",
                    drive_name(o))};
  if (!o.event.empty())
    return Error{
        fmt::format("--compensated: --event \"{}\" is looked for in ordinary sums; leave one of them out",
                    o.event.front())};
  return {};
}

Result<void> check_memory(const SimulateOptions& o, const std::vector<SimulatedRun>& runs) {
  constexpr double most_steps = 9007199254740992.0;  // 2^53: beyond, t0 + n h cannot tell its steps apart
  double states = 0;
  for (const auto& run : runs) {
    const double count = run.until / run.step;
    if (!(count < most_steps))
      return Error{fmt::format(
          "--step: {} s up to {} s are {:.3g} steps, too many to be told apart; take a longer step",
          shortest(run.step), shortest(run.until), count)};
    states += static_cast<double>(number_of_kept_states(count_steps({0, run.until}, run.step), o.every));
  }
  const double bytes = states * (o.sensor.used ? 4 : 3) * sizeof(double);
  const double memory = o.memory > 0 ? o.memory : 1e18;  // no machine has more, and vectors cannot be longer
  if (bytes <= memory) return {};
  return Error{fmt::format(
      "--step: keeping {:.3g} states needs {} of memory, and there are {}; take a longer --step, a "
      "shorter --until, or keep every Nth state with --every N",
      states, bytes_in_words(bytes), bytes_in_words(memory))};
}

/// Methods that choose their steps, or solve an equation in every step or where the force depends on the
/// velocity.
bool uses_tolerance(std::string_view name) {
  return is_adaptive(name) || visit_method(name, {}, [](const auto& method) {
           return requires { method.newton; };
         });
}

Result<std::vector<Event>> events_of(const SimulateOptions& o) {
  std::vector<Event> events;
  for (const auto& text : o.event) {
    auto event = parse_event(text);
    if (!event) return event.error();
    events.push_back(*event);
  }
  return events;
}

std::string label_of(const SimulateOptions& o, const SimulatedRun& run) {
  if (o.drive_frequency.size() < 2) return run.method;
  return fmt::format("{}, {:.6g} rad/s", run.method, run.drive.frequency);
}

}  // namespace

Result<Oscillator<double>> oscillator_of(const SimulateOptions& o) {
  const double m = o.mass;
  const double k =
      o.natural_frequency ? m * *o.natural_frequency * *o.natural_frequency : o.stiffness.value_or(1);
  double c = o.damping.value_or(0);
  if (o.damping_ratio || o.quality_factor) {
    if (!(k > 0))
      return Error{fmt::format("--{}: it needs a positive stiffness, not {} N/m; give --damping instead",
                               o.damping_ratio ? "damping-ratio" : "quality-factor", shortest(k))};
    c = o.damping_ratio ? 2 * *o.damping_ratio * std::sqrt(k * m) : std::sqrt(k * m) / *o.quality_factor;
  }
  if (!std::isfinite(k) || !std::isfinite(c))
    return Error{
        "--natural-frequency: with this mass the stiffness or the damping is beyond the largest number"};
  Oscillator<double> oscillator = o.law;
  oscillator.mass = m;
  oscillator.stiffness = k;
  oscillator.damping = c;
  oscillator.static_friction = o.static_friction.value_or(0);
  if (c < 0 && !law_of(oscillator).shares(bounding_terms))
    return Error{fmt::format("--damping: it must {}, not {} kg/s",
                             constraint(Range::not_negative_unless_bounded), shortest(c))};
  return oscillator;
}

MethodSettings settings_of(const SimulateOptions& o, std::string_view method) {
  MethodSettings settings;
  settings.newton.tolerance =
      o.tolerance.value_or(is_adaptive(method) ? StepControl::default_tolerance : NewtonOptions{}.tolerance);
  settings.beta = o.beta.value_or(settings.beta);
  settings.gamma = o.gamma.value_or(settings.gamma);
  settings.rho_inf = o.rho_inf.value_or(settings.rho_inf);
  return settings;
}

State<double> start_of(const SimulateOptions& o) {
  const bool moves = o.position || o.velocity || drive_name(o) != "none";
  return {o.position.value_or(moves ? 0 : 1), o.velocity.value_or(0)};
}

double default_step(double natural, double drive) {
  const double shorter = natural > 0 && drive > 0 ? std::min(natural, drive) : std::max(natural, drive);
  return shorter / default_steps_per_period;
}

double default_end(double natural, double drive) { return default_periods * (natural > 0 ? natural : drive); }

double natural_period(const Oscillator<double>& oscillator) {
  const double k = stiffness_at(oscillator, 0);
  if (k == 0) return 0;
  const double there = k > 0 ? k : stiffness_at(oscillator, bottom_of_well(oscillator));
  return there > 0 ? two_pi * std::sqrt(oscillator.mass / there) : 0;
}

Error no_period(const Oscillator<double>& oscillator, const SimulateOptions& o) {
  std::string terms;
  for_each_term([&]<class T>() {
    const double value = oscillator.*T::template members<double>[0];
    if (std::is_same_v<T, Spring> || (terms_of_position.has<T>() && value != 0))
      terms += fmt::format("{}{} {} {}", terms.empty() ? "" : ", ", T::coefficients[0].option,
                           shortest(value), unit_of(T::coefficients[0]));
  });
  return Error{fmt::format("this law has no natural period ({}) and no periodic drive: give {}", terms,
                           o.step    ? "--until"
                           : o.until ? "--step"
                                     : "--step and --until")};
}

Result<std::vector<SimulatedRun>> set_up_runs(const SimulateOptions& options) {
  if (auto good = check_ranges(options); !good) return good.error();
  if (auto good = check_alternatives(options); !good) return good.error();
  if (auto good = check_drive(options); !good) return good.error();
  auto oscillator = oscillator_of(options);
  if (!oscillator) return oscillator.error();
  const auto events = events_of(options);
  if (!events) return events.error();

  std::vector<std::string> methods = options.method;
  if (methods.empty()) methods.emplace_back("euler-cromer");
  std::vector<double> frequencies = options.drive_frequency;
  if (frequencies.empty()) frequencies.push_back(0);

  std::vector<SimulatedRun> runs;
  for (const auto& method : methods) {
    if (auto good = check_method_name(method); !good) return Error{"--method: " + good.error().message};
    for (const double frequency : frequencies) {
      SimulatedRun run;
      run.method = method;
      run.oscillator = *oscillator;
      if (auto good = set_drive(options, frequency, run); !good) return good.error();
      run.start = start_of(options);
      run.events.events = *events;
      run.settings = settings_of(options, method);
      run.tolerance = run.settings.newton.tolerance;
      run.compensated = options.compensated;
      run.label = label_of(options, run);
      if (auto good = check_start(run); !good) return good.error();
      if (auto good = set_times(options, run); !good) return good.error();
      if (auto good = end_drive(options, run); !good) return good.error();
      if (auto good = check_exact(run); !good) return good.error();
      if (auto good = check_hysteresis(options, run); !good) return good.error();
      if (auto good = check_compensated(options, run); !good) return good.error();
      runs.push_back(std::move(run));
    }
  }
  if (auto good = check_memory(options, runs); !good) return good.error();
  return runs;
}

std::vector<std::string> setup_warnings(const SimulateOptions& options,
                                        const std::vector<SimulatedRun>& runs) {
  std::vector<std::string> warnings;
  const auto add_once = [&](std::string warning) {
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
      warnings.push_back(std::move(warning));
  };
  if (options.drive_record)
    for (const auto& warning : options.drive_record->warnings) add_once(warning);
  if (!options.drive_frequency.empty() && drive_name(options) == "none")
    add_once("--drive-frequency has no effect without a --drive-amplitude");
  for_each_term([&]<class T>() {
    if (options.law.*T::template members<double>[0] != 0) return;
    for (std::size_t i = 1; i < coefficients_of<T>; ++i)
      if (options.law.*T::template members<double>[i] != 0)
        add_once(fmt::format("--{} has no effect without --{}", T::coefficients[i].option,
                             T::coefficients[0].option));
    if (HasInnerState<T> && options.law.hysteresis_exponent != 1)
      add_once(fmt::format("--hysteresis-exponent has no effect without --{}", T::coefficients[0].option));
  });
  for (const auto& run : runs) {
    if (options.tolerance && !uses_tolerance(run.method))
      add_once(fmt::format("--tolerance has no effect on {}", run.method));
    if ((options.beta || options.gamma) && run.method != Newmark::info.name)
      add_once(fmt::format("--{} has no effect on {}", options.beta ? "beta" : "gamma", run.method));
    if (options.rho_inf && run.method != GeneralizedAlpha::info.name)
      add_once(fmt::format("--rho-inf has no effect on {}", run.method));
    if (auto warning = step_warning(run); !warning.empty()) add_once(std::move(warning));
    if (const double begin = drive_begin(run); begin >= run.until)
      add_once(fmt::format("--drive-start: the drive begins at {} s, and the run ends at {} s",
                           shortest(begin), shortest(run.until)));
    const Steps steps = count_steps({0, run.until}, run.step);
    // Where one of them is ours, so is the remainder.
    if (steps.last > 0 && options.step && options.until)
      add_once(fmt::format("{} s are not a whole number of steps of {} s: the last step is {:.6g} s",
                           shortest(run.until), shortest(run.step), steps.last));
  }
  return warnings;
}

}  // namespace cromer::core
