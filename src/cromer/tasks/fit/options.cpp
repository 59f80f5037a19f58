#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {
namespace {

// The terms as the registry has them.
std::string_view law_help() {
  static const std::string text = "auto, or a sum of " + law_names() + " (of an angle)";
  return text;
}

}  // namespace

std::vector<Option> options_of(ReadOptions& o) {
  constexpr std::string_view file = "Reading the file";
  return {
      {"rate", &o.rate, "Hz", Range::sampling_rate,
       "samples per second, 1e-6 to 1e12, for files without time", "from the time column", file},
      {"time-column", &o.time_column, "", Range::any, "name of the time column", "found", file},
      {"delimiter", &o.delimiter, "", Range::any, "\",\", \";\", tab or blank", "found", file},
      {"decimal", &o.decimal, "", Range::any, "decimal mark, \".\" or \",\"", "found", file},
      {"skip-bad-rows", &o.skip_bad_rows, "", Range::any, "leave out rows with a word in a number column",
       "such a row is an error", file},
  };
}

std::vector<Option> options_of(FitOptions& o) {
  constexpr std::string_view samples = "Which samples";
  constexpr std::string_view model = "The law and what is known about the apparatus";
  constexpr std::string_view driven = "What drives it";
  constexpr std::string_view more = "What else to say";
  std::vector<Option> options = {
      {"column", &o.column, "", Range::any, "column to fit",
       "a position, else angle, angular velocity, velocity, acceleration", samples},
      {"run", &o.run, "", Range::positive, "which run of the file, from 1", "all runs", samples},
      {"from", &o.from, "s", Range::any, "first time used", "the first sample", samples},
      {"to", &o.to, "s", Range::any, "last time used", "the last sample", samples},
      {"law", &o.law, "", Range::any, law_help(), "auto", model},
      {"no-spring", &o.no_spring, "", Range::any, "a body without a spring, under a recorded force",
       "a linear spring", model},
      {"hysteresis-exponent", &o.hysteresis_exponent, "", Range::at_least_one,
       "n of a hysteretic law: beta |x'| |z|^(n-1) z, gamma x' |z|^n", "1", model},
      {"mass", &o.mass, "kg", Range::positive,
       "oscillating mass, for the spring constant; \"94.72 g, 55.19 g\": one for each run or recording",
       "none", model, nullptr, 10},
      {"spring-mass", &o.spring_mass, "kg", Range::not_negative, "mass of the spring; a third of it is added",
       "0", model, nullptr, 1},
      {"disc-diameter", &o.disc_diameter, "m", Range::positive, "diameter of a disc, for the Reynolds number",
       "none", model, nullptr, 1},
      {"temperature", &o.temperature, "K", Range::air_temperature,
       "temperature of the air, for its density and viscosity", "20 °C", model},
      {"segment", &o.segment, "s", Range::positive, "decay rate per segment of this length", "none", model},
      {"segments", &o.segments, "", Range::positive,
       "at most this many segments; without --segment, this many equal parts", "all whole ones", model},
      {"force-column", &o.force_column, "", Range::any, "column of a recorded force that drives it",
       "the motion is free", driven},
      {"between-samples", &o.between_samples, "", Range::any,
       "what the force did between its samples: linear, hold, band-limited, or auto for what the data prefer",
       "auto", driven},
      {"drive-frequency", &o.drive_frequency, "rad/s", Range::any,
       "rough frequency of a harmonic drive, \"1.2 Hz\" (the fit refines it), or auto to find it",
       "the motion is free", driven},
      {"hold-out", &o.hold_out, "1", Range::fraction,
       "share of the samples, the last ones, to test the law on instead of fitting it to them", "none",
       driven},
      {"goal", &o.goal, "", Range::any,
       "how long to record to know a quantity this well, \"decay_rate 0.5 %\"", "none", more},
      {"monte-carlo", &o.monte_carlo, "", Range::trials,
       "check the spring constant's uncertainty by this many trials (1000 to 10000000)", "none", more},
      {"seed", &o.seed, "", Range::any, "seed of the trials", "1", more, &o.seed_given},
      {"textbook", &o.textbook, "", Range::any,
       "logarithmic decrement from peaks and half-power bandwidth beside the fit", "not shown", more},
  };
  const auto reading = options_of(o.read);
  options.insert(options.end(), reading.begin(), reading.end());
  return options;
}

}  // namespace cromer::core
