#include "cromer/tasks/simulate/simulate_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/analysis/energy.h"
#include "cromer/base/add_once.h"
#include "cromer/base/pi.h"
#include "cromer/base/quantity.h"
#include "cromer/methods/all.h"
#include "cromer/model/law_force.h"
#include "cromer/model/terms/term.h"
#include "cromer/run/course.h"
#include "cromer/run/step_control.h"
#include "cromer/tasks/methods/unused_by_method.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/drive_setup.h"
#include "cromer/tasks/simulate/run_effect.h"
#include "cromer/tasks/simulate/run_law.h"

namespace cromer::core {
namespace {

Result<void> check_ranges(SimulateOptions options) {
  for (const auto& option : options_of(options))
    if (auto good = check(option); !good) return good;
  return {};
}

/// At most one of the options that set the same thing.
Result<void> check_alternatives(const SimulateOptions& o) {
  if (o.stiffness && o.natural_frequency) return Error{"spring_set_twice"};
  if (o.static_friction && *o.static_friction < o.law.friction)
    return Error{"static_friction_too_small",
                 {{"friction", o.law.friction}, {"static_friction", *o.static_friction}}};
  if (o.damping.has_value() + o.damping_ratio.has_value() + o.quality_factor.has_value() > 1)
    return Error{"damping_set_twice"};
  if (o.step && o.accuracy) return Error{"step_set_twice"};
  return {};
}

/// Energies are results too, so they must be finite.
Result<void> check_start(const SimulatedRun& run) {
  if (std::isfinite(energy(run.oscillator, run.start))) return {};
  const bool by_place = !std::isfinite(energy(run.oscillator, {run.start.x, 0}));
  return Error{"start_energy_too_large",
               {{"option", by_place ? "position" : "velocity"}, {"x", run.start.x}, {"v", run.start.v}}};
}

/// Where a body that is pushed away from x = 0 comes to rest [m]: the first such place on either side,
/// searched over twenty decades; 0 if there is none.
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
    return Error{"exact_with_friction", {{"friction", law.friction}}};
  }
  double value = 0;
  std::string unit;
  for_each_term([&]<class T>() {
    if (T::coefficients[0].option != option) return;
    value = law.*T::template members<double>[0];
    unit = unit_of(T::coefficients[0]);
  });
  return Error{"exact_with_term", {{"term", option}, {"value", value}, {"unit", unit}}};
}

/// Refuses what states with an inner state are not made for.
Result<void> check_hysteresis(const SimulateOptions& o, const SimulatedRun& run) {
  const Law law = law_of(run.oscillator);
  if (!law.has<Hysteresis>()) return {};
  if (!each_set_of_terms) return Error{"hysteresis_on_page"};
  const auto refuse = [](std::string_view other) {
    return Error{"hysteresis_with_other", {{"option", other}}};
  };
  if (!runs_together(law)) return refuse(o.law.friction != 0 ? "friction" : "static-friction");
  if (o.compensated) return refuse("compensated");
  if (!o.event.empty()) return refuse("event");
  return {};
}

/// Compensated sums are for states that grow by increments, in steps that nothing cuts short.
Result<void> check_compensated(const SimulateOptions& o, const SimulatedRun& run) {
  if (!o.compensated) return {};
  const MethodInfo& method = *find_method(run.method);
  if (!method.takes_fixed_steps())
    return Error{method.is_adaptive() ? "compensated_of_adaptive_method" : "compensated_of_exact_method",
                 {{"method", run.method}}};
  if (law_of(run.oscillator).has<Friction>())
    return Error{"compensated_with_friction",
                 {{"friction", std::max(run.oscillator.friction, run.oscillator.static_friction)}}};
  if (run.general) return Error{"compensated_under_drive", {{"drive", drive_name(o)}}};
  if (!o.event.empty()) return Error{"compensated_with_event", {{"event", o.event.front()}}};
  return {};
}

Result<void> check_memory_of_all(const SimulateOptions& o, const std::vector<SimulatedRun>& runs) {
  double states = 0;
  for (const auto& run : runs) {
    const auto kept = kept_states(run.until, run.step, o.every);
    if (!kept) return kept.error();
    states += static_cast<double>(*kept);
  }
  return check_memory(states, o.sensor.used ? 4 : 3, o.memory);
}

