#include "cromer/documents/csv/motion.h"

#include <fmt/format.h>

#include "cromer/report/csv.h"
#include "cromer/tasks/fit/fitted_motion.h"

namespace cromer::core {
namespace {

std::string heading(std::string_view name, std::string_view unit) {
  return unit.empty() ? std::string(name) : fmt::format("{} ({})", name, unit);
}

/// 1 for a sample that is in no fit, else 0.
std::vector<double> set_aside(const FittedRecording& fitted, const std::vector<double>& t) {
  std::vector<double> aside(t.size(), 0.0);
  const auto& outliers = fitted.series.outliers;
  for (std::size_t i = 0, k = 0; i < t.size(); ++i) {
    while (k < outliers.size() && outliers[k].t < t[i]) ++k;
    if (k < outliers.size() && outliers[k].t == t[i]) aside[i] = 1;
  }
  return aside;
}

}  // namespace

std::string motion_csv(const std::vector<FittedRecording>& fits) {
  std::string out;
  for (const auto& fitted : fits) {
    if (fitted.parameters.empty()) continue;
    const FittedMotion motion = fitted_motion(fitted);
    const auto [measured, x, v, energy] = motion_units(fitted);
    std::vector<CsvColumn> columns{{"file", fitted.file},
                                   {"run", fmt::format("{}", fitted.series.run)},
                                   {"t (s)", std::span<const double>(motion.t)},
                                   {heading("measured", measured), std::span<const double>(motion.measured)},
                                   {heading("x", x), std::span<const double>(motion.x)},
                                   {heading("v", v), std::span<const double>(motion.v)},
                                   {heading("energy", energy), std::span<const double>(motion.energy)},
                                   {heading("residual", measured), std::span<const double>(motion.residual)}};
    if (!motion.local_velocity.empty())
      columns.push_back({heading("v from the samples", v), std::span<const double>(motion.local_velocity)});
    const std::vector<double> aside = set_aside(fitted, motion.t);
    columns.push_back({"set aside", std::span<const double>(aside)});
    append_csv(out, columns, {}, out.empty());
  }
  return out;
}

}  // namespace cromer::core
