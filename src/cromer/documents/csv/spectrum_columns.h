// What a spectrum's files say of each period, by name and unit.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

/// Columns that are computed, with their headers: "SD (m)".
struct NamedColumns {
  std::vector<std::string> headers{};
  std::vector<std::vector<double>> values{};

  std::vector<double>& add(std::string header) {
    headers.push_back(std::move(header));
    return values.emplace_back();
  }
};

/// One value for each period, in the unit that was asked for.
NamedColumns spectrum_columns(const SpectrumResult& result, const ResponseSpectrum& spectrum);

/// "east" where the two components are columns of one file, else "component 1".
std::string component_name(const SpectrumResult& result, std::size_t c);

}  // namespace cromer::core
