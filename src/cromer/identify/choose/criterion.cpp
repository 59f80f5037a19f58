#include "cromer/identify/choose/criterion.h"

#include <algorithm>
#include <cmath>

namespace cromer {
namespace {

bool excludes_zero(const std::optional<Estimate>& term) { return !term || term->low > 0 || term->high < 0; }

// A lone damping term may be as small as it is; of two or more each must show.
bool every_term_shows(const FreeDecay& fit) {
  const int dampings = fit.law.viscous + fit.law.drag + fit.law.friction;
  if (!excludes_zero(fit.cubic)) return false;
  if (dampings < 2) return true;
  return (!fit.law.viscous || fit.decay_rate.low > 0) && excludes_zero(fit.drag) &&
         excludes_zero(fit.friction);
}

double information_criterion(const FreeDecay& fit, double independent_samples) {
  return bayesian_criterion(independent_samples, fit.residual.rms, static_cast<double>(fit.names.size()));
}

}  // namespace

std::size_t choose_candidate(std::vector<FreeDecay>& candidates) {
  const FreeDecay* closest = &candidates.front();
  for (const FreeDecay& fit : candidates)
    if (fit.status == FitStatus::converged && fit.residual.rms < closest->residual.rms) closest = &fit;
  const double independent = closest->independent_samples;
  std::size_t best = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    FreeDecay& fit = candidates[i];
    if (fit.residual.rms <= 0) continue;
    fit.bic = information_criterion(fit, independent);
    if (fit.status != FitStatus::converged || !every_term_shows(fit)) continue;
    if (candidates[best].status != FitStatus::converged || fit.bic < candidates[best].bic) best = i;
  }
  // Evidence that is not strong does not speak against a simpler law: the fewest terms then. Of as many terms
  // a law met more often stays unless the other is clearly better; rival_laws.h says where neither is.
  constexpr double strong = 6, clear = 5;
  const double lowest = candidates[best].bic;
  const auto eligible = [&](const FreeDecay& fit) {
    return fit.status == FitStatus::converged && every_term_shows(fit) && fit.bic < lowest + strong;
  };
  std::size_t fewest = candidates[best].names.size();
  for (const FreeDecay& fit : candidates)
    if (eligible(fit)) fewest = std::min(fewest, fit.names.size());
  double least = HUGE_VAL;
  for (const FreeDecay& fit : candidates)
    if (eligible(fit) && fit.names.size() == fewest) least = std::min(least, fit.bic);
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (eligible(candidates[i]) && candidates[i].names.size() == fewest && candidates[i].bic < least + clear)
      return i;
  return best;
}

}  // namespace cromer
