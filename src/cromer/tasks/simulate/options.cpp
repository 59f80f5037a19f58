#include <algorithm>
#include <array>
#include <string>
#include <type_traits>

#include "cromer/model/terms/all.h"
#include "cromer/model/terms/term.h"
#include "cromer/tasks/methods/method_options.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

namespace {

/// "Law of motion: m x'' = F(t) - k x - c x' ...", each term as its header writes it. The rate of an inner
/// state, behind a comma in the formula, goes to the end.
std::string law_in_words() {
  std::string sum = "Law of motion: m x'' = F(t)", rates;
  for (const TermInfo& term : term_infos) {
    const std::size_t comma = term.formula.find(", ");
    sum.append(" - ").append(term.formula.substr(0, comma));
    if (comma != std::string_view::npos) rates.append("; ").append(term.formula.substr(comma + 2));
  }
  return sum + rates;
}

Range range_of(Sign sign) { return sign == Sign::not_negative ? Range::not_negative : Range::any; }

/// The coefficients of the law's terms, each an option.
std::vector<Option> coefficients(SimulateOptions& o, std::string_view group) {
  std::vector<Option> options;
  for_each_term([&]<class T>() {
    static const auto units = [] {
      std::array<std::string, coefficients_of<T>> all;
      for (std::size_t i = 0; i < all.size(); ++i) all[i] = unit_of(T::coefficients[i]);
      return all;
    }();
    for (std::size_t i = 0; i < coefficients_of<T>; ++i) {
      const CoefficientInfo& info = T::coefficients[i];
      const auto member = T::template members<double>[i];
      Option::Target target = &(o.law.*member);
      // These two have other options as well: not given differs from 0.
      if (member == &Oscillator<double>::stiffness) target = &o.stiffness;
      if (member == &Oscillator<double>::damping) target = &o.damping;
      options.push_back({info.option, target, units[i], range_of(info.sign), info.meaning,
                         member == &Oscillator<double>::stiffness ? "1 N/m" : "0", group});
    }
    if constexpr (std::is_same_v<T, Friction>)
      options.push_back({"static-friction", &o.static_friction, "N", Range::not_negative,
                         "largest force that dry friction holds at rest, at least --friction",
                         "as --friction", group});
    if constexpr (std::is_same_v<T, Hysteresis>)
      options.push_back({"hysteresis-exponent", &o.law.hysteresis_exponent, "", Range::at_least_one,
                         "how sharply it gives way, n of beta |x'| |z|^(n-1) z + gamma x' |z|^n", "1",
                         group});
  });
  return options;
}

}  // namespace

