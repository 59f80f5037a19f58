// The methods of integration as a text for people.
#pragma once

#include <span>
#include <string>

#include "cromer/tasks/methods/methods.h"

namespace cromer::core {

/// Their table; where `options` ask for a step, what each of them simulates instead.
std::string methods_text(const MethodsOptions& options, std::span<const MethodRow> methods);

}  // namespace cromer::core
