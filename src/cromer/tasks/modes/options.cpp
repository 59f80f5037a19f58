#include "cromer/methods/all.h"
#include "cromer/tasks/modes/modes_options.h"

namespace cromer::core {

std::vector<Option> options_of(ModesOptions& o) {
  constexpr std::string_view group = "What a method really simulates of each mode";
  constexpr std::string_view recording = "Modes of a recording";
  std::vector<Option> options = {
      {"method", &o.method, "", Range::any, "a name from `cromer methods`; may be given several times",
       "none", group},
      {"step", &o.step, "s", Range::positive, "time step of the methods", "", group},
      {"beta", &o.beta, "", Range::fraction,
       "of newmark: 1/4 average acceleration, 1/6 linear acceleration, 0 central difference", "0.25", group},
      {"gamma", &o.gamma, "", Range::fraction, "of newmark: above 1/2 it damps, below it grows", "0.5",
       group},
      {"rho-inf", &o.rho_inf, "", Range::fraction,
       "of generalized-alpha: the share of motions far faster than the step that is left after each step",
       "0.8", group},
      {"from", &o.from, "s", Range::any, "first time used", "the first sample", recording},
      {"to", &o.to, "s", Range::any, "last time used", "the last sample", recording},
      {"modes", &o.modes, "", Range::at_least_one,
       "how many at most: those found at most orders of the model", "all that are found", recording},
      {"from-frequency", &o.from_frequency, "rad/s", Range::not_negative, "only modes from this frequency on",
       "0", recording},
      {"to-frequency", &o.to_frequency, "rad/s", Range::positive, "only modes up to this frequency",
       "half the rate", recording},
      {"of-method", &o.of_method, "", Range::any,
       "the recording was simulated by this method with this --step: its share is taken out", "none",
       recording},
  };
  for (const Option& option : options_of(o.read)) options.push_back(option);
  return options;
}

Result<void> check_modes_options(ModesOptions options) {
  for (const auto& option : options_of(options))
    if (auto good = check(option); !good) return good;
  for (const std::string& method : options.method) {
    if (auto good = check_method_name(method); !good) return good;
    if (find_method(method)->is_adaptive()) return Error{"method_without_steps", {{"method", method}}};
  }
  if (options.step && options.method.empty()) return Error{"step_needs_method"};
  if (!options.step && !options.method.empty()) return Error{"method_needs_step"};
  if (!options.step && (options.beta || options.gamma || options.rho_inf))
    return Error{"option_needs_method_and_step",
                 {{"option", options.rho_inf ? "rho-inf"
                             : options.beta  ? "beta"
                                             : "gamma"}}};
  return {};
}

MethodSettings method_settings_of(const ModesOptions& options) {
  MethodSettings settings;
  settings.beta = options.beta.value_or(settings.beta);
  settings.gamma = options.gamma.value_or(settings.gamma);
  settings.rho_inf = options.rho_inf.value_or(settings.rho_inf);
  return settings;
}

std::string_view option_of_recordings(const ModesOptions& options) {
  if (options.from) return "from";
  if (options.to) return "to";
  if (options.modes) return "modes";
  if (options.from_frequency) return "from-frequency";
  if (options.to_frequency) return "to-frequency";
  if (!options.of_method.empty()) return "of-method";
  if (options.network) return "network";
  const ReadOptions& read = options.read;
  if (read.rate != 0) return "rate";
  if (!read.time_column.empty()) return "time-column";
  if (!read.delimiter.empty()) return "delimiter";
  if (!read.decimal.empty()) return "decimal";
  return read.skip_bad_rows ? "skip-bad-rows" : "";
}

}  // namespace cromer::core
