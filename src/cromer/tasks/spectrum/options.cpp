#include "cromer/tasks/option/option.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

std::vector<Option> options_of(SpectrumOptions& o) {
  constexpr std::string_view oscillators =
      "Which oscillators: a list, low:high:points or low:high:points:log";
  constexpr std::string_view what = "What to compute";
  constexpr std::string_view recording = "The recording";
  std::vector<Option> options{
      {"periods", &o.periods, "s", Range::any, "natural periods, \"0.01:10:200:log\", \"20,50,100 ms\"",
       "0.01:10:200:log; of a shock, frequencies that suit it", oscillators},
      {"frequencies", &o.frequencies, "rad/s", Range::any,
       "natural frequencies instead of periods, \"1:1000:200:log Hz\"", "", oscillators},
      {"damping-ratio", &o.damping_ratio, "1", Range::any, "damping ratios; may be given several times",
       "0.05", oscillators},
      {"loss-factor", &o.loss_factor, "1", Range::any,
       "hysteretic damping k (1 + i eta) instead of viscous damping, as a sum of steady states", "",
       oscillators},
      {"ductility", &o.ductility, "1", Range::any,
       "inelastic spectrum of springs that yield, of this ductility: SD, PSV and PSA of yielding; may be "
       "given "
       "several times",
       "elastic springs", oscillators},
      {"peaks", &o.peaks, "", Range::any,
       "where the largest values are looked for: continuous (everywhere, after the recording's end too), "
       "samples (at the samples alone) or peer (at ten points a period at least, straight lines between "
       "samples)",
       "continuous", what},
      {"between-samples", &o.between_samples, "", Range::any,
       "linear, hold, or band-limited (windowed sinc, 16 points for each, then linear)", "linear", what},
      {"shock", &o.shock, "", Range::any,
       "shock response spectrum (ISO 18431-4): primary, residual, maximax, positive, negative",
       "relative displacement", what},
      {"shock-response", &o.shock_response, "", Range::any,
       "of which response: absolute-acceleration, relative-velocity, relative-displacement, pseudo-velocity "
       "or "
       "equivalent-static-acceleration",
       "absolute-acceleration", what},
      {"baseline", &o.baseline, "", Range::any,
       "take off the polynomial of least squares: constant, linear, quadratic or cubic", "none", what},
      {"band-pass", &o.band_pass, "", Range::any,
       "Butterworth filter, after the baseline: \"0.1:25 Hz\", or one corner, \"0.1 Hz:\", \":25 Hz\"",
       "none", what},
      {"band-pass-order", &o.band_pass_order, "", Range::positive, "its order, to 12", "4", what},
      {"causal", &o.causal, "", Range::any, "filter forwards alone", "forwards and backwards: no phase shift",
       what},
      {"in-g", &o.in_g, "", Range::any, "write accelerations in g (9.80665 m/s^2)", "m/s^2", what},
      {"column", &o.column, "", Range::any, "the acceleration; twice for two components in one file",
       "the only one", recording},
      {"run", &o.run, "", Range::positive, "which run of the file, from 1", "the first", recording},
      {"unit", &o.unit, "", Range::any,
       "unit of the acceleration where the file gives none: g, m/s^2, cm/s^2", "m/s^2", recording},
  };
  const auto read = options_of(o.read);
  options.insert(options.end(), read.begin(), read.end());
  return options;
}

}  // namespace cromer::core
