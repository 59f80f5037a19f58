#include "cromer/identify/fit_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/identify/describe_fit.h"

namespace cromer {

LeastSquaresOptions least_squares_options(const Record& record, const FreeDecayOptions& options) {
  LeastSquaresOptions result;
  result.iteration_limit = options.iteration_limit;
  result.tolerance = options.tolerance;
  result.scale = centred_norm(record.y);
  result.residuals = static_cast<int>(record.t.size());
  return result;
}

FreeDecay interrupted_fit(const Law& law) {
  FreeDecay fit;
  fit.law = law;
  fit.status = FitStatus::iteration_limit;
  fit.message = "interrupted before the fit was done";
  return fit;
}

Record part_of(const Record& record, std::size_t first, std::size_t samples) {
  Record part = record;
  part.t = record.t.subspan(first, samples);
  part.y = record.y.subspan(first, samples);
  return part;
}

Record first_part(const Record& record, std::size_t samples) { return part_of(record, 0, samples); }

Record first_periods(const Record& record, double angular_frequency, double periods) {
  const double end = record.t.front() + periods * 2 * std::numbers::pi / angular_frequency;
  const auto samples =
      static_cast<std::size_t>(std::lower_bound(record.t.begin(), record.t.end(), end) - record.t.begin());
  return first_part(
      record, std::clamp<std::size_t>(samples, std::min<std::size_t>(32, record.t.size()), record.t.size()));
}

void set_status(FreeDecay& fit, LeastSquaresReason reason) {
  if (reason == LeastSquaresReason::converged) return;
  fit.status = FitStatus::iteration_limit;
  fit.message = reason == LeastSquaresReason::iteration_limit
                    ? fmt::format("the fit has not settled after {} iterations", fit.iterations)
                    : "the record does not determine this law: its terms cannot be told apart";
}

}  // namespace cromer
