// Which of several fitted laws to choose, and which others describe the record as well.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
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

/// The criterion by which fits of one record are compared.
class Criterion {
 public:
  /// `resolution` as in bayesian_criterion().
  Criterion(const std::vector<const LawFit*>& fits, double resolution);

  /// With as many independent samples as the closest fit leaves, so that no law's misfit is taken for noise.
  /// Where what is left holds the answer to the noise of a recorded force, each fit by its own likelihood
  /// with such noise; a fit without one (fitted roughly, or under hysteresis) is as far from the closest that
  /// has one as without such noise.
  double of(const LawFit& fit) const;

 private:
  double plain(const LawFit& fit) const;

  double independent_ = 0, resolution_ = 0;
  std::optional<double> by_noise_;  // what noise of the force adds to plain(); empty where none shows
};

/// Place of the candidate to choose; 0 where none is admissible. A law is admissible if it converged and each
/// of its terms (but for a lone damping) either has a 95 % interval without zero, or raises BIC by 6 or more
/// when it is taken away. Among the admissible candidates whose BIC is less than 6 above the lowest, those
/// with the fewest parameters count; of these the first whose BIC is less than 5 above their lowest is
/// chosen: laws met more often come first, and before all others one with a term that is `expected`, up to
/// twice as far above. Sets the candidates' BIC, by the Criterion of them all. `candidates` is not empty and
/// begins with the simplest law.
std::size_t choose_candidate(std::vector<LawFit>& candidates, double resolution = 0, Law expected = {});

/// The law without one of its terms, for each that has zero in its interval and can be left out: a law of low
/// BIC that is not admissible may be so without it.
std::vector<Law> without_unsure_terms(const LawFit& fit);

/// Whether a law describes the record as well as the chosen one: its BIC is at most strong_evidence higher,
/// and it has as many parameters or one more.
bool fits_as_well(const LawFit& rival, const LawFit& chosen);

/// The candidate with the law of a fit and its reading of a recorded force; nullptr if there is none.
const LawFit* among(const std::vector<LawFit>& candidates, const LawFit& fit);

/// The other laws that converged under the same reading of a recorded force, with as many parameters as the
/// chosen one or one more; none where it did not converge, or has no spring.
std::vector<const LawFit*> alternatives_to(const LawFit& chosen, const std::vector<LawFit>& candidates);

/// Those that fit as well as the chosen one, under the same reading of a recorded force, and would change
/// its numbers, by rising BIC; empty where it did not converge, or has no spring. A rival either puts a
/// coefficient that both share, or the frequency, further off than three of the standard errors that the
/// chosen one claims; or, with as many parameters, it has another damping in the place of the chosen one's.
std::vector<const LawFit*> rivals_of(const LawFit& chosen, const std::vector<LawFit>& candidates);

/// Names at most three of the rivals_of() the chosen law; empty where there are none, or where the record
/// shows no damping (of a hysteretic law that is not asked).
Notice rival_laws(const Record& record, const std::vector<LawFit>& candidates, std::size_t chosen);

}  // namespace cromer::core
