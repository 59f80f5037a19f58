// Networks as callers hand them in, and as they get them back.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "cromer/network.h"
#include "cromer/result.h"
#include "cromer/tasks/network/network_file.h"

namespace cromer::core {

Result<NetworkFile> network_of(const cromer::Network& network);

/// An object as the network's file would be, {"mass": [...], "link": [...]}, or the path of a file.
Result<NetworkFile> network_of(const nlohmann::json& request);

/// Values that are open come without value.
cromer::Network shown(const NetworkFile& network);

}  // namespace cromer::core
