// One step of a method on the linear law, as a matrix.
#pragma once

#include <string_view>

#include "cromer/analysis/effective_oscillator.h"
#include "cromer/methods/method_settings.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

/// The map of one step h > 0 [s] of the method of that name on the free law.
StepMap step_map_of(std::string_view method, const MethodSettings& settings, const LinearLaw<double>& law,
                    double h);

}  // namespace cromer::core
