// Which law a forced motion follows, and what its force did between the samples.
#pragma once

#include <optional>
#include <vector>

#include "cromer/identify/forced_fit.h"

namespace cromer {

struct ForcedChoice {
  ForcedFit chosen;
  std::vector<ForcedFit> candidates;  ///< all that were fitted, without their motions
};

/// Fits what is not given both ways: the readings of the force first, with all of stiffness but no drag, and
/// then, with the reading that leaves least, the laws. The law is that of lowest BIC among those whose extra
/// terms' intervals exclude zero. Readings that leave about as little under that law are named in a warning,
/// and the linear one is preferred to them. Of records above 200,000 samples the first 100,000 decide.
ForcedChoice choose_forced(const ForcedRecord& record, const std::optional<ForcedTerms>& terms,
                           const std::optional<ForceBetween>& between, const Watch& watch = {});

/// The place of the law to choose among candidates of one reading; fills their bic, of as many samples as are
/// independent in the closest. `resolution` is the rounding step of the values, 0 if unknown.
std::size_t judge_forced(std::vector<ForcedFit>& candidates, double resolution);

}  // namespace cromer
