// From the record of a free motion to its law.
//
//   x'' = -w0^2 (x - E) - 2 g x' - (d/m) x'|x'| - (f/m) sgn x' - (k3/m) (x - E)^3
//
// The whole waveform is fitted, not its peaks. No start values are asked for. A record of velocities or
// accelerations is fitted as what it is: E is then the sensor's offset, in the unit of y, and all other
// parameters are those of the displacement.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/base/result.h"
#include "cromer/identify/free_motion.h"
#include "cromer/identify/law.h"
#include "cromer/identify/record.h"
#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "cromer/run/trajectory.h"

namespace cromer {

enum class FitStatus {
  converged,
  iteration_limit,
  no_oscillation,
  too_short,
  too_noisy,
  clipped,
  overdamped
};
std::string_view name(FitStatus status);  // "converged", ...

/// Order of the parameters in names and covariance: angular_frequency, [decay_rate], [drag], [friction],
/// [cubic], equilibrium, position, velocity; those that the law lacks are left out. "unit" is that of the
/// displacement. Decay rate, drag and friction are never negative: their intervals come from Student's t at
/// the minimum without that bound, and are cut at it.
struct FreeDecay {
  FitStatus status = FitStatus::converged;
  std::string message;  ///< why, when status is not converged
  int iterations = 0;
  Law law;
  Estimate angular_frequency;        // [rad/s] undamped
  Estimate decay_rate;               // [1/s] gamma = c / 2m; 0 where the law has no viscous term
  std::optional<Estimate> drag;      // d/m [1/unit]
  std::optional<Estimate> friction;  // f/m [unit/s^2]
  std::optional<Estimate> cubic;     // k3/m [1/(s^2 unit^2)]
  Estimate equilibrium;              // [unit of y]
  Estimate position;                 // [unit] displacement from the equilibrium at the first sample
  Estimate velocity;                 // [unit/s] at the first sample
  std::vector<std::string> names;    ///< of the fitted parameters, in the order of covariance
  std::vector<double> covariance;    ///< row by row
  Residual residual;
  double explained = 0;            ///< share of the record's variance that the law accounts for
  double bic = 0;                  ///< Bayesian information criterion, of as many samples as are independent
  double independent_samples = 0;  ///< samples over the factor by which correlation widens variances
  double student = 0;              ///< t of the 95 % intervals
  double step = 0;  // [s] longest step at which the law's motion is exact to well below its standard errors
  std::vector<std::size_t> outliers;  ///< samples of the record that were set aside (see outliers.h)
  std::vector<std::string> warnings;

  MotionParameters motion() const;

  /// Of the parameters a and b by name; 0 where one is not fitted.
  double covariance_of(std::string_view a, std::string_view b) const;
};

/// A motion that is known to follow a record's first samples.
struct KnownMotion {
  MotionParameters motion;
  std::size_t samples = 0;  ///< how many; all of them if the fit need not grow
  double decay_rate = 0;    // [1/s] of the amplitude, on average; 0 where it is not known
};

struct FreeDecayOptions {
  Law law{};
  bool angle = false;  ///< the record is of an angle in rad or its derivatives: choose_law tries a pendulum
  std::optional<KnownMotion> start{};  ///< found if not given; the viscous law alone needs none
  int iteration_limit = 50;            // > 0
  double tolerance = 1e-10;            // of the last relative change of the motion, 0 < tolerance < 1
  bool every_sample = false;           ///< outliers as well
};

/// Fits one law. Never throws; a record that cannot be fitted is a status with a message. Samples: 12,000
/// take about half a millisecond with the viscous law.
FreeDecay fit_free_decay(const Record& record, const FreeDecayOptions& options, const Watch& watch = {});

/// The record's values minus the fitted motion, outliers' as well; empty where the fit has no values.
std::vector<double> residuals_of(const FreeDecay& fit, const Record& record);

/// The motion of a fitted law: displacement from the equilibrium and velocity, at times [s] that strictly
/// increase from the first sample's.
Trajectory motion_of(const FreeDecay& fit, std::span<const double> t);

}  // namespace cromer
