#include "cromer/tasks/methods/method_options.h"

namespace cromer::core {

Option beta_option(std::optional<double>& target, std::string_view group) {
  return {"beta",
          &target,
          "",
          Range::fraction,
          "of newmark: 1/4 average acceleration, 1/6 linear acceleration, 0 central difference",
          "0.25",
          group};
}

Option gamma_option(std::optional<double>& target, std::string_view group) {
  return {"gamma", &target, "", Range::fraction, "of newmark: above 1/2 it damps, below it grows",
          "0.5",   group};
}

Option rho_inf_option(std::optional<double>& target, std::string_view group) {
  return {"rho-inf",
          &target,
          "",
          Range::fraction,
          "of generalized-alpha: the share of motions far faster than the step that is left after each step",
          "0.8",
          group};
}

}  // namespace cromer::core
