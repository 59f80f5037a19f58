// The simplest law that a record asks for.
#pragma once

#include <vector>

#include "cromer/identify/free_decay.h"

namespace cromer {

struct LawChoice {
  FreeDecay chosen;
  /// All sums of viscous, drag and friction, each without and with cubic, for angles also as a pendulum; the
  /// viscous law first, and it alone if that was refused. Only the chosen one and the one of lowest BIC
  /// beside it are fitted to the last digit, the others well enough to be compared.
  std::vector<FreeDecay> candidates;
};

/// Fits the candidates and takes the one of lowest BIC among those whose every term's 95 % interval excludes
/// zero. Residuals that are not white count for less: the number of samples in the BIC of all candidates is
/// that which the closest candidate's residuals leave independent. Schwarz, Ann. Stat. 6, 461 (1978). Of a
/// record of more than 200,000 samples the candidates see a part, and the chosen law is then fitted to all.
/// An interruption is iteration_limit with a message; the candidates are then those that were done.
LawChoice choose_law(const Record& record, const FreeDecayOptions& options, const Watch& watch = {});

}  // namespace cromer