std::vector<Option> options_of(SimulateOptions& o) {
  static const std::string words = law_in_words();
  const std::string_view law = words;
  constexpr std::string_view start = "Start";
  constexpr std::string_view drive = "Drive F(t): harmonic, F cos(w t + phi), or another";
  constexpr std::string_view recorded = "Recorded drive";
  constexpr std::string_view integration = "Integration";
  constexpr std::string_view sensor = "Simulated motion sensor: -o then writes what a logger would";
  std::vector<Option> options{
      {"mass", &o.mass, "kg", Range::positive, "mass m", "1 kg", law},
      {"natural-frequency", &o.natural_frequency, "rad/s", Range::positive,
       "in place of stiffness: k = m w0^2", "", law},
      {"damping-ratio", &o.damping_ratio, "1", Range::not_negative,
       "in place of damping: c = 2 zeta sqrt(k m)", "", law},
      {"quality-factor", &o.quality_factor, "1", Range::positive, "in place of damping: c = sqrt(k m) / Q",
       "", law},
      {"position", &o.position, "m", Range::any, "displacement at the start",
       "1 m when nothing else sets the motion going, else 0", start},
      {"velocity", &o.velocity, "m/s", Range::any, "velocity at the start", "0", start},
      {"drive", &o.drive, "", Range::any,
       "harmonic, step, rectangular, half-sine, triangular (pulses), chirp (linear sweep), "
       "logarithmic-chirp, "
       "unbalance (rotating, m_u e w^2), base (shaking: Y cos(w t + phi), x relative to it)",
       "harmonic", drive},
      {"drive-amplitude", &o.drive_amplitude, "N", Range::not_negative,
       "amplitude F of the driving force, or height of a pulse", "0: none", drive},
      {"drive-frequency", &o.drive_frequency, "rad/s", Range::not_negative,
       "its angular frequency w, of a chirp at its start; may be given several times", "none", drive},
      {"drive-phase", &o.drive_phase, "rad", Range::any, "its phase phi at t = 0, of a chirp at its start",
       "0", drive},
      {"drive-to", &o.drive_to, "rad/s", Range::not_negative, "angular frequency where a chirp ends", "",
       drive},
      {"drive-start", &o.drive_start, "s", Range::not_negative, "when a pulse or chirp begins", "0", drive},
      {"drive-duration", &o.drive_duration, "s", Range::positive, "how long a pulse or chirp lasts",
       "a chirp: to the end of the run", drive},
      {"unbalance-mass", &o.unbalance_mass, "kg", Range::positive, "rotating mass m_u, part of --mass", "",
       drive},
      {"eccentricity", &o.eccentricity, "m", Range::positive, "its distance e from the axis", "", drive},
      {"base-displacement", &o.base_displacement, "m", Range::positive, "amplitude Y of a shaking base", "",
       drive},
      {"drive-file", &o.drive_file, "", Range::any, "file with a recorded force: time and force", "none",
       recorded},
      {"base-motion", &o.base_motion, "", Range::any,
       "file with the ground's recorded acceleration; x is then relative to the ground", "none", recorded},
      {"drive-column", &o.drive_column, "", Range::any, "column of that file", "the force or acceleration",
       recorded},
      {"between-samples", &o.between_samples, "", Range::any,
       "linear, hold, or band-limited (windowed sinc, 16 points for each, then linear)", "linear", recorded},
      {"method", &o.method, "", Range::any, "a name from `cromer methods`; may be given several times",
       "euler-cromer", integration},
      {"step", &o.step, "s", Range::positive, "time step; of an adaptive method the spacing of its states",
       "1/200 of the shorter of natural and drive period (or pulse); of a recorded drive a whole part of its "
       "spacing",
       integration},
      {"until", &o.until, "s", Range::positive, "end of the run",
       "20 natural periods (of the drive where the law has none), at least to the end of a pulse or chirp; "
       "the length of a recorded drive",
       integration},
      {"tolerance", &o.tolerance, "1", Range::tolerance,
       "bound on Newton's last update or on the error of an adaptive method's step, relative to the motion's "
       "scale; 1e-15 to 1e-2",
       "1e-12; adaptive 1e-9", integration},
      {"accuracy", &o.accuracy, "", Range::accuracy,
       "in place of step: the largest step that keeps frequency, decay and amplitude right to this relative "
       "error; 1e-9 to 0.5 (\"0.1 %\")",
       "", integration},
      {"event", &o.event, "", Range::any,
       "report when it happens: position=VALUE, velocity=VALUE or turning-point, then any of :rising, "
       ":falling, :stop; may be given several times",
       "none", integration},
      beta_option(o.beta, integration),
      gamma_option(o.gamma, integration),
      rho_inf_option(o.rho_inf, integration),
      {"every", &o.every, "", Range::positive, "keep every Nth state", "1", integration},
      {"compensated", &o.compensated, "", Range::any,
       "carry along what the sums of a fixed-step method round off, for runs of millions of steps", "",
       integration},
      {"sensor-noise", &o.sensor.noise, "m", Range::not_negative, "standard deviation of the noise", "0",
       sensor, &o.sensor.used},
      {"sensor-resolution", &o.sensor.resolution, "m", Range::not_negative, "rounding step", "0: not rounded",
       sensor, &o.sensor.used},
      {"sensor-offset", &o.sensor.offset, "m", Range::any, "reading at x = 0", "0", sensor, &o.sensor.used},
      {"seed", &o.sensor.seed, "", Range::any,
       "seed of the noise; the same seed gives the same samples everywhere", "1", sensor, &o.sensor.used},
  };
  const auto terms = coefficients(o, law);
  options.insert(options.begin() + 1, terms.begin(), terms.end());
  const auto after_recorded = std::find_if(options.begin(), options.end(),
                                           [&](const Option& each) { return each.group == integration; });
  const auto reading = options_of(o.read);
  options.insert(after_recorded, reading.begin(), reading.end());
  return options;
}

}  // namespace cromer::core
