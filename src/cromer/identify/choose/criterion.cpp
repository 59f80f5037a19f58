#include "cromer/identify/choose/criterion.h"

#include <algorithm>
#include <cmath>

namespace cromer::core {
namespace {

bool excludes_zero(const Estimate& term) { return term.low > 0 || term.high < 0; }

// The estimate of one of the law's terms that could be left out; nullptr where it could not.
const Estimate* removable(const LawFit& fit, const TermInfo& info, Law term) {
  if (springs.contains(term)) return nullptr;
  // A lone damping term may be as small as it is.
  const Law taking = dampings.with(bounding_terms);
  if (info.damps && Law{fit.law.terms & taking.terms}.size() < 2) return nullptr;
  const Estimate* found = nullptr;
  for_each_term([&]<class T>() {
    if (T::info.name == info.name) found = fit.find(T::coefficients[0].parameter);
  });
  return found;
}

bool is_admissible(const LawFit& fit, const std::vector<LawFit>& candidates) {
  if (fit.status != FitStatus::converged) return false;
  const std::vector<Law> simpler_laws = without_unsure_terms(fit);
  return std::all_of(simpler_laws.begin(), simpler_laws.end(), [&](const Law& law) {
    const auto simpler = std::find_if(candidates.begin(), candidates.end(), [&](const LawFit& other) {
      return other.law == law && other.drive.force.between == fit.drive.force.between &&
             other.residual.rms > 0;
    });
    return simpler != candidates.end() && simpler->bic >= fit.bic + strong_evidence;
  });
}

}  // namespace

std::vector<Law> without_unsure_terms(const LawFit& fit) {
  std::vector<Law> laws;
  for (std::size_t i = 0; i < term_count; ++i) {
    const Law term{std::uint32_t{1} << i};
    if (!fit.law.shares(term)) continue;
    const Estimate* estimate = removable(fit, term_infos[i], term);
    if (estimate && !excludes_zero(*estimate)) laws.push_back(fit.law.without(term));
  }
  return laws;
}

std::size_t choose_candidate(std::vector<LawFit>& candidates, double resolution) {
  const LawFit* closest = &candidates.front();
  for (const LawFit& fit : candidates)
    if (fit.status == FitStatus::converged && fit.residual.rms < closest->residual.rms) closest = &fit;
  const double independent = closest->independent_samples;
  for (LawFit& fit : candidates)
    if (fit.residual.rms > 0 && independent > 0)
      fit.bic = bayesian_criterion(independent, fit.residual.rms, fit.fitted, resolution);
  std::vector<bool> admissible;
  for (const LawFit& fit : candidates) admissible.push_back(is_admissible(fit, candidates));
  std::size_t best = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (admissible[i] && (!admissible[best] || candidates[i].bic < candidates[best].bic)) best = i;
  // Evidence that is not strong does not speak against a simpler law: the fewest terms then. Of as many terms
  // a law met more often stays unless the other is clearly better; rival_laws.h says where neither is.
  constexpr double clear = 5;
  const double lowest = candidates[best].bic;
  const auto eligible = [&](std::size_t i) {
    return admissible[i] && candidates[i].bic < lowest + strong_evidence;
  };
  int fewest = candidates[best].fitted;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (eligible(i)) fewest = std::min(fewest, candidates[i].fitted);
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (eligible(i) && candidates[i].fitted == fewest) least = std::min(least, candidates[i].bic);
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (eligible(i) && candidates[i].fitted == fewest && candidates[i].bic < least + clear) return i;
  return best;
}

}  // namespace cromer::core
