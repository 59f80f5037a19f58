// `fit` of a study with `static`: masses held at rest.
#pragma once

#include "cromer/study/work.h"

namespace cromer::core {

Result<TaskReport> fit_static_task(const Work& work);

}  // namespace cromer::core
