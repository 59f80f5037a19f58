#include "cromer/tasks/methods/method_options.h"
#include "cromer/tasks/modes/modes_options.h"

namespace cromer::core {

std::vector<Option> options_of(ModesOptions& o) {
  constexpr std::string_view group = "What a method really simulates of each mode";
  constexpr std::string_view recording = "Modes of a recording";
  std::vector<Option> options = {
      {"method", &o.method, "", Range::any, "a name from `cromer methods`; may be given several times",
       "none", group},
      {"step", &o.step, "s", Range::positive, "time step of the methods", "", group},
      beta_option(o.beta, group),
      gamma_option(o.gamma, group),
      rho_inf_option(o.rho_inf, group),
      {"run", &o.run, "", Range::positive, "which of several runs in the file", "the only one", recording},
      {"from", &o.from, "s", Range::any, "first time used", "the first sample", recording},
      {"to", &o.to, "s", Range::any, "last time used", "the last sample", recording},
      {"modes", &o.modes, "", Range::at_least_one,
       "how many at most: those found at most orders of the model", "all that are found", recording},
      {"from-frequency", &o.from_frequency, "rad/s", Range::not_negative, "only modes from this frequency on",
       "0", recording},
      {"to-frequency", &o.to_frequency, "rad/s", Range::positive, "only modes up to this frequency",
       "half the rate", recording},
      {"of-method", &o.of_method, "", Range::any,
       "the recording was simulated by this method with this --step: its share is taken out", "none",
       recording},
  };
  for (const Option& option : options_of(o.read)) options.push_back(option);
  return options;
}

}  // namespace cromer::core
