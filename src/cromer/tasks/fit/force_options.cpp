#include "cromer/tasks/fit/force_options.h"

#include "cromer/tasks/fit/fit_options.h"

namespace cromer::core {

Result<void> check_force_options(const FitOptions& options) {
  const bool has_force = !options.force_column.empty();
  if (options.no_spring && !has_force) return Error{"no_spring_without_force"};
  if (has_force && !options.drive_frequency.empty()) return Error{"two_drives"};
  if (!options.between_samples.empty()) {
    if (!has_force) return Error{"between_samples_without_force"};
    if (!reading_of(options) && options.between_samples != "auto")
      return Error{"between_samples_unknown", {{"typed", options.between_samples}}};
  }
  if (options.hold_out) {
    if (!has_force) return Error{"hold_out_without_force"};
    if (!(*options.hold_out > 0 && *options.hold_out <= 0.9))
      return Error{"hold_out_outside", {{"share", *options.hold_out}}};
  }
  return {};
}

}  // namespace cromer::core
