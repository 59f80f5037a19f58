#include "cromer/documents/hdf5/spectrum.h"

#include <algorithm>

#include "cromer/documents/csv/spectrum_columns.h"
#include "cromer/documents/json/documents.h"
#include "cromer/version.h"

namespace cromer::core {
namespace {

/// "PSA RotD50 (g)" as "PSA_RotD50 (g)".
std::string without_blanks(std::string header) {
  std::replace(header.begin(),
               header.begin() + static_cast<std::ptrdiff_t>(std::min(header.find(" ("), header.size())), ' ',
               '_');
  return header;
}

}  // namespace

std::vector<Hdf5Table> spectrum_tables(const SpectrumResult& result, const std::string& command) {
  Hdf5Table table;
  table.texts = {
      {"description", to_json(result, false)}, {"program", "cromer " CROMER_VERSION}, {"command", command}};
  const std::string damping = result.hysteretic() ? "loss_factor" : "damping_ratio";
  Hdf5Column ratios{.name = damping};
  for (const auto& spectrum : result.spectra) ratios.values.push_back(spectrum.damping_ratio);
  table.columns = {std::move(ratios), {.name = "period (s)", .values = result.periods}};
  const std::vector<std::uint64_t> shape{result.spectra.size(), result.periods.size()};
  const std::size_t first = table.columns.size();
  for (const auto& spectrum : result.spectra) {
    const NamedColumns columns = spectrum_columns(result, spectrum);
    for (std::size_t i = 0; i < columns.headers.size(); ++i) {
      if (table.columns.size() == first + i)
        table.columns.push_back({.name = without_blanks(columns.headers[i]),
                                 .values = {},
                                 .shape = shape,
                                 .axes = damping + " period"});
      auto& values = table.columns[first + i].values;
      values.insert(values.end(), columns.values[i].begin(), columns.values[i].end());
    }
  }
  return {std::move(table)};
}

}  // namespace cromer::core
