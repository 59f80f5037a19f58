#include "cromer/study/task/recognise_drive.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "cromer/study/task/fit_forced.h"
#include "cromer/study/task/forced_options.h"
#include "cromer/study/task/used_samples.h"

namespace cromer {

std::optional<FittedRecording> recognise_drive(const FittedRecording& free, const Series& motion,
                                               const FitOptions& options, const Watch& watch) {
  const bool automatic =
      options.recognise_drive && (options.law.empty() || options.law == "auto") && !is_driven(options);
  constexpr double structured = 0.3, unstructured = 0.5;  // autocorrelation of residuals
  if (!automatic || free.parameters.empty() || free.fit.residual.autocorrelation < structured ||
      watch.interrupted())
    return std::nullopt;
  FitOptions driven = options;
  driven.drive_frequency = "auto";
  Result<FittedRecording> result = fit_driven(motion, free.file, driven, watch);
  if (!result || result->fit.status != FitStatus::converged) return std::nullopt;
  const ForcedFit& fit = *result->forced;
  const Residual &left = fit.law.residual, &left_free = free.fit.residual;
  if (!(left.rms < 0.9 * left_free.rms) || std::abs(left.autocorrelation) > unstructured ||
      !(fit.drive_amplitude->low > 0))
    return std::nullopt;
  const double w0 = fit.law.angular_frequency.value, w = fit.drive_frequency->value;
  const double steady = std::pow(w, std::max(0, derivative_order(motion.quantity))) *
                        fit.drive_amplitude->value /
                        std::hypot(w0 * w0 - w * w, 2 * fit.law.decay_rate.value * w);
  double square = 0;
  for (double y : result->series.y)
    square += (y - fit.law.equilibrium.value) * (y - fit.law.equilibrium.value);
  const double rms = std::sqrt(square / static_cast<double>(result->series.y.size()));
  if (steady < 0.3 * rms * std::numbers::sqrt2) return std::nullopt;
  result->options = options;
  result->warnings.push_back(fmt::format(
      "the motion is driven, at {:.6g} Hz: a free motion would leave {:.3g}, this leaves {:.3g}; say "
      "--drive-frequency if it is known, or choose a free part with --from and --to",
      w / (2 * std::numbers::pi), left_free.rms, left.rms));
  return *std::move(result);
}

}  // namespace cromer
