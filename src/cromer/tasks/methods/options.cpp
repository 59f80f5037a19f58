#include "cromer/tasks/methods/method_options.h"
#include "cromer/tasks/methods/methods.h"

namespace cromer::core {

std::vector<Option> options_of(MethodsOptions& o) {
  constexpr std::string_view group = "What each method really simulates";
  return {
      {"natural-frequency", &o.natural_frequency, "rad/s", Range::positive,
       "natural frequency of the oscillator", "", group},
      {"damping-ratio", &o.damping_ratio, "", Range::not_negative, "damping ratio of the oscillator", "0",
       group},
      {"step", &o.step, "s", Range::positive, "time step", "", group},
      beta_option(o.beta, group),
      gamma_option(o.gamma, group),
      rho_inf_option(o.rho_inf, group),
      {"markdown", &o.markdown, "", Range::any, "print the table as docs/methods.md has it", "", "Output"},
  };
}

}  // namespace cromer::core
