// Spectra as figures.
#pragma once

#include "cromer/report/figure.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

/// Pseudo-acceleration against period (of two components with their rotations), or a shock spectrum against
/// frequency.
Figure spectrum_figure(const SpectrumResult& result);

/// Pseudo-velocity against period, both logarithmic, over lines of equal displacement and acceleration.
Figure tripartite_figure(const SpectrumResult& result);

}  // namespace cromer::core
