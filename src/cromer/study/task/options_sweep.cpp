#include <algorithm>
#include <variant>

#include "cromer/study/task/loss_factor.h"
#include "cromer/study/task/option.h"
#include "cromer/study/task/sweep.h"

namespace cromer {
namespace {

/// What a sweep takes of simulate: a grid, or as it is.
constexpr std::string_view with_grid[] = {"mass",
                                          "stiffness",
                                          "damping",
                                          "drag",
                                          "friction",
                                          "static-friction",
                                          "cubic",
                                          "natural-frequency",
                                          "damping-ratio",
                                          "quality-factor",
                                          "loss-factor",
                                          "position",
                                          "velocity",
                                          "drive-amplitude",
                                          "drive-frequency",
                                          "drive-phase",
                                          "unbalance-mass",
                                          "eccentricity",
                                          "base-displacement",
                                          "step",
                                          "until"};
constexpr std::string_view as_it_is[] = {"drive", "method", "tolerance", "beta", "gamma", "rho-inf"};

template <std::size_t n>
bool is_in(const std::string_view (&names)[n], std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

}  // namespace

std::vector<Option> options_of(SweepOptions& o) {
  constexpr std::string_view sweep = "Sweep";
  std::vector<Option> options;
  for (Option option : point_options(o.simulate)) {
    if (is_in(with_grid, option.name)) {
      option.target = &o.values[option.name];
      options.push_back(option);
    } else if (is_in(as_it_is, option.name)) {
      if (option.name == "drive") option.help = "harmonic, unbalance (rotating, m_u e w^2) or base (shaking)";
      options.push_back(option);
    }
  }
  options.insert(
      options.end(),
      {{"measure", &o.measure, "", Range::any,
        "amplitude, phase (lag behind the force), peak (largest |x|), final (x and v), energy; several with "
        "commas",
        "amplitude,phase of the settled motion; without a drive peak,final,energy", sweep},
       {"settle", &o.settle, "", Range::not_negative, "cycles of the drive that are dropped",
        "found out: until the changes still to come are below 1e-6", sweep},
       {"direction", &o.direction, "", Range::any,
        "up or down: each point starts where the one before ended (hysteresis)", "each point by itself",
        sweep},
       {"threads", &o.threads, "", Range::positive, "how many work at once", "one for each processor", sweep},
       {"check", &o.check, "", Range::any,
        "where the answer is a closed form, step eight points as well and say how far they differ", "",
        sweep}});
  return options;
}

}  // namespace cromer