Error wrong(std::string_view text, const Notice& why) {
  return Error{"event_is_wrong", {{"event", text}, {"what", why}}};
}

/// Cuts off the text's part up to the next separator.
std::string_view take(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
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

Result<long long> kept_states(double until, double step, long long every) {
  constexpr double most_steps = 9007199254740992.0;  // 2^53: beyond, t0 + n h cannot tell its steps apart
  if (!(until / step < most_steps))
    return Error{"run_of_too_many_steps", {{"step", step}, {"until", until}, {"steps", until / step}}};
  return number_of_kept_states(count_steps({0, until}, step), every);
}

Result<void> check_memory(double states, double numbers, double memory) {
  const double bytes = states * numbers * sizeof(double);
  if (!(memory > 0)) memory = 1e18;  // no machine has more, and vectors cannot be longer
  if (bytes <= memory) return {};
  return Error{"states_beyond_memory",
               {{"states", states}, {"needed", bytes_in_words(bytes)}, {"memory", bytes_in_words(memory)}}};
}

Result<Oscillator<double>> oscillator_of(const SimulateOptions& o) {
  const double m = o.mass;
  const double k =
      o.natural_frequency ? m * *o.natural_frequency * *o.natural_frequency : o.stiffness.value_or(1);
  double c = o.damping.value_or(0);
  if (o.damping_ratio || o.quality_factor) {
    if (!(k > 0))
      return Error{o.damping_ratio ? "damping_ratio_without_spring" : "quality_factor_without_spring",
                   {{"stiffness", k}}};
    c = o.damping_ratio ? 2 * *o.damping_ratio * std::sqrt(k * m) : std::sqrt(k * m) / *o.quality_factor;
  }
  if (!std::isfinite(k) || !std::isfinite(c)) return Error{"law_too_large"};
  Oscillator<double> oscillator = o.law;
  oscillator.mass = m;
  oscillator.stiffness = k;
  oscillator.damping = c;
  oscillator.static_friction = o.static_friction.value_or(0);
  return oscillator;
}

MethodSettings settings_of(const SimulateOptions& o, std::string_view method) {
  MethodSettings settings;
  settings.newton.tolerance = o.tolerance.value_or(
      find_method(method)->is_adaptive() ? StepControl::default_tolerance : NewtonOptions{}.tolerance);
  settings.beta = o.beta.value_or(settings.beta);
  settings.gamma = o.gamma.value_or(settings.gamma);
  settings.rho_inf = o.rho_inf.value_or(settings.rho_inf);
  return settings;
}

State<double> start_of(const SimulateOptions& o) {
  const bool moves = o.position || o.velocity || drive_name(o) != "none";
  return {o.position.value_or(moves ? 0 : 1), o.velocity.value_or(0)};
}

double shorter_period(double one, double other) {
  return one > 0 && other > 0 ? std::min(one, other) : std::max(one, other);
}

double default_step(double natural, double drive) {
  return shorter_period(natural, drive) / default_steps_per_period;
}

double default_end(double natural, double drive) { return default_periods * (natural > 0 ? natural : drive); }

double natural_period(const Oscillator<double>& oscillator) {
  const double k = stiffness_at(oscillator, 0);
  if (k == 0) return 0;
  const double there = k > 0 ? k : stiffness_at(oscillator, bottom_of_well(oscillator));
  return there > 0 ? two_pi * std::sqrt(oscillator.mass / there) : 0;
}

Error no_period(const Oscillator<double>& oscillator, const SimulateOptions& o) {
  std::vector<Notice> terms;
  for_each_term([&]<class T>() {
    const double value = oscillator.*T::template members<double>[0];
    if (std::is_same_v<T, Spring> || (terms_of_position.has<T>() && value != 0))
      terms.push_back(Notice{
          "coefficient_in_unit",
          {{"name", T::coefficients[0].option}, {"value", value}, {"unit", unit_of(T::coefficients[0])}}});
  });
  return Error{o.step    ? "no_period_for_until"
               : o.until ? "no_period_for_step"
                         : "no_period_for_step_and_until",
               {{"terms", terms}}};
}

Result<Event> parse_event(std::string_view text) {
  Event event;
  std::string_view words = text;
  std::string_view threshold = take(words, ':');
  const bool has_value = threshold.find('=') != std::string_view::npos;
  const std::string_view quantity = take(threshold, '=');
  if (quantity == "position")
    event.quantity = Event::Quantity::position;
  else if (quantity != "velocity" && quantity != "turning-point")
    return wrong(text, Notice{"no_such_event", {{"event", quantity}}});
  if (has_value == (quantity == "turning-point"))
    return wrong(text, Notice{has_value ? "turning_point_has_no_value" : "event_value_missing"});
  if (has_value) {
    const auto value = parse_quantity(threshold, event.quantity == Event::Quantity::position ? "m" : "m/s");
    if (!value) return wrong(text, value.error().notice);
    event.value = value->value;
  }
  while (!words.empty()) {
    const std::string_view word = take(words, ':');
    const bool rising = word == "rising", falling = word == "falling";
    if (word == "stop")
      event.stop = true;
    else if ((rising || falling) && event.crossing == Crossing::any)
      event.crossing = rising ? Crossing::rising : Crossing::falling;
    else
      return wrong(text, rising || falling ? Notice{"rising_and_falling"}
                                           : Notice{"event_word_unknown", {{"word", word}}});
  }
  return event;
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
    if (auto good = check_method_name(method); !good)
      return Error{"method_is_wrong", {{"what", good.error().notice}}};
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
  if (auto good = check_memory_of_all(options, runs); !good) return good.error();
  return runs;
}

/// The shorter period of swing and harmonic drive [s]; 0 where neither swings.
double period_of_swing(const SimulatedRun& run) {
  const double natural = natural_period(run.oscillator);
  const bool swings = decay_rate(run.oscillator) * natural < two_pi;
  return shorter_period(swings ? natural : 0, run.general ? 0 : drive_period(run.drive));
}

Notice shorter_last_step(const SimulateOptions& options, double until, double step, std::string_view method) {
  if (!options.step || !options.until || find_method(method)->is_adaptive()) return {};
  const Steps steps = count_steps({0, until}, step);
  if (!(steps.last > 0)) return {};
  return Notice{"last_step_is_shorter", {{"until", until}, {"step", step}, {"last", steps.last}}};
}

std::vector<Notice> setup_notices(const SimulateOptions& options, const std::vector<SimulatedRun>& runs) {
  std::vector<Notice> notices;
  if (options.drive_record)
    for (const Notice& notice : options.drive_record->notices) add_once(notices, notice);
  if (!options.drive_frequency.empty() && drive_name(options) == "none")
    add_once(notices, Notice{"drive_frequency_alone"});
  for_each_term([&]<class T>() {
    if (options.law.*T::template members<double>[0] != 0) return;
    const std::string_view needed = T::coefficients[0].option;
    for (std::size_t i = 1; i < coefficients_of<T>; ++i)
      if (options.law.*T::template members<double>[i] != 0)
        add_once(notices,
                 Notice{"no_effect_without", {{"option", T::coefficients[i].option}, {"needed", needed}}});
    if (HasInnerState<T> && options.law.hysteresis_exponent != 1)
      add_once(notices, Notice{"no_effect_without", {{"option", "hysteresis-exponent"}, {"needed", needed}}});
  });
  for (const auto& run : runs) {
    say_unused_by_method(run.method, options, notices);
    if (auto notice = step_notice(run); !notice.empty()) add_once(notices, std::move(notice));
    if (const double begin = drive_begin(run); begin >= run.until)
      add_once(notices, Notice{"drive_begins_after_end", {{"start", begin}, {"until", run.until}}});
    if (Notice shorter = shorter_last_step(options, run.until, run.step, run.method); !shorter.empty())
      add_once(notices, std::move(shorter));
    const double kept = run.step * static_cast<double>(options.every), period = period_of_swing(run);
    if (period > 0 && kept > period / 2 && run.until > 3 * kept)
      add_once(notices, Notice{"states_too_far_apart", {{"kept", kept}, {"period", period}}});
  }
  return notices;
}

}  // namespace cromer::core
