// Modes of a structure that random forces keep in motion: wind, traffic, footsteps.
#pragma once

#include <vector>

#include "cromer/identify/modal/mode_search.h"

namespace cromer::core {

/// By rising frequency. A mode is a group of stable poles (stabilise) whose frequency is known to 1 % and its
/// damping to 60 %. Its frequency and damping ratio are means over its poles of several orders, from the
/// first at which all modes are there, each weighted by the inverse of its variance. The intervals are
/// first-order: the scatter of blocks of three decay times at least, and what blocks of that length lose of
/// the variance to their neighbours. `duration` [s] of the record.
std::vector<MeasuredMode> ambient_modes(const ModeSearch& search, const ModalSettings& settings,
                                        double duration);

}  // namespace cromer::core
