#include "compare_csv.h"

#include <fmt/format.h>

#include "cromer/report/csv.h"

namespace cromer::cli {

std::string compare_csv(const std::vector<CompareResult>& comparisons) {
  std::string out;
  for (const auto& comparison : comparisons) {
    const Series& series = comparison.recording.series;
    std::vector<double> measured = series.y;
    for (double& y : measured) y -= comparison.recording.fit.equilibrium.value;
    for (const auto& curve : comparison.curves) {
      const CsvColumn columns[] = {{"run", fmt::format("{}", series.run)},
                                   {"curve", curve.label},
                                   {"t (s)", std::span<const double>(series.t)},
                                   {"measured", std::span<const double>(measured)},
                                   {"simulated", std::span<const double>(curve.trajectory.x)}};
      append_csv(out, columns, {}, out.empty());
    }
  }
  return out;
}

}  // namespace cromer::cli
