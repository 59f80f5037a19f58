// Which of several fitted laws a record asks for.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "cromer/identify/free_decay.h"

namespace cromer {

/// Schwarz's criterion of so many independent samples with residuals of this rms, fitted by so many
/// parameters: the lower the better. Ann. Stat. 6, 461 (1978).
inline double bayesian_criterion(double independent_samples, double rms, double parameters) {
  return independent_samples * 2 * std::log(rms) + parameters * std::log(independent_samples);
}

/// Place of the candidate of lowest BIC among those that converged and whose every extra term's 95 % interval
/// excludes zero; 0 where none is. Sets the candidates' BIC, all of the number of samples which the closest
/// candidate's residuals leave independent. Of candidates within 6 of the
/// lowest (less than strong evidence: Kass & Raftery, J. Am. Stat. Assoc. 90, 773 (1995)) the one with the
/// fewest parameters, and of as many the lowest, or the first that is within 5 of it: laws met more often
/// come first. `candidates` is not empty and begins with the simplest law.
std::size_t choose_candidate(std::vector<FreeDecay>& candidates);

}  // namespace cromer
