#include <algorithm>

#include "cromer/model/terms/all.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/sweep/sweep.h"
#include "cromer/tasks/sweep/sweep_rows.h"

namespace cromer::core {
namespace {

/// Options of simulate that a sweep takes: with a grid, as the terms' coefficients do too, or as they are.
constexpr std::string_view with_grid[] = {"mass",
                                          "static-friction",
                                          "natural-frequency",
                                          "damping-ratio",
                                          "quality-factor",
                                          "loss-factor",
                                          "position",
                                          "velocity",
                                          "drive-amplitude",
                                          "drive-frequency",
                                          "drive-phase",
                                          "unbalance-mass",
                                          "eccentricity",
                                          "base-displacement",
                                          "step",
                                          "until",
                                          "tolerance",
                                          "beta",
                                          "gamma",
                                          "rho-inf"};
constexpr std::string_view as_it_is[] = {"drive", "method"};

template <std::size_t n>
bool is_in(const std::string_view (&names)[n], std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// Options of simulate that would not change a sweep's rows, or make no sense in one.
Notice left_out(std::string_view option) {
  constexpr std::string_view of_drives_that_end[] = {"drive-to", "drive-start", "drive-duration"};
  constexpr std::string_view of_records[] = {"drive-file", "base-motion", "drive-column", "between-samples"};
  constexpr std::string_view of_sensors[] = {"sensor-noise", "sensor-resolution", "sensor-offset", "seed"};
  if (is_in(of_drives_that_end, option)) return Notice{"sweep_takes_no_pulse", {{"option", option}}};
  if (is_in(of_records, option)) return Notice{"sweep_takes_no_record", {{"option", option}}};
  if (is_in(of_sensors, option)) return Notice{"sweep_has_no_sensor", {{"option", option}}};
  if (option == "accuracy") return Notice{"sweep_takes_the_step"};
  if (option == "event") return Notice{"sweep_has_no_event"};
  if (option == "every") return Notice{"sweep_keeps_no_states"};
  if (option == "compensated") return Notice{"sweep_runs_are_short"};
  return {};
}

/// Whether the option is a coefficient of a term with an inner state, or of one without.
template <bool with_inner_state>
bool is_coefficient(std::string_view name) {
  bool found = with_inner_state && name == "hysteresis-exponent";
  for_each_term([&]<class T>() {
    if constexpr (HasInnerState<T> == with_inner_state)
      for (const CoefficientInfo& each : T::coefficients) found = found || each.option == name;
  });
  return found;
}

/// What those options mean in a sweep, where that is less than in a run.
void say_of_sweeps(std::vector<Option>& options) {
  struct Said {
    std::string_view name, help, default_text;
  };
  constexpr Said all[] = {
      {"method", "a name from `cromer methods`", ""},
      {"drive", "harmonic, unbalance (rotating, m_u e w^2) or base (shaking)", ""},
      {"drive-amplitude", "amplitude F of the driving force", ""},
      {"drive-frequency", "its angular frequency w", ""},
      {"drive-phase", "its phase phi at t = 0", ""},
      {"step", "time step", "1/200 of the shorter of natural and drive period"},
      {"until", "end of each run", "20 natural periods, of the drive where the law has none"},
  };
  for (Option& option : options)
    for (const Said& said : all)
      if (option.name == said.name) {
        option.help = said.help;
        if (!said.default_text.empty()) option.default_text = said.default_text;
      }
}

}  // namespace

std::vector<Option> point_options(SimulateOptions& o) {
  auto options = options_of(o);
  const auto before = std::find_if(options.begin(), options.end(),
                                   [](const Option& each) { return each.name == "quality-factor"; });
  options.insert(before + 1,
                 {"loss-factor", &o.loss_factor, "1", Range::not_negative,
                  "hysteretic damping, a spring k (1 + i eta), instead of a damper; for settled motions only",
                  "", before->group});
  return options;
}

Notice sweep_refusal(std::string_view option, std::string_view text) {
  if (Notice why = left_out(option); !why.empty()) return why;
  if (is_coefficient<true>(option)) return Notice{"sweep_has_no_memory", {{"option", option}}};
  if (text.find_first_of(",:") == std::string_view::npos) return {};
  if (option == "settle") return Notice{"settle_is_no_grid", {{"typed", text}}};
  if (option == "threads") return Notice{"threads_are_no_grid", {{"typed", text}}};
  return {};
}

std::vector<Option> options_of(SweepOptions& o) {
  constexpr std::string_view sweep = "Sweep";
  std::vector<Option> options;
  for (Option option : point_options(o.simulate)) {
    if (is_in(with_grid, option.name) || is_coefficient<false>(option.name)) {
      option.target = &o.values[option.name];
      options.push_back(option);
    } else if (is_in(as_it_is, option.name)) {
      options.push_back(option);
    }
  }
  say_of_sweeps(options);
  options.insert(
      options.end(),
      {{"measure", &o.measure, "", Range::any,
        "amplitude, phase (lag behind the force), peak (largest |x|), mean and rms (of x over whole "
        "cycles), energy (likewise, or at the end), final (x and v), transmissibility (the mass's own "
        "amplitude over that of the shaking base); several with commas",
        "amplitude,phase of the settled motion; without a drive peak,final,energy", sweep},
       {"settle", &o.settle, "", Range::not_negative, "cycles of the drive that are dropped",
        "as many as it takes until the changes still to come are below 1e-6", sweep},
       {"direction", &o.direction, "", Range::any,
        "up, down or both: each point starts where the one before ended, so that jumps show",
        "each point by itself", sweep},
       {"threads", &o.threads, "", Range::positive, "how many work at once", "one for each processor", sweep},
       {"check", &o.check, "", Range::any,
        "where the answer is a closed form, step eight points as well and say how far they differ", "",
        sweep}});
  return options;
}

}  // namespace cromer::core
