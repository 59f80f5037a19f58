// A fit's document as an object that others take in.
#pragma once

#include "cromer/documents/json/json.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Of one that could not be read: what was to be fitted, and why it was not.
Json fit_object(const FittedRecording& fitted, const Voice& voice);

}  // namespace cromer::core
