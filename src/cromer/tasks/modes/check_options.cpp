#include "cromer/methods/all.h"
#include "cromer/tasks/modes/modes_options.h"

namespace cromer::core {

Result<void> check_modes_options(ModesOptions options, std::string_view method_option) {
  for (const auto& option : options_of(options))
    if (auto good = check(option); !good) return good;
  for (const std::string& method : options.method) {
    if (auto good = check_method_name(method); !good) return good;
    if (find_method(method)->is_adaptive())
      return Error{"method_without_steps", {{"option", method_option}, {"method", method}}};
  }
  if (options.step && options.method.empty()) return Error{"step_needs_method"};
  if (!options.step && !options.method.empty()) return Error{"method_needs_step"};
  if (!options.step && (options.beta || options.gamma || options.rho_inf))
    return Error{"option_needs_method_and_step",
                 {{"option", options.rho_inf ? "rho-inf"
                             : options.beta  ? "beta"
                                             : "gamma"},
                  {"method", method_option}}};
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
  if (options.run) return "run";
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
