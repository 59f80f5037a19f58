// Steady oscillations in a record: of a machine, or of a mode that does not decay.
#pragma once

#include <vector>

#include "cromer/identify/modal/decay_fit.h"

namespace cromer::core {

/// Those of the candidates [rad/s] that are steady oscillations: one exponential whose size changes by less
/// than a third over the record accounts for 85 % of the power within three resolutions (1/duration) of its
/// frequency. Random forces keep no mode so steady. A line may be up to `reach` [rad/s] away from its
/// candidate.
Eigenvalues steady_lines(const ModalRecord& record, const std::vector<double>& candidates, double reach);

/// Whether an eigenvalue's oscillation keeps its size over the record, to a third.
bool is_steady(const ModalRecord& record, const std::complex<double>& eigenvalue);

}  // namespace cromer::core
