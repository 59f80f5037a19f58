#include "cromer/tasks/modes/modes.h"

namespace cromer::core {

std::vector<Option> options_of(ModesOptions& o) {
  constexpr std::string_view group = "What a method really simulates of each mode";
  return {
      {"method", &o.method, "", Range::any, "a name from `cromer methods`; may be given several times",
       "none", group},
      {"step", &o.step, "s", Range::positive, "time step of the methods", "", group},
      {"beta", &o.beta, "", Range::fraction,
       "of newmark: 1/4 average acceleration, 1/6 linear acceleration, 0 central difference", "0.25", group},
      {"gamma", &o.gamma, "", Range::fraction, "of newmark: above 1/2 it damps, below it grows", "0.5",
       group},
      {"rho-inf", &o.rho_inf, "", Range::fraction,
       "of generalized-alpha: the share of motions far faster than the step that is left after each step",
       "0.8", group},
  };
}

}  // namespace cromer::core
