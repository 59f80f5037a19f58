// Spectra in words, for a terminal.
#pragma once

#include <string>

#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

std::string spectrum_text(const SpectrumResult& result);

}  // namespace cromer::core
