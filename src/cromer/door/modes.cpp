#include "cromer/modes.h"

#include <memory>
#include <utility>

#include "cromer/door/words.h"
#include "cromer/tasks/modes_of_file.h"

namespace cromer {

Result<Modes> modes(const std::string& file, const ModesOptions& options) {
  core::ModesOptions asked{
      .step = options.step, .beta = options.beta, .gamma = options.gamma, .rho_inf = options.rho_inf};
  for (const Method& method : options.method) asked.method.push_back(method.name());
  asked.modes = options.modes;
  asked.read = options.read;
  asked.from_frequency = options.from_frequency;
  asked.to_frequency = options.to_frequency;
  if (options.of_method) asked.of_method = options.of_method->name();
  auto found = core::modes_of_file(file, asked);
  if (!found) return core::in_arguments(found.error());
  const auto result = std::make_shared<const core::ModesResult>(*std::move(found));
  Modes modes;
  modes.names = result->names;
  modes.notices = core::in_arguments(result->notices);
  modes.message = core::in_arguments(result->message);
  for (const core::NaturalMode& mode : result->modes) {
    Mode& shown = modes.modes.emplace_back(
        Mode{mode.frequency, mode.damping_ratio, mode.shape, mode.shape_error, mode.participation, {}});
    for (const core::ModeByMethod& by : mode.methods)
      shown.methods.push_back({by.method, by.step, by.frequency(), by.damping_ratio(), by.effect.stable});
  }
  modes.detail = result;
  return modes;
}

}  // namespace cromer
