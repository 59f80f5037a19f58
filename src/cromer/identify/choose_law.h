// The simplest law that a record asks for.
#pragma once

#include <vector>

#include "cromer/identify/free_decay.h"

namespace cromer {

struct LawChoice {
  FreeDecay chosen;
  std::vector<FreeDecay>
      candidates;  ///< viscous, viscous+drag, viscous+cubic, viscous+drag+cubic; one only if that was refused
};

/// Fits the candidates and takes the one of lowest BIC among those whose every extra term's 95 % interval
/// excludes zero. The number of samples in the BIC of all of them is that which the closest candidate's
/// residuals leave independent. Schwarz, Ann. Stat. 6, 461 (1978). Of a record of more than 200,000 samples
/// the candidates see a part, and the chosen law is then fitted to all. An interruption is iteration_limit
/// with a message; the candidates are then those that were done.
LawChoice choose_law(const Record& record, const FreeDecayOptions& options, const Watch& watch = {});

}  // namespace cromer
