#include "fit_csv.h"

#include <fmt/format.h>

#include <cmath>

#include "cromer/report/csv.h"

namespace cromer::cli {
namespace {

void append_row(std::string& out, const FittedRecording& fitted, const std::string& name,
                const Estimate& estimate, const std::string& unit) {
  if (!std::isfinite(estimate.value)) return;  // a quality factor without damping
  const auto cell = [](const double& value) { return std::span<const double>(&value, 1); };
  const CsvColumn columns[] = {{"file", fitted.file},
                               {"column", fitted.series.column},
                               {"run", fmt::format("{}", fitted.series.run)},
                               {"quantity", name},
                               {"value", cell(estimate.value)},
                               {"standard_error", cell(estimate.standard_error)},
                               {"low", cell(estimate.low)},
                               {"high", cell(estimate.high)},
                               {"unit", unit}};
  append_csv(out, columns, {}, out.empty());
}

}  // namespace

std::string fit_csv(const std::vector<FittedRecording>& fits) {
  std::string out;
  for (const auto& fitted : fits) {
    for (const auto* list : {&fitted.parameters, &fitted.derived})
      for (const auto& entry : *list) append_row(out, fitted, entry.name, entry.estimate, entry.unit);
    for (const auto& segment : fitted.segments)
      append_row(out, fitted, fmt::format("decay_rate {:.6g} to {:.6g} s", segment.from, segment.to),
                 segment.rate, "1/s");
    if (fitted.decay_rate_mean) append_row(out, fitted, "decay_rate_mean", *fitted.decay_rate_mean, "1/s");
    if (fitted.reynolds_max) append_row(out, fitted, "reynolds_max", *fitted.reynolds_max, "");
  }
  return out;
}

}  // namespace cromer::cli
