// The documents of one recording, as objects that others take in.
#pragma once

#include "cromer/study/json/json.h"
#include "cromer/study/task/compare.h"
#include "cromer/study/task/fit.h"
#include "cromer/study/task/inspect.h"

namespace cromer::core {

/// {"file", "column", "samples", "used", "from", "to", "rate", "duration", "gaps", "outliers"} and the run.
Json recording_object(const FittedRecording& fitted);

/// The document of one fit.
Json fit_object(const FittedRecording& fitted);

/// The document of what is in a file; `with_values` adds the columns' numbers.
Json inspection_object(const Inspection& inspection, bool with_values);

/// The document of one comparison.
Json comparison_object(const CompareResult& comparison);

}  // namespace cromer::core
