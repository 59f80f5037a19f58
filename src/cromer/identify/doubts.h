// What speaks against a fit that converged: a swing that is not free, or that no law tried describes.
#pragma once

#include <string>
#include <vector>

#include "cromer/identify/free_decay.h"

namespace cromer {

/// Sentences for the user; none where nothing is suspicious. Looked for are an amplitude that rises, one that
/// does not fall over twenty periods, and residuals well above the noise from sample to sample.
std::vector<std::string> doubts(const Record& record, const FreeDecay& fit);

}  // namespace cromer
