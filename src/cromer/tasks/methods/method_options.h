// The options for the parameters of single methods, under whichever heading of the help they stand.
#pragma once

#include <optional>
#include <string_view>

#include "cromer/tasks/option/option.h"

namespace cromer::core {

Option beta_option(std::optional<double>& target, std::string_view group);
Option gamma_option(std::optional<double>& target, std::string_view group);
Option rho_inf_option(std::optional<double>& target, std::string_view group);

}  // namespace cromer::core
