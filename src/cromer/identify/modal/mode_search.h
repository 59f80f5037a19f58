// The search for stable poles in a record: its correlations, the models of all orders, and their poles.
#pragma once

#include <optional>
#include <vector>

#include "cromer/identify/modal/spectral_matrix.h"
#include "cromer/identify/modal/stabilisation.h"

namespace cromer::core {

struct ModeSearch {
  BlockCorrelations correlations;
  Subspace subspace;
  Stabilisation stable;
  int highest_order = 0;
};

/// The lags span about four periods of the lowest peak, and are as far apart as the highest one allows.
/// `peaks`: of the record's spectral matrix. Empty where the record is too short.
std::optional<ModeSearch> search_modes(const ModalRecord& record, const std::vector<SpectralPeak>& peaks,
                                       const ModalSettings& settings);

}  // namespace cromer::core
