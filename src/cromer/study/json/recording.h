// What the documents of fit and compare have in common.
#pragma once

#include "cromer/study/json/json.h"
#include "cromer/study/task/compare.h"
#include "cromer/study/task/fit.h"

namespace cromer {

/// {"file", "column", "samples", "used", "from", "to", "rate", "duration", "gaps", "outliers"} and the run.
Json recording_object(const FittedRecording& fitted);

/// The document of one fit.
Json fit_object(const FittedRecording& fitted);

/// The document of one comparison.
Json comparison_object(const CompareResult& comparison);

}  // namespace cromer
