#include "cromer/tasks/modes_of_file.h"

#include "cromer/tasks/network/network_file.h"
#include "cromer/tasks/open_recording.h"

namespace cromer::core {

Result<ModesResult> modes_of_file(const std::string& path, const ModesOptions& options) {
  if (is_network_file(path)) {
    const auto network = open_network(path);
    if (!network) return network.error();
    return network_modes(*network, path, options);
  }
  const auto recording = open_recording(path, options.read);
  if (!recording) return recording.error();
  return recording_modes(*recording, options);
}

}  // namespace cromer::core
