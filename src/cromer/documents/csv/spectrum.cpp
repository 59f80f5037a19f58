#include "cromer/documents/csv/spectrum.h"

#include <fmt/format.h>

#include "cromer/documents/csv/spectrum_columns.h"
#include "cromer/report/csv.h"

namespace cromer::core {
namespace {

std::vector<CsvColumn> columns_of(const NamedColumns& cells) {
  std::vector<CsvColumn> columns;
  for (std::size_t i = 0; i < cells.headers.size(); ++i)
    columns.push_back({cells.headers[i], std::span<const double>(cells.values[i])});
  return columns;
}

}  // namespace

std::string spectrum_csv(const SpectrumResult& result, const std::string& command) {
  std::string out;
  for (const auto& spectrum : result.spectra) {
    NamedColumns cells;
    cells.add("period (s)") = result.periods;
    cells.add(result.hysteretic() ? "loss_factor" : "damping_ratio")
        .assign(result.periods.size(), spectrum.damping_ratio);
    NamedColumns computed = spectrum_columns(result, spectrum);
    for (std::size_t i = 0; i < computed.headers.size(); ++i)
      cells.add(computed.headers[i]) = std::move(computed.values[i]);
    const bool first = &spectrum == &result.spectra.front();
    const std::vector<std::string> comments{command};
    append_csv(out, columns_of(cells), first ? comments : std::vector<std::string>{}, first);
  }
  return out;
}

std::string fourier_csv(const SpectrumResult& result, const std::string& command) {
  NamedColumns cells;
  auto& frequency = cells.add("frequency (Hz)");
  const FourierAmplitude& first = result.components[0].fourier;
  for (std::size_t i = 0; i < first.amplitude.size(); ++i)
    frequency.push_back(first.step * static_cast<double>(i));
  for (std::size_t c = 0; c < result.components.size(); ++c)
    cells.add(
        fmt::format("amplitude{} (m/s)", result.components.size() > 1 ? fmt::format(" {}", c + 1) : "")) =
        result.components[c].fourier.amplitude;
  std::string out;
  append_csv(out, columns_of(cells), std::vector{command}, true);
  return out;
}

}  // namespace cromer::core
