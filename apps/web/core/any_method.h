// Any method on any law: the page compiles each method once, for all its uses.
#pragma once

#include <memory>
#include <string_view>

#include "cromer/methods/method_settings.h"
#include "cromer/model/any_terms.h"
#include "cromer/run/fixed_steps.h"

namespace cromer::core::page {

/// A stepper of the named method at the start of a run from y at t. The name must be in the registry; the
/// system must outlive the stepper.
std::unique_ptr<Stepper> stepper_of(std::string_view method, const MethodSettings& settings,
                                    const AnyTerms& system, double t, const State<double>& y);

}  // namespace cromer::core::page
