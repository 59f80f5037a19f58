// The tasks' results as the plain structs of the door; each keeps what it was made of.
#pragma once

#include <memory>

#include "cromer/compare.h"
#include "cromer/fit.h"
#include "cromer/methods.h"
#include "cromer/study/task/compare.h"
#include "cromer/study/task/fit.h"
#include "cromer/study/task/method_effect.h"

namespace cromer::core {

/// `of_arrays`: the record has samples, not lines.
cromer::LawFit fit_of(FittedRecording fitted, bool of_arrays);

cromer::MethodEffect effect_of(const MethodEffect& effect);

}  // namespace cromer::core
