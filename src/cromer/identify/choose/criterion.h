// Which of several fitted laws a record asks for, and which others it speaks against no more.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "cromer/identify/law_fit.h"

namespace cromer::core {

/// Schwarz's criterion of so many independent samples with residuals of this rms, fitted by so many
/// parameters: the lower the better. Ann. Stat. 6, 461 (1978). Residuals below what rounding leaves
/// (`resolution`, 0 if unknown) only follow its pattern.
inline double bayesian_criterion(double independent_samples, double rms, double parameters,
                                 double resolution) {
  return independent_samples * 2 * std::log(std::max(rms, resolution / std::sqrt(12.0))) +
         parameters * std::log(independent_samples);
}

/// Differences of the criterion that are strong evidence: Kass & Raftery, J. Am. Stat. Assoc. 90, 773 (1995).
inline constexpr double strong_evidence = 6;

/// Place of the admissible candidate of lowest BIC; 0 where none is. A law is admissible if it converged and
/// each of its terms (but for a lone damping) either has a 95 % interval without zero, or raises BIC by more
/// than 6 when it is taken away. Sets the candidates' BIC, all of the number of samples which the closest
/// candidate's residuals leave independent, so that no law's misfit is taken for noise, and of this
/// `resolution`. Of admissible candidates within 6 of the lowest the one with the fewest parameters, and of
/// as many the lowest, or the first that is within 5 of it: laws met more often come first. `candidates` is
/// not empty and begins with the simplest law.
std::size_t choose_candidate(std::vector<LawFit>& candidates, double resolution = 0);

/// The law without one of its terms, for each that has zero in its interval and can be left out: a law of low
/// BIC that is not admissible may be so without it.
std::vector<Law> without_unsure_terms(const LawFit& fit);

/// Names the rival laws, which the record speaks against no more than against the chosen one and which
/// would change its numbers; empty where there are none. A rival lies within 6 of the chosen candidate's
/// BIC, has as many terms or one more (of a driven motion one more only with a lower criterion), and puts a
/// coefficient that both share, or the frequency, further off than three of the standard errors that the
/// chosen one claims; or it has another damping in the place of its own.
Notice rival_laws(const Record& record, const std::vector<LawFit>& candidates, std::size_t chosen);

}  // namespace cromer::core
