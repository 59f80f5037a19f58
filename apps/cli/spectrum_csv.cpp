#include "spectrum_csv.h"

#include <fmt/format.h>

#include "command_line.h"
#include "cromer/report/csv.h"

namespace cromer::cli {
namespace {

/// Columns that are computed, with their headers.
struct Cells {
  std::vector<std::string> headers{};
  std::vector<std::vector<double>> values{};

  std::vector<double>& add(std::string header) {
    headers.push_back(std::move(header));
    return values.emplace_back();
  }
  std::vector<CsvColumn> columns() const {
    std::vector<CsvColumn> result;
    for (std::size_t i = 0; i < headers.size(); ++i)
      result.push_back({headers[i], std::span<const double>(values[i])});
    return result;
  }
};

/// SD, PSV and PSA; `what` says of which motion: "", " 1", " RotD50".
void add_spectral(Cells& cells, const SpectrumResult& result, const std::vector<double>& displacement,
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

void add_shock(Cells& cells, const SpectrumResult& result, const ResponseSpectrum& spectrum) {
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

std::string spectrum_csv(const SpectrumResult& result, const Arguments& arguments) {
  std::string out;
  for (const auto& spectrum : result.spectra) {
    Cells cells;
    cells.add("period (s)") = result.periods;
    cells.add(result.hysteretic() ? "loss_factor" : "damping_ratio")
        .assign(result.periods.size(), spectrum.damping_ratio);
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
    const bool first = &spectrum == &result.spectra.front();
    const std::vector<std::string> comments{command_line("spectrum", arguments)};
    append_csv(out, cells.columns(), first ? comments : std::vector<std::string>{}, first);
  }
  return out;
}

std::string fourier_csv(const SpectrumResult& result, const Arguments& arguments) {
  Cells cells;
  auto& frequency = cells.add("frequency (Hz)");
  const FourierAmplitude& first = result.components[0].fourier;
  for (std::size_t i = 0; i < first.amplitude.size(); ++i)
    frequency.push_back(first.step * static_cast<double>(i));
  for (std::size_t c = 0; c < result.components.size(); ++c)
    cells.add(
        fmt::format("amplitude{} (m/s)", result.components.size() > 1 ? fmt::format(" {}", c + 1) : "")) =
        result.components[c].fourier.amplitude;
  std::string out;
  append_csv(out, cells.columns(), std::vector{command_line("spectrum", arguments)}, true);
  return out;
}

}  // namespace cromer::cli
