#include "cromer/documents/csv/compare.h"

#include <fmt/format.h>

#include "cromer/read/column_kind.h"
#include "cromer/report/csv.h"

namespace cromer::core {

std::string compare_csv(const std::vector<CompareResult>& comparisons) {
  std::string out;
  for (const auto& comparison : comparisons) {
    const Series& series = comparison.recording.series;
    std::vector<double> measured = series.y;
    for (double& y : measured) y -= comparison.recording.fit.equilibrium().value;
    const std::string_view unit = si_unit_of(series.quantity);
    const std::string in = unit.empty() ? "" : fmt::format(" ({})", unit);
    const std::string measured_name = "measured displacement" + in,
                      simulated_name = "simulated displacement" + in;
    for (const auto& curve : comparison.curves) {
      const CsvColumn columns[] = {{"run", fmt::format("{}", series.run)},
                                   {"curve", curve.label},
                                   {"t (s)", std::span<const double>(series.t)},
                                   {measured_name, std::span<const double>(measured)},
                                   {simulated_name, std::span<const double>(curve.trajectory.x)}};
      append_csv(out, columns, {}, out.empty());
    }
  }
  return out;
}

}  // namespace cromer::core
