// Spectra as CSV: spectrum -o and --fourier.
#pragma once

#include <string>

#include "commands.h"
#include "cromer/study/task/response_spectrum.h"

namespace cromer::core::cli {

/// One row for each damping ratio and period, in the order asked for.
std::string spectrum_csv(const SpectrumResult& result, const Arguments& arguments);

/// Fourier amplitudes of the recording, one column for each component.
std::string fourier_csv(const SpectrumResult& result, const Arguments& arguments);

}  // namespace cromer::core::cli
