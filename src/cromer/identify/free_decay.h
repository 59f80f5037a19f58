// From the record of a free motion to its law.
//
//   x'' = -w0^2 (x - E) - 2 g x' - (d/m) x'|x'| - (k3/m) (x - E)^3
//
// The whole waveform is fitted, not its peaks. No start values are asked for.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/base/result.h"

namespace cromer {

/// Which damping and stiffness terms are in the law. Viscous alone has a closed form.
struct Law {
  bool viscous = true;
  bool drag = false;
  bool friction = false;
  bool cubic = false;

  friend bool operator==(const Law&, const Law&) = default;
};

/// "viscous+drag"; reads any sum in any order, writes viscous, drag, friction, cubic. An unknown term is an Error that suggests the nearest.
Result<Law> parse_law(std::string_view text);
std::string to_text(const Law& law);

enum class FitStatus { converged, iteration_limit, no_oscillation, too_short, too_noisy, clipped, overdamped };
std::string_view name(FitStatus status);  // "converged", ...

/// One estimated number.
struct Estimate {
  double value = 0;
  double standard_error = 0;  ///< widened for correlated residuals
  double low = 0, high = 0;   ///< 95 % interval from Student's t
};

/// A recorded motion: times [s], strictly increasing, and values of the same length in any unit; no NaN in either.
struct Record {
  std::span<const double> t;
  std::span<const double> y;
  double resolution = 0;  ///< rounding step of the values, 0 if unknown
};

struct Residual {
  double rms = 0;              ///< in the unit of the record
  double normality = 0;        ///< p of a test for the normal distribution
  double autocorrelation = 0;  ///< at lag 1
  bool white = false;          ///< autocorrelations up to lag 20 are compatible with none (Ljung-Box, 1 %)
};

/// Order of the parameters in values and covariance: angular_frequency, decay_rate, [drag], [cubic], equilibrium, position, velocity.
struct FreeDecay {
  FitStatus status = FitStatus::converged;
  std::string message;  ///< why, when status is not converged
  int iterations = 0;
  Law law;
  Estimate angular_frequency;           // [rad/s] undamped
  Estimate decay_rate;                  // [1/s] gamma = c / 2m
  std::optional<Estimate> drag;         // d/m [1/unit of y]
  std::optional<Estimate> cubic;        // k3/m [1/(s^2 unit^2)]
  Estimate equilibrium;                 // [unit of y]
  Estimate position;                    // displacement from the equilibrium at the first sample
  Estimate velocity;                    // [unit of y / s] at the first sample
  std::vector<std::string> names;       ///< of the fitted parameters, in the order of covariance
  std::vector<double> covariance;       ///< row by row
  Residual residual;
  double bic = 0;                       ///< Bayesian information criterion
};

struct FreeDecayOptions {
  Law law;
  int iteration_limit = 50;   // > 0
  double tolerance = 1e-10;   // of the last relative change of the parameters, 0 < tolerance < 1
};

/// Fits one law. Never throws; a record that cannot be fitted is a status with a message.
FreeDecay fit_free_decay(const Record& record, const FreeDecayOptions& options, const Watch& watch = {});

}  // namespace cromer
