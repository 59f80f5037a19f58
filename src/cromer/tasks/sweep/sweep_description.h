// What a sweep's rows depend on, for people and for files.
#pragma once

#include <string>
#include <string_view>

#include "cromer/tasks/sweep/sweep.h"
#include "cromer/tasks/sweep/sweep_rows.h"

namespace cromer::core {

/// "closed form", "stepped until settled", "stepped to the end", "run one by one".
std::string_view words(SweepWay way);

/// How long the steps are and how far they go, unless that is swept or settled by the method: "steps of
/// 0.01 s, to 60 s", "200 steps in a natural period, for 20 natural periods"; empty where there is nothing to
/// say.
std::string steps_in_words(const SweepWork& work);

/// Everything that the rows depend on, in a fixed order, as JSON; `settings` are those of the first row.
std::string describe(const SweepOptions& options, const SweepWork& work, const MethodSettings& settings,
                     const SweepPlan& plan);

}  // namespace cromer::core
