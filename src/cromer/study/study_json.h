// What a study found and wrote, as JSON documents.
#pragma once

#include <string>

#include "cromer/study/results.h"
#include "cromer/study/write_report.h"

namespace cromer::core {

/// {"two.stiffness": {"value", "standard_error", "unit"}, "two.law": "text", ...}: every fact, in SI units,
/// by name.
std::string to_json(const Results& results);

/// {"index", "figures": [paths], "warnings", "notices", "shown"}, with "message" where a task failed.
std::string to_json(const WrittenReport& report);

}  // namespace cromer::core
