#include "cromer/documents/csv/spectrum_columns.h"

#include <fmt/format.h>

namespace cromer::core {
namespace {

/// SD, PSV and PSA; `what` says of which motion: "", " 1", " RotD50".
void add_spectral(NamedColumns& cells, const SpectrumResult& result, const std::vector<double>& displacement,
                  const std::string& what) {
  const double unit = result.options.in_g ? standard_gravity : 1;
  cells.add("SD" + what + " (m)") = displacement;
  auto& velocity = cells.add("PSV" + what + " (m/s)");
  for (std::size_t i = 0; i < displacement.size(); ++i)
    velocity.push_back(pseudo_velocity(displacement[i], result.periods[i]));
  auto& acceleration = cells.add("PSA" + what + (result.options.in_g ? " (g)" : " (m/s²)"));
  for (std::size_t i = 0; i < displacement.size(); ++i)
    acceleration.push_back(pseudo_acceleration(displacement[i], result.periods[i]) / unit);
}

void add_shock(NamedColumns& cells, const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  const double unit = result.options.in_g ? standard_gravity : 1;
  auto& frequency = cells.add("frequency (Hz)");
  for (const double period : result.periods) frequency.push_back(1 / period);
  const auto add = [&](const std::string& name, auto value) {
    auto& column = cells.add(name + (result.options.in_g ? " (g)" : " (m/s²)"));
    for (const Shock& shock : spectrum.shock) column.push_back(value(shock) / unit);
  };
  add("primary", [](const Shock& s) { return s.primary; });
  add("residual", [](const Shock& s) { return s.residual; });
  add("maximax", [](const Shock& s) { return s.maximax(); });
  add("positive", [](const Shock& s) { return s.positive; });
  add("negative", [](const Shock& s) { return s.negative; });
}

}  // namespace

NamedColumns spectrum_columns(const SpectrumResult& result, const ResponseSpectrum& spectrum) {
  NamedColumns cells;
  if (!spectrum.shock.empty()) {
    add_shock(cells, result, spectrum);
  } else if (spectrum.displacement.size() == 1) {
    add_spectral(cells, result, spectrum.displacement[0], "");
  } else {
    for (std::size_t c = 0; c < spectrum.displacement.size(); ++c)
      add_spectral(cells, result, spectrum.displacement[c], fmt::format(" {}", c + 1));
    add_spectral(cells, result, spectrum.geometric_mean, " geometric mean");
    add_spectral(cells, result, spectrum.rotd50, " RotD50");
    add_spectral(cells, result, spectrum.rotd100, " RotD100");
  }
  return cells;
}

std::string component_name(const SpectrumResult& result, std::size_t c) {
  if (result.components[0].column == result.components[1].column) return fmt::format("component {}", c + 1);
  const std::string& column = result.components[c].column;
  return column.substr(0, column.find(" ("));
}

}  // namespace cromer::core
