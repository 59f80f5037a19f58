// Spectra in words, for a terminal.
#pragma once

#include <string>

#include "cromer/study/task/response_spectrum.h"

namespace cromer::core::cli {

std::string spectrum_text(const SpectrumResult& result);

}  // namespace cromer::core::cli
