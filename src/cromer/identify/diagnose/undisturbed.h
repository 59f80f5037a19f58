// From where on a motion that was disturbed at first is one decaying swing.
#pragma once

#include <optional>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// The first of a few times [s], a twentieth of the record apart and none later than two fifths of it, from
/// which a viscous law accounts for 95 % of the motion over five periods or more and is no worse in the first
/// one: the rms residual there is less than twice the whole, and that no larger than 1.3 times what the best
/// of these times leaves. Empty where there is none.
std::optional<double> swings_freely_from(const Record& record, const Watch& watch = {});

}  // namespace cromer::core
