#include "cromer/identify/modal/modal_analysis.h"

#include <algorithm>

#include "cromer/identify/modal/ambient_modes.h"
#include "cromer/identify/modal/free_decay.h"

namespace cromer::core {
namespace {

// Start values of a free decay: each group's pole at the lowest order at which all have appeared.
std::vector<std::complex<double>> eigenvalues_of_groups(const ModeSearch& search,
                                                        const ModalSettings& settings) {
  const Stabilisation& all = search.stable;
  auto groups = all.groups;
  std::stable_sort(groups.begin(), groups.end(),
                   [&](const auto& a, const auto& b) { return all.orders(a) > all.orders(b); });
  const std::size_t most = settings.modes > 0
                               ? std::min(most_decaying_modes, static_cast<std::size_t>(settings.modes))
                               : most_decaying_modes;
  if (groups.size() > most) groups.resize(most);
  const int together = all.first_common_order(groups);
  std::vector<std::complex<double>> result;
  for (const auto& group : groups) {
    std::size_t chosen = group.back();
    for (const std::size_t i : group)
      if (all.poles[i].order >= together) {
        chosen = i;
        break;
      }
    const StabilityPole& pole = all.poles[chosen];
    result.push_back(std::log(all.model(pole.order).values(pole.index)) / search.correlations.step);
  }
  return result;
}

}  // namespace

ModalAnalysis find_modes(const ModalRecord& record, const ModalSettings& settings) {
  ModalAnalysis result;
  result.spectrum = spectral_matrix(record);
  result.peaks = spectral_peaks(result.spectrum);
  const auto search = search_modes(record, result.peaks, settings);
  if (!search) return result;
  result.highest_order = search->highest_order;
  result.lags = search->correlations.lags;
  result.lag_step = search->correlations.step;
  result.poles = search->stable.poles;

  const auto start = eigenvalues_of_groups(*search, settings);
  constexpr double worth_fitting = 0.5, decays = 0.9;
  if (!start.empty() && decaying_share(record, start) > worth_fitting) {
    FreeDecay decay = fit_free_decay(record, start);
    result.decaying_share = decay.share;
    if (decay.converged && decay.share > decays && !decay.modes.empty()) {
      result.motion = ModalMotion::free_decay;
      result.modes = std::move(decay.modes);
      // Averages are for random forces: one long segment tells more modes apart.
      result.spectrum = spectral_matrix(record, 1);
      result.peaks = spectral_peaks(result.spectrum);
      return result;
    }
  }
  result.modes = ambient_modes(*search, settings, static_cast<double>(record.samples()) * record.step);
  return result;
}

}  // namespace cromer::core
