// The part of a motion, disturbed at its beginning and perhaps its end, that is one decaying swing.
#pragma once

#include <optional>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// A part of a record that swings freely.
struct FreeSwing {
  double from = 0;             ///< [s]
  std::optional<double> to{};  ///< [s] empty: to the record's end
  double period = 0;           // [s]
};

/// The longest of a few parts, from a twentieth to two fifths of the record to its end or as much as two
/// fifths before, of which a viscous law accounts for 95 % over four periods or more and is no worse in the
/// first and the last one: the rms residual there is less than twice the part's, and that no larger than 1.15
/// times the least of all parts. In steps of a twentieth of the record, then of an eightieth about the
/// longest; then shorter by so much until a law of all but the last period is no worse in that either, if
/// there is such a part. Where a law with drag and a cubic spring leaves noise alone, the part is then
/// extended on either side as far as it leaves no more than by chance. Empty where there is none.
std::optional<FreeSwing> find_free_swing(const Record& record, const Watch& watch = {});

}  // namespace cromer::core
