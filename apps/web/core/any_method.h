// Any method at work on any law: the page has one code of each method for all that it does with it.
#pragma once

#include <memory>
#include <string_view>

#include "cromer/methods/method_settings.h"
#include "cromer/model/any_terms.h"
#include "cromer/run/fixed_steps.h"

namespace cromer::core::page {

/// The method of that name, which must be in the list, at the start of a run from y at t. The system outlives
/// it.
std::unique_ptr<Stepper> stepper_of(std::string_view method, const MethodSettings& settings,
                                    const AnyTerms& system, double t, const State<double>& y);

}  // namespace cromer::core::page
