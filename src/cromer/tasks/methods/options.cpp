#include "cromer/tasks/methods/methods.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {

std::vector<Option> options_of(MethodsOptions& o) {
  constexpr std::string_view group = "What each method really simulates";
  return {
      {"natural-frequency", &o.natural_frequency, "rad/s", Range::positive,
       "natural frequency of the oscillator", "", group},
      {"damping-ratio", &o.damping_ratio, "", Range::not_negative, "damping ratio of the oscillator", "0",
       group},
      {"step", &o.step, "s", Range::positive, "time step", "", group},
      {"beta", &o.beta, "", Range::fraction,
       "of newmark: 1/4 average acceleration, 1/6 linear acceleration, 0 central difference", "0.25", group},
      {"gamma", &o.gamma, "", Range::fraction, "of newmark: above 1/2 it damps, below it grows", "0.5",
       group},
      {"rho-inf", &o.rho_inf, "", Range::fraction,
       "of generalized-alpha: the share of motions far faster than the step that is left after each step",
       "0.8", group},
      {"markdown", &o.markdown, "", Range::any, "print the table as docs/methods.md has it", "", "Output"},
  };
}

}  // namespace cromer::core
