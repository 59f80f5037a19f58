#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "cromer/model/terms/all.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/sweep/loss_factor.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {
namespace {

/// What a sweep takes of simulate: a grid, as the terms' coefficients do, or as it is.
constexpr std::string_view with_grid[] = {"mass",
                                          "static-friction",
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
                                          "until",
                                          "tolerance",
                                          "beta",
                                          "gamma",
                                          "rho-inf"};
constexpr std::string_view as_it_is[] = {"drive", "method"};

/// Options of simulate that would change nothing of a sweep's rows, or have no sense in it.
struct LeftOut {
  std::string_view name, why;
};
constexpr std::string_view drives_end =
    "a sweep takes drives that go on (harmonic, unbalance, base); run pulses and chirps with simulate";
constexpr std::string_view no_records =
    "a sweep takes drives that go on (harmonic, unbalance, base); run recorded ones with simulate";
constexpr std::string_view no_sensor =
    "a sweep measures the motion itself, not a sensor's samples; leave it out, or take simulate";
constexpr LeftOut left_out[] = {
    {"drive-to", drives_end},
    {"drive-start", drives_end},
    {"drive-duration", drives_end},
    {"drive-file", no_records},
    {"base-motion", no_records},
    {"drive-column", no_records},
    {"between-samples", no_records},
    {"accuracy", "a sweep takes the step itself, which may be a grid: --step 0.001:0.1:20:log"},
    {"event", "a sweep measures whole runs; look for events with simulate"},
    {"every", "a sweep keeps measures and no states, so there is nothing to thin out; leave it out"},
    {"compensated", "a sweep's runs are too short to need it; take simulate for millions of steps"},
    {"sensor-noise", no_sensor},
    {"sensor-resolution", no_sensor},
    {"sensor-offset", no_sensor},
    {"seed", no_sensor},
};

template <std::size_t n>
bool is_in(const std::string_view (&names)[n], std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// Whether the option is a coefficient of a term with an inner state, or of one without.
template <bool with_inner_state>
bool is_coefficient(std::string_view name) {
  bool found = with_inner_state && name == "hysteresis-exponent";
  for_each_term([&]<class T>() {
    if constexpr (HasInnerState<T> == with_inner_state)
      for (const CoefficientInfo& each : T::coefficients) found = found || each.option == name;
  });
  return found;
}

}  // namespace

std::string sweep_refusal(std::string_view option, std::string_view text) {
  for (const LeftOut& each : left_out)
    if (each.name == option) return fmt::format("--{}: {}", option, each.why);
  if (is_coefficient<true>(option))
    return fmt::format(
        "--{}: a sweep steps position and velocity alone, not a force with memory; run it with simulate, "
        "once "
        "for each value",
        option);
  const bool of_all = option == "settle" || option == "threads";
  if (of_all && text.find_first_of(",:") != std::string_view::npos)
    return fmt::format("--{}: \"{}\" looks like a grid, and this is one number for all points{}", option,
                       text, option == "settle" ? "; it says how they are found, not what they are" : "");
  return "";
}

std::vector<Option> options_of(SweepOptions& o) {
  constexpr std::string_view sweep = "Sweep";
  std::vector<Option> options;
  for (Option option : point_options(o.simulate)) {
    if (is_in(with_grid, option.name) || is_coefficient<false>(option.name)) {
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
        "amplitude, phase (lag behind the force), peak (largest |x|), mean and rms (of x over whole "
        "cycles), energy (likewise, or at the end), final (x and v); several with commas",
        "amplitude,phase of the settled motion; without a drive peak,final,energy", sweep},
       {"settle", &o.settle, "", Range::not_negative, "cycles of the drive that are dropped",
        "found out: until the changes still to come are below 1e-6", sweep},
       {"direction", &o.direction, "", Range::any,
        "up, down or both: each point starts where the one before ended (hysteresis)", "each point by itself",
        sweep},
       {"threads", &o.threads, "", Range::positive, "how many work at once", "one for each processor", sweep},
       {"check", &o.check, "", Range::any,
        "where the answer is a closed form, step eight points as well and say how far they differ", "",
        sweep}});
  return options;
}

}  // namespace cromer::core
