// Hysteretic damping in a sweep: a spring k (1 + i eta), of which steady states alone can be told.
#pragma once

#include <vector>

#include "cromer/tasks/option/option.h"
#include "cromer/tasks/sweep/sweep.h"
#include "cromer/tasks/sweep/sweep_rows.h"

namespace cromer::core {

/// The options that make a point of a sweep: those of simulate, and the loss factor.
std::vector<Option> point_options(SimulateOptions& options);

/// Whether the sweep's springs have a loss factor.
bool has_loss_factor(const SweepOptions& options);

/// That what else is asked for can be told of it: a steady state of the linear law, no damper, closed form.
/// Called when `work` has its method and base. An Error names the option and the cure.
Result<void> check_loss_factor(const SweepOptions& options, const SweepWork& work);

/// That there is a settled motion and that it is what is measured, once `work` knows.
Result<void> check_settled_loss(const SweepOptions& options, const SweepWork& work);

}  // namespace cromer::core
