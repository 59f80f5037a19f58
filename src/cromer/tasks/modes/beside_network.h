// The modes of a recording beside those of a network.
#pragma once

#include "cromer/model/network.h"
#include "cromer/result.h"
#include "cromer/tasks/modes/modes.h"

namespace cromer::core {

/// Gives each mode of a recording the one of the network that has the likest shape and frequency; the
/// channels are the masses, in the network's order. Notes modes that are like none and, with `all`, those of
/// the network that were not found, or instead that two channels look swapped or one reversed. An Error says
/// that there are more or fewer channels than masses.
Result<void> set_beside(ModesResult& found, const Network& network, bool all);

}  // namespace cromer::core
