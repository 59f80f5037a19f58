// The study file of masses held at rest: what the spring's extension says of its constant.
#pragma once

#include <string>
#include <vector>

#include "cromer/study/lab_page.h"
#include "cromer/study/run_study.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {

/// A study that fits the same holds with the same options, as they were typed. `paths`: of the recordings,
/// from the study's folder; `files`: what the page calls them.
std::string static_report(const StaticStiffness& found, const std::vector<std::string>& paths,
                          const std::vector<std::string>& files, const std::vector<TypedOption>& options,
                          const ReportFront& front);

/// The result of its task. `found` must outlive it.
KnownResults known_results(const StaticStiffness& found);

}  // namespace cromer::core
