#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/documents/described/spectrum.h"
#include "cromer/documents/text.h"
#include "cromer/study/collect.h"

namespace cromer::core {
namespace {

/// The index of the largest value. NaN is passed over.
std::size_t largest(const std::vector<double>& values) {
  std::size_t at = 0;
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] > values[at] || std::isnan(values[at])) at = i;
  return at;
}

}  // namespace

void collect(const std::string& id, const ResonanceResult& resonance, Results& results) {
  const char* arrives = resonance.of_motion ? "m" : "N";
  results.set(id + ".points", static_cast<double>(resonance.curves.front().frequency.size()));
  for (std::size_t i = 0; i < resonance.curves.size(); ++i) {
    const ResonanceCurve& curve = resonance.curves[i];
    const std::string name = id + "." + std::to_string(i + 1);
    const std::size_t peak = largest(curve.amplitude), most = largest(curve.transmissibility);
    results.set(name + ".label", curve.method);
    results.set(name + ".damping_ratio", curve.damping_ratio);
    results.set(name + ".peak", curve.amplitude[peak], "m");
    results.set(name + ".peak_frequency", curve.frequency[peak], "rad/s");
    results.set(name + ".peak_transmissibility", curve.transmissibility[most]);
    results.set(name + ".peak_transmissibility_ratio", curve.frequency_ratio[most]);
    results.set(name + ".last_transmissibility", curve.transmissibility.back());
    results.set(name + ".peak_transmitted", curve.transmitted[largest(curve.transmitted)], arrives);
    results.set(name + ".last_transmitted", curve.transmitted.back(), arrives);
    results.set_column(name + ".frequency", curve.frequency, "rad/s", "drive frequency *ω*");
    results.set_column(name + ".frequency_ratio", curve.frequency_ratio, "", "frequency ratio *ω*/*ω*_{0}");
    results.set_column(name + ".amplitude", curve.amplitude, "m", "steady amplitude");
    results.set_column(name + ".phase", curve.phase, "rad", "phase lag *φ*");
    results.set_column(name + ".amplification", curve.amplification, "", "amplification");
    results.set_column(name + ".transmissibility", curve.transmissibility, "", "transmissibility");
    results.set_column(name + ".transmitted_phase", curve.transmitted_phase, "rad", "phase lag *φ*");
    results.set_column(name + ".transmitted", curve.transmitted, arrives,
                       resonance.of_motion ? "amplitude of the mass" : "force on the ground");
  }
}

void collect(const std::string& id, const LocalErrorResult& errors, Results& results) {
  for (std::size_t i = 0; i < errors.curves.size(); ++i) {
    const LocalErrorCurve& curve = errors.curves[i];
    const std::string name = id + "." + std::to_string(i + 1);
    results.set(name + ".label", curve.method);
    results.set(name + ".x_slope", curve.x_slope);
    results.set(name + ".v_slope", curve.v_slope);
    results.set(name + ".x_over_predicted", curve.x_over_predicted);
    results.set(name + ".v_over_predicted", curve.v_over_predicted);
    results.set_column(name + ".h", curve.h, "s", "step *h*");
    results.set_column(name + ".x_error", curve.x_error, "m", "error of position");
    results.set_column(name + ".v_error", curve.v_error, "m/s", "error of velocity");
  }
}

void collect(const std::string& id, const MethodMapResult& map, Results& results) {
  results.set(id + ".natural_frequency", map.natural_frequency, "rad/s");
  results.set(id + ".decay_rate", map.decay_rate, "1/s");
  for (std::size_t i = 0; i < map.curves.size(); ++i) {
    const MethodMapCurve& curve = map.curves[i];
    const std::string name = id + "." + std::to_string(i + 1);
    results.set(name + ".label", curve.method);
    if (curve.order > 0)
      results.set(name + ".order", static_cast<double>(curve.order));
    else
      results.set(name + ".order", std::string("–"));
    results.set(name + ".at_a_tenth.decay_rate", curve.at_a_tenth.decay_rate, "1/s");
    results.set(name + ".at_a_tenth.frequency_error", curve.at_a_tenth.frequency_error);
    results.set(name + ".at_a_tenth.energy_factor", curve.at_a_tenth.energy_factor);
    if (curve.stable_up_to)
      results.set(name + ".stable_up_to", *curve.stable_up_to);
    else
      results.set(name + ".stable_up_to", std::string("any"));
    const auto column = [&](double MethodMapPoint::*which) {
      std::vector<double> values;
      for (const MethodMapPoint& point : curve.at) values.push_back(point.*which);
      return values;
    };
    results.set_column(name + ".wh", curve.wh, "", "natural frequency × step *ω*_{0}*h*");
    results.set_column(name + ".decay_rate", column(&MethodMapPoint::decay_rate), "1/s", "decay rate");
    results.set_column(name + ".frequency_error", column(&MethodMapPoint::frequency_error), "",
                       "frequency error");
    results.set_column(name + ".decay_error", column(&MethodMapPoint::decay_error), "", "damping error");
  }
}

