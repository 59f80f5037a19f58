#include "cromer/documents/json/documents.h"
#include "cromer/documents/json/json.h"
#include "cromer/documents/json/notices.h"

namespace cromer::core {
namespace {

Json spectral_values(const SpectrumResult& result, const std::vector<double>& displacement) {
  const double unit = result.options.in_g ? standard_gravity : 1;
  Json velocity = Json::array(), acceleration = Json::array();
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    velocity.push_back(pseudo_velocity(displacement[i], result.periods[i]));
    acceleration.push_back(pseudo_acceleration(displacement[i], result.periods[i]) / unit);
  }
  return {{"SD", displacement}, {"PSV", velocity}, {"PSA", acceleration}};
}

Json shock_values(const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  const double unit = result.options.in_g ? standard_gravity : 1;
  Json values{{"primary", Json::array()},
              {"residual", Json::array()},
              {"maximax", Json::array()},
              {"positive", Json::array()},
              {"negative", Json::array()}};
  for (const Shock& shock : spectrum.shock) {
    values["primary"].push_back(shock.primary / unit);
    values["residual"].push_back(shock.residual / unit);
    values["maximax"].push_back(shock.maximax() / unit);
    values["positive"].push_back(shock.positive / unit);
    values["negative"].push_back(shock.negative / unit);
  }
  return values;
}

Json spectrum_object(const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  Json object{{result.hysteretic() ? "loss_factor" : "damping_ratio", spectrum.damping_ratio},
              {"period", result.periods}};
  if (!spectrum.shock.empty()) {
    object.update(shock_values(result, spectrum));
  } else if (spectrum.displacement.size() == 1) {
    object.update(spectral_values(result, spectrum.displacement[0]));
  } else {
    Json& components = object["components"] = Json::array();
    for (const auto& displacement : spectrum.displacement)
      components.push_back(spectral_values(result, displacement));
    object["geometric_mean"] = spectral_values(result, spectrum.geometric_mean);
    object["rotd50"] = spectral_values(result, spectrum.rotd50);
    object["rotd100"] = spectral_values(result, spectrum.rotd100);
  }
  return object;
}

Json component_object(const SpectrumResult& result, const Component& component) {
  const double unit = result.options.in_g ? standard_gravity : 1;
  return {{"file", component.file},
          {"column", component.column},
          {"samples", component.acceleration.size()},
          {"spacing", component.spacing},
          {"duration", component.duration()},
          {"peak_acceleration", component.peak / unit},
          {"arias_intensity", component.intensity.arias},
          {"from_5", component.intensity.from},
          {"duration_5_95", component.intensity.duration}};
}

/// The number of the only recording, or a list of both.
template <class Value>
Json of_each(const SpectrumResult& result, Value value) {
  if (result.components.size() == 1) return value(result.components[0]);
  Json list = Json::array();
  for (const auto& component : result.components) list.push_back(value(component));
  return list;
}

}  // namespace

std::string to_json(const SpectrumResult& result, bool with_fourier, const Voice& voice) {
  Json document;
  Json& components = document["components"] = Json::array();
  for (const auto& component : result.components) components.push_back(component_object(result, component));
  document["peaks"] = result.options.peaks;
  document["between_samples"] = result.options.between_samples;
  const char* acceleration = result.options.in_g ? "g" : "m/s^2";
  document["units"] = result.options.shock
                          ? Json{{"period", "s"}, {"acceleration", acceleration}}
                          : Json{{"period", "s"}, {"SD", "m"}, {"PSV", "m/s"}, {"PSA", acceleration}};
  Json& spectra = document["spectra"] = Json::array();
  for (const auto& spectrum : result.spectra) spectra.push_back(spectrum_object(result, spectrum));
  document["arias_intensity"] = of_each(result, [](const Component& c) { return c.intensity.arias; });
  document["duration_5_95"] = of_each(result, [](const Component& c) { return c.intensity.duration; });
  if (with_fourier)
    document["fourier"] = of_each(result, [](const Component& c) {
      return Json{{"frequency_step", c.fourier.step}, {"amplitude", c.fourier.amplitude}};
    });
  add_notices(document, result.notices, voice);
  if (result.interrupted) document["message"] = "interrupted";
  return to_text(document, with_fourier);
}

}  // namespace cromer::core
