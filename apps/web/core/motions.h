// What the page draws of its runs: the states, and what each method makes of the law.
#pragma once

#include "cromer/documents/json/json.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core::page {

/// {"runs": [...], "linear_part": {...}, "warnings": [...]}: of the document of documents/json what is asked
/// at every move of a slider, and what the law itself is known by. The columns go straight into
/// json_blocks(); runs with the same times share them.
Json motions_of(const SimulateResult& result);

}  // namespace cromer::core::page
