#include "cromer/modes.h"

#include <memory>
#include <utility>

#include "cromer/door/words.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/network/network_file.h"

namespace cromer {

Result<Modes> modes(const std::string& file, const ModesOptions& options) {
  core::ModesOptions asked{
      .step = options.step, .beta = options.beta, .gamma = options.gamma, .rho_inf = options.rho_inf};
  for (const Method& method : options.method) asked.method.push_back(method.name());
  const auto network = core::open_network(file);
  if (!network) return network.error();
  auto found = core::network_modes(*network, file, asked);
  if (!found) return core::in_arguments(found.error());
  const auto result = std::make_shared<const core::ModesResult>(*std::move(found));
  Modes modes;
  modes.names = result->names;
  modes.notices = core::in_arguments(result->notices);
  for (const core::NaturalMode& mode : result->modes) {
    Mode& shown = modes.modes.emplace_back(
        Mode{mode.frequency, mode.damping_ratio, mode.shape, mode.participation, {}});
    for (const core::ModeByMethod& by : mode.methods)
      shown.methods.push_back({by.method, by.step, by.frequency(), by.damping_ratio(), by.effect.stable});
  }
  modes.detail = result;
  return modes;
}

}  // namespace cromer
