// The part of a motion, disturbed at first, that is one decaying swing.
#pragma once

#include <optional>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

struct FreeSwing {
  double from = 0;             // [s]
  std::optional<double> to{};  ///< [s] empty: to the record's end
};

/// From the first of a few times, a twentieth of the record apart and none later than two fifths of it, from
/// which a viscous law accounts for 95 % of the motion over five periods or more and is no worse in the first
/// one: the rms residual there is less than twice the whole, and that no larger than 1.3 times what the best
/// of these times leaves. To the end, or to where a last half period leaves residuals 2.5 times those of the
/// median one (three such at most), as where a hand stops the swing. Empty where there is no such time.
std::optional<FreeSwing> find_free_swing(const Record& record, const Watch& watch = {});

}  // namespace cromer::core
