#include "cromer/tasks/fit/spring_options.h"

namespace cromer::core {

std::vector<Option> options_of(SpringOptions& o) {
  constexpr std::string_view group = "The spring constant from several masses";
  return {
      {"static", &o.held, "", Range::any,
       "from held extensions: a run, file or plateau for each of --masses, at rest", "the law of a swing",
       group},
      {"mass-line", &o.mass_line, "", Range::any,
       "from the periods: T² against --masses, one for each recording and run; also the spring's own mass",
       "each by itself", group},
      {"masses", &o.masses, "kg", Range::not_negative,
       "\"48.4 g, 67.95 g, 87.96 g\", in the order of the recordings", "none", group, nullptr, 10},
      {"gravity", &o.gravity, "m/s^2", Range::positive, "local acceleration of free fall, for --static",
       "9.80665 m/s²", group},
  };
}

StaticOptions static_options(const FitOptions& fit, const SpringOptions& spring) {
  StaticOptions options{.fit = fit, .masses = spring.masses};
  if (spring.gravity) options.gravity = *spring.gravity;
  return options;
}

Result<void> check_spring_options(const SpringOptions& options, bool only_held) {
  if (options.held && options.mass_line) return Error{"static_or_mass_line"};
  const char* way = options.held ? "static" : "mass-line";
  if (!options.held && options.gravity) return Error{"gravity_without_static"};
  if (!options.any())
    return options.masses.empty() ? Result<void>{}
                                  : Error{only_held ? "masses_without_static" : "masses_without_line"};
  if (options.masses.empty()) return Error{"masses_needed", {{"way", way}}};
  if (options.masses.size() < 2) return Error{"two_masses_needed", {{"way", way}}};
  return {};
}

}  // namespace cromer::core
