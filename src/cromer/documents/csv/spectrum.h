// Spectra as CSV: spectrum -o and --fourier.
#pragma once

#include <string>

#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

/// One row for each damping ratio and period, in the order asked for.
std::string spectrum_csv(const SpectrumResult& result, const std::string& command);

/// Fourier amplitudes of the recording, one column for each component.
std::string fourier_csv(const SpectrumResult& result, const std::string& command);

}  // namespace cromer::core