void collect(const std::string& id, const WorkPrecisionResult& work, Results& results) {
  for (std::size_t i = 0; i < work.curves.size(); ++i) {
    const WorkPrecisionCurve& curve = work.curves[i];
    const std::string name = id + "." + std::to_string(i + 1);
    results.set(name + ".label", curve.method);
    results.set(name + ".slope", curve.slope);
    results.set_column(name + ".evaluations", curve.evaluations, "", "evaluations");
    results.set_column(name + ".error", curve.error, "", "error");
    constexpr double not_reached = std::numeric_limits<double>::quiet_NaN();
    results.set(name + ".evaluations_for_a_millionth", not_reached);
    // Evaluations for an error of 1e-6, interpolated between the two runs around it, both on logarithmic
    // scales.
    for (std::size_t j = 1; j < curve.error.size(); ++j)
      if (curve.error[j - 1] > 1e-6 && curve.error[j] <= 1e-6) {
        const double share =
            std::log(1e-6 / curve.error[j - 1]) / std::log(curve.error[j] / curve.error[j - 1]);
        results.set(
            name + ".evaluations_for_a_millionth",
            curve.evaluations[j - 1] * std::pow(curve.evaluations[j] / curve.evaluations[j - 1], share));
        break;
      }
  }
}

namespace {

/// Sets the columns SD, PSV and PSA; `which` follows their names. Returns the pseudo-accelerations.
std::vector<double> set_spectral(const std::string& name, const std::string& which, const SpectrumResult& all,
                                 const std::vector<double>& displacement, Results& results) {
  std::vector<double> velocity, acceleration;
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    velocity.push_back(pseudo_velocity(displacement[i], all.periods[i]));
    acceleration.push_back(pseudo_acceleration(displacement[i], all.periods[i]));
  }
  results.set_column(name + ".SD" + which, displacement, "m", "displacement");
  results.set_column(name + ".PSV" + which, velocity, "m/s", "pseudo-velocity");
  results.set_column(name + ".PSA" + which, acceleration, "m/s²", "pseudo-acceleration");
  return acceleration;
}

/// Results are in SI, whatever unit the spectrum is written in.
std::string shock_unit_of(const SpectrumResult& all) {
  return shock_is_acceleration(all) ? "m/s²" : std::string(shock_unit(all));
}

/// Sets the columns of a shock spectrum. Returns the maximax.
std::vector<double> set_shock(const std::string& name, const SpectrumResult& all,
                              const ResponseSpectrum& spectrum, Results& results) {
  const auto set = [&](const char* which, auto value) {
    std::vector<double> column;
    for (const Shock& shock : spectrum.shock) column.push_back(value(shock));
    results.set_column(name + "." + which, column, shock_unit_of(all),
                       "largest " + readable_response(all.shock_of));
    return column;
  };
  set("primary", [](const Shock& s) { return s.primary; });
  set("residual", [](const Shock& s) { return s.residual; });
  set("positive", [](const Shock& s) { return s.positive; });
  set("negative", [](const Shock& s) { return s.negative; });
  return set("maximax", [](const Shock& s) { return s.maximax(); });
}

}  // namespace

void collect(const std::string& id, const SpectrumResult& all, Results& results) {
  const Component& component = all.components.front();
  results.set(id + ".peak_acceleration", component.peak, "m/s²");
  results.set(id + ".peak_velocity", component.path.peak_velocity, "m/s");
  results.set(id + ".peak_displacement", component.path.peak_displacement, "m");
  results.set(id + ".cumulative_absolute_velocity", component.absolute_velocity, "m/s");
  results.set(id + ".arias_intensity", component.intensity.arias, "m/s");
  results.set(id + ".duration_5_75", component.intensity.duration_75, "s");
  results.set(id + ".duration_5_95", component.intensity.duration, "s");
  results.set(id + ".duration_bracketed", component.bracketed_duration, "s");
  std::vector<double> frequencies;
  for (const double period : all.periods) frequencies.push_back(1 / period);
  for (std::size_t n = 0; n < all.spectra.size(); ++n) {
    const ResponseSpectrum& spectrum = all.spectra[n];
    const std::string name = id + "." + std::to_string(n + 1);
    results.set(name + (all.hysteretic() ? ".loss_factor" : ".damping_ratio"), spectrum.damping_ratio);
    if (all.inelastic()) results.set(name + ".ductility", spectrum.ductility);
    results.set_column(name + ".period", all.periods, "s", "period *T*");
    results.set_column(name + ".frequency", frequencies, "Hz", "natural frequency");
    std::vector<double> values;
    if (!spectrum.shock.empty()) {
      values = set_shock(name, all, spectrum, results);
    } else if (spectrum.displacement.size() == 1) {
      values = set_spectral(name, "", all, spectrum.displacement[0], results);
    } else {
      set_spectral(name, "_1", all, spectrum.displacement[0], results);
      set_spectral(name, "_2", all, spectrum.displacement[1], results);
      set_spectral(name, "_geometric_mean", all, spectrum.geometric_mean, results);
      set_spectral(name, "_RotD100", all, spectrum.rotd100, results);
      values = set_spectral(name, "", all, spectrum.rotd50, results);
    }
    const auto top = std::max_element(values.begin(), values.end());
    results.set(name + ".peak", *top, spectrum.shock.empty() ? "m/s²" : shock_unit_of(all));
    results.set(name + ".peak_period", all.periods[static_cast<std::size_t>(top - values.begin())], "s");
  }
}

}  // namespace cromer::core
