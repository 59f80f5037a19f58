// A fit's document as an object that others take in.
#pragma once

#include <cstddef>

#include "cromer/documents/json/json.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// Of one that could not be read: what was to be fitted, and why it was not.
Json fit_object(const FittedRecording& fitted, const Voice& voice);

/// How many of a list's fits failed, as its "message"; nothing where none did.
void add_failures(Json& document, std::size_t failed, std::size_t all, const Voice& voice);

}  // namespace cromer::core
