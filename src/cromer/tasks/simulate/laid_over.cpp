#include "cromer/tasks/simulate/laid_over.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cromer/base/length_unit.h"
#include "cromer/base/quantity.h"
#include "cromer/read/column_kind.h"

namespace cromer::core {

std::vector<Option> options_of(OverOptions& o) {
  constexpr std::string_view group = "A recording under the runs";
  return {
      {"over", &o.file, "", Range::any,
       "file with a recording that the runs are laid over: dots in the plot, and how far each run is from it",
       "none", group},
      {"over-column", &o.column, "", Range::any, "its column", "a position, else an angle", group},
      {"over-run", &o.run, "", Range::positive, "its run", "1", group},
      {"over-from", &o.from, "s", Range::any, "its time at which the runs begin", "its first sample", group},
      {"over-offset", &o.offset, "", Range::any, "its reading at x = 0, in SI units", "0", group}};
}

bool lies_under_runs(const Series& series) {
  const std::string_view unit = si_unit_of(series.quantity);
  return unit.empty() || unit == "m" || unit == "rad";
}

Result<LaidOver> lay_over(const Recording& recording, const OverOptions& options, const SimulateResult& runs,
                          const ReadOptions& read) {
  const Result<Series> series = take_series(recording, options.column, options.run.value_or(1), read);
  if (!series) return series.error();
  if (!lies_under_runs(*series))
    return Error{"over_is_no_position", {{"column", series->column}, {"kind", kind_of(series->quantity)}}};
  double until = 0;
  for (const SimulatedRun& run : runs.runs) until = std::max(until, run.until);
  const double from = options.from.value_or(series->t.front());
  LaidOver laid{series->column, unit_of(*series), {}, {}};
  const double slack = 1e-9 * until;
  for (std::size_t i = 0; i < series->t.size(); ++i) {
    const double t = series->t[i] - from;
    if (t < -slack || t > until + slack) continue;
    laid.t.push_back(t);
    laid.x.push_back(series->y[i] - options.offset);
  }
  if (laid.t.empty())
    return Error{"over_has_no_samples", {{"column", series->column}, {"from", from}, {"to", from + until}}};
  return laid;
}

namespace {

std::string distance_text(double distance, std::string_view unit) {
  if (unit != "m") return rounded(distance, 3) + (unit.empty() ? "" : " ") + std::string(unit);
  const LengthUnit suits = length_unit(distance);
  return rounded(distance / suits.metres, 3) + " " + std::string(suits.symbol);
}

}  // namespace

Notice distance_notice(const LaidOver& samples, const SimulatedRun& run) {
  const Trajectory& motion = run.trajectory;
  double sum = 0;
  std::size_t n = 0, k = 1;
  for (std::size_t i = 0; i < samples.t.size() && motion.size() > 1; ++i) {
    const double t = samples.t[i];
    while (k + 1 < motion.size() && motion.t[k] < t) ++k;
    const double step = motion.t[k] - motion.t[k - 1], share = (t - motion.t[k - 1]) / step;
    if (share < -1e-6 || share > 1 + 1e-6) continue;
    const double off = samples.x[i] - (motion.x[k - 1] + share * (motion.x[k] - motion.x[k - 1]));
    sum += off * off;
    ++n;
  }
  if (n == 0) return {};
  return Notice{"run_beside_recording",
                {{"run", run.label},
                 {"rms", distance_text(std::sqrt(sum / static_cast<double>(n)), samples.unit)},
                 {"column", samples.name},
                 {"samples", n}}};
}

}  // namespace cromer::core
