#include <algorithm>

#include "cromer/study/collect.h"

namespace cromer::core {
namespace {

/// SD, PSV and PSA at the periods, as columns whose names end with `which`; the pseudo-accelerations.
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

std::vector<double> set_shock(const std::string& name, const ResponseSpectrum& spectrum, Results& results) {
  const auto set = [&](const char* which, auto value) {
    std::vector<double> column;
    for (const Shock& shock : spectrum.shock) column.push_back(value(shock));
    results.set_column(name + "." + which, column, "m/s²", "largest acceleration");
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
  results.set(id + ".arias_intensity", component.intensity.arias, "m/s");
  results.set(id + ".duration_5_95", component.intensity.duration, "s");
  std::vector<double> frequencies;
  for (const double period : all.periods) frequencies.push_back(1 / period);
  for (std::size_t n = 0; n < all.spectra.size(); ++n) {
    const ResponseSpectrum& spectrum = all.spectra[n];
    const std::string name = id + "." + std::to_string(n + 1);
    results.set(name + (all.hysteretic() ? ".loss_factor" : ".damping_ratio"), spectrum.damping_ratio);
    results.set_column(name + ".period", all.periods, "s", "period *T*");
    results.set_column(name + ".frequency", frequencies, "Hz", "natural frequency");
    std::vector<double> values;
    if (!spectrum.shock.empty()) {
      values = set_shock(name, spectrum, results);
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
    results.set(name + ".peak", *top, "m/s²");
    results.set(name + ".peak_period", all.periods[static_cast<std::size_t>(top - values.begin())], "s");
  }
}

}  // namespace cromer::core
