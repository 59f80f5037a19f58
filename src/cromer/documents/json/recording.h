// The documents of one recording, as objects that others take in.
#pragma once

#include "cromer/documents/json/json.h"
#include "cromer/documents/words/words.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/inspect/inspect.h"

namespace cromer::core {

/// {"file", "column", "samples", "used", "from", "to", "rate", "duration", "gaps", "outliers"} and the run.
Json recording_object(const FittedRecording& fitted);

/// The document of one fit.
Json fit_object(const FittedRecording& fitted, const Voice& voice);

/// The document of what is in a file; `with_values` adds the columns' numbers.
Json inspection_object(const Inspection& inspection, bool with_values, const Voice& voice);

/// The document of one comparison.
Json comparison_object(const CompareResult& comparison, const Voice& voice);

}  // namespace cromer::core
