#include "cromer/identify/choose_law.h"

#include <cmath>

namespace cromer {
namespace {

bool excludes_zero(const std::optional<Estimate>& term) { return !term || term->low > 0 || term->high < 0; }

double information_criterion(const FreeDecay& fit, double independent_samples) {
  return independent_samples * 2 * std::log(fit.residual.rms) +
         static_cast<double>(fit.names.size()) * std::log(independent_samples);
}

}  // namespace

LawChoice choose_law(const Record& record, const FreeDecayOptions& options, const Watch& watch) {
  LawChoice choice;
  const Law laws[] = {{.viscous = true},
                      {.viscous = true, .drag = true},
                      {.viscous = true, .cubic = true},
                      {.viscous = true, .drag = true, .cubic = true}};
  for (const Law& law : laws) {
    FreeDecayOptions one = options;
    one.law = law;
    choice.candidates.push_back(fit_free_decay(record, one, watch));
    const FitStatus status = choice.candidates.front().status;
    if (status != FitStatus::converged && status != FitStatus::iteration_limit) break;
  }

  const FreeDecay* closest = &choice.candidates.front();
  for (const FreeDecay& fit : choice.candidates)
    if (fit.status == FitStatus::converged && fit.residual.rms < closest->residual.rms) closest = &fit;
  const double independent = closest->independent_samples;
  const FreeDecay* best = &choice.candidates.front();
  for (FreeDecay& fit : choice.candidates) {
    if (fit.residual.rms <= 0) continue;
    fit.bic = information_criterion(fit, independent);
    if (fit.status != FitStatus::converged || !excludes_zero(fit.drag) || !excludes_zero(fit.cubic)) continue;
    if (best->status != FitStatus::converged || fit.bic < best->bic) best = &fit;
  }
  choice.chosen = *best;
  return choice;
}

}  // namespace cromer
