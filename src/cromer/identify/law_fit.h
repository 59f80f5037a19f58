// From the record of a motion to its law.
//
//   x'' = drive(t) - the forces of the law's terms per unit mass,   x = y - equilibrium
//
// The whole waveform is fitted, not its peaks, its beginning included; no start values are asked for. The
// motion is free, or driven by a harmonic or a recorded force. A record of velocities or accelerations is
// fitted as it is: the equilibrium is then the sensor's offset, in the unit of y, and all other parameters
// are those of the displacement.
//
// Under a recorded force offset, equilibrium and quadratic stiffness can be traded for each other without
// changing the motion (a shift of x turns a cubic into a cubic): no record tells all three, and of a linear
// law none tells two. An instrument whose zero lies amid the motion is taken to have been set to zero where
// the spring is at rest: its equilibrium is 0, and the force's offset is fitted. Where the zero is elsewhere,
// the force's is trusted. A spring that bends without a quadratic term has one place of rest that fits: a
// zero amid the motion may then be chance, and the record tells.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/identify/law.h"
#include "cromer/identify/least_squares/residual.h"
#include "cromer/identify/least_squares/uncertainty.h"
#include "cromer/identify/motion/motion_model.h"
#include "cromer/identify/record.h"
#include "cromer/result.h"
#include "cromer/status.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// Noise of a recorded force, as far as what the law leaves tells it. The uncertainties include it.
struct ForceNoiseSeen {
  double deviation = 0;  ///< of each sample (rms), the most likely [the force's unit]
  bool shows = false;    ///< it is there, and no more than a sensor's; else it may be
  bool counts = false;   ///< a standard error is larger for it, by a twentieth or more
  double bic = 0;        ///< Bayesian information criterion of the fit with such noise
};

/// Parameters stand in the order of fitted_parameters(); position and velocity are those at the first sample,
/// and of a harmonic drive amplitude and phase stand for cosine and sine. "unit" is that of the displacement.
/// Damping terms that can only take energy are never negative: their intervals come from Student's t at the
/// minimum without that bound, and are cut at it.
struct LawFit {
  FitStatus status = FitStatus::converged;
  Notice message;  ///< why, when status is not converged
  int iterations = 0;
  Law law = law_of("viscous");
  Drive drive;                      ///< what acted on it; a recorded force's samples are the caller's
  Motion motion;                    ///< the values
  int fitted = 0;                   ///< how many numbers were adjusted
  std::vector<std::string> names;   ///< of the parameters, in the order of estimates and covariance
  std::vector<Estimate> estimates;  ///< a standard error of 0: held by convention
  std::vector<double> covariance;   ///< row by row
  Residual residual;
  double explained = 0;            ///< share of the record's variance that the law accounts for
  double bic = 0;                  ///< Bayesian information criterion, of as many samples as are independent;
                                   ///< among others as Criterion has it
  double independent_samples = 0;  ///< samples over the factor by which correlation widens variances
  double student = 0;              ///< t of the 95 % intervals
  double step = 0;  // [s] longest step at which the law's motion is exact to well below its standard errors
  std::optional<ForceNoiseSeen> force_noise{};  ///< empty where the force was taken as exact
  std::vector<std::size_t> outliers;  ///< samples of the record that were set aside (see outliers.h)
  std::vector<Notice> notices;

  /// nullptr where there is none of that name.
  const Estimate* find(std::string_view name) const;
  Estimate* find(std::string_view name);
  /// The parameter of that name; all 0 where there is none.
  Estimate operator[](std::string_view name) const;

  /// Of the parameters a and b by name; 0 where one is not there.
  double covariance_of(std::string_view a, std::string_view b) const;

  Estimate angular_frequency() const { return (*this)["angular_frequency"]; }  // [rad/s] undamped
  /// [rad/s] of small swings: the spring's, and of a hysteretic law with its first stiffness as well.
  Estimate swing_frequency() const;
  Estimate decay_rate() const { return (*this)["decay_rate"]; }    // [1/s] gamma = c / 2m
  Estimate equilibrium() const { return (*this)["equilibrium"]; }  // [unit of y]
  Estimate position() const {
    return (*this)["position"];
  }  // [unit] from the equilibrium at the first sample
  Estimate velocity() const { return (*this)["velocity"]; }  // [unit/s] there

  /// True if there are parameters.
  bool has_values() const { return !estimates.empty(); }
  /// True if they may be used: the record was not refused.
  bool is_usable() const {
    return has_values() && (status == FitStatus::converged || status == FitStatus::iteration_limit ||
                            status == FitStatus::undetermined);
  }
};

/// A motion that is known to follow a record's first samples.
struct KnownMotion {
  Motion motion;
  std::size_t samples = 0;  ///< how many; all of them if the fit need not grow
  double decay_rate = 0;    // [1/s] of the amplitude, on average; 0 where it is not known
};

struct LawFitOptions {
  Law law = law_of("viscous");
  Drive drive{};
  double hysteresis_exponent = 1;           ///< >= 1
  std::optional<double> drive_frequency{};  // [rad/s] about; found if not given
  bool on_arc = false;  ///< of a point on an arc: a pendulum, unless another law is clearly better
  bool angle = false;   ///< the record is of an angle in rad or its derivatives: choose_law tries a pendulum
  std::optional<KnownMotion> start{};  ///< found if not given; the viscous law alone needs none
  int iteration_limit = 50;            // > 0
  double tolerance = 1e-10;            // of the last relative change of the motion, 0 < tolerance < 1
  bool may_grow = false;               ///< the viscous law's decay rate may be negative: a part of a motion
  bool every_sample = false;           ///< outliers as well
  double rms_to_beat =
      HUGE_VAL;  ///< a fit that leaves 1.2 times this is given up, one whose beginning leaves twice at once
};

/// Fits one law. Never throws; a record that cannot be fitted is a status with a message. 12,000 samples
/// take about half a millisecond with the viscous law.
LawFit fit_law(const Record& record, const LawFitOptions& options, const Watch& watch = {});

/// The record's values minus the fitted motion, outliers' as well; empty where the fit has no values.
std::vector<double> residuals_of(const LawFit& fit, const Record& record);

/// The motion of a fitted law: displacement from the equilibrium and velocity, at times [s] that strictly
/// increase from the first sample's; under a recorded force at times of its samples.
Trajectory motion_of(const LawFit& fit, std::span<const double> t);

}  // namespace cromer::core
