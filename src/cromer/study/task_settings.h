// From the keys of a study's task to the options of the command.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/result.h"
#include "cromer/study/results.h"
#include "cromer/study/study_file.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {

/// Assigns every setting to its option, results filled into the texts. An unknown key gets the nearest right
/// one suggested; errors name the place.
Result<void> assign_settings(const TaskSpec& task, const std::vector<Option>& options,
                             const Results& results);

}  // namespace cromer::core
