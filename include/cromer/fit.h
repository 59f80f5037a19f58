// From the record of a motion to its law.
#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <cromer/drive.h>
#include <cromer/export.h>
#include <cromer/notice.h>
#include <cromer/oscillator.h>
#include <cromer/quantity.h>
#include <cromer/read.h>
#include <cromer/result.h>
#include <cromer/status.h>
#include <cromer/trajectory.h>

namespace cromer {

namespace core {
struct FittedRecording;
}

/// What was recorded, in SI units: m, rad, m/s, rad/s, m/s^2.
enum class Observed { position, angle, velocity, angular_velocity, acceleration };

/// A law by the names of its terms, "viscous+drag" (a linear spring is part of it), or `automatic`: the data
/// choose.
class Law {
 public:
  Law() = default;
  template <std::convertible_to<std::string_view> Text>
  Law(const Text& terms) : terms_(std::string_view(terms)) {}  // NOLINT: implicit on purpose
  const std::string& terms() const { return terms_; }
  friend bool operator==(const Law&, const Law&) = default;

 private:
  std::string terms_ = "auto";
};

inline const Law automatic{};

/// What is known beforehand, and what is asked for. Everything may be left out. An option that needs another
/// is an Error without it.
struct FitOptions {
  Law law{};
  OptionalQuantity mass{};                 // [kg] > 0, for the spring constant and all that is a force
  OptionalQuantity spring_mass{};          // [kg] >= 0, needs mass; a third of it is added
  OptionalQuantity disc_diameter{};        // [m] > 0, for the Reynolds number and the drag coefficient
  OptionalQuantity temperature{};          // [K] 100 to 1900, of the air, needs disc_diameter; else 293.15
  Observed observed = Observed::position;  ///< for arrays; a file's column says what it is
  std::span<const double> force{};  // [N] recorded beside the motion at the same, even times; empty: none
  /// What the recorded force did between its samples; the data choose if not given.
  std::optional<BetweenSamples> between_samples{};
  std::optional<double> drive_frequency{};  // [rad/s] > 0, rough frequency of a harmonic drive
  bool find_drive = false;                  ///< there is a harmonic drive of unknown frequency
  bool no_spring = false;                   ///< a body without a spring, under a recorded force
  double hysteresis_exponent = 1;           ///< >= 1
  /// Above 0 to 0.9, needs a recorded force: the share of the samples, the last ones, that are not fitted but
  /// test the law; json() of the fit has the outcome.
  std::optional<double> hold_out{};
  std::optional<double> segment{};  // [s] > 0, of free motions: a decay rate for each stretch of this length
  std::optional<double> from{}, to{};  // [s] first and last time used
  Progress progress{};
};

/// Which columns and runs of a file.
struct Selection {
  std::string column{};        ///< its name; "": the motion is found
  std::string force_column{};  ///< of a recorded force that drives it; "": none
  std::optional<int> run{};    ///< from 1; all if not given
};

struct Residual {
  double rms = 0;              ///< in the unit of the record, over the fitted samples
  double normality = 0;        ///< p of the Jarque-Bera test
  double autocorrelation = 0;  ///< from sample to sample
  bool white = false;          ///< compatible with no correlation up to lag 20 (Ljung-Box, 1 %)
};

/// A law that was tried.
struct Candidate {
  std::string law;
  double rms = 0;  ///< of its residual, in the unit of the record
  double bic = 0;  ///< Bayesian information criterion: the smaller, the better
};

/// The decay rate of one stretch.
struct SegmentRate {
  double from = 0, to = 0;  // [s]
  Estimate rate;            // [1/s]
};

/// The fitted motion, one value for each sample used.
struct FittedMotion : Trajectory {  ///< x is the displacement from the equilibrium, v the law's own velocity
  std::vector<double> measured;     ///< the record
  std::vector<double> residual;     ///< measured less fitted
};

/// The law of one recorded motion.
struct LawFit {
  FitStatus status = FitStatus::converged;
  std::string message;  ///< why, where it did not converge, in English
  /// "viscous+drag"; "" where the run of a file could not be read (its status is then no_oscillation, and the
  /// message says why).
  std::string law;
  /// As fitted: the law's terms per unit mass, the drive, equilibrium, position and velocity at the first
  /// used sample, `begin`. Then, with a mass, the coefficients themselves: stiffness [N/m], damping [kg/s],
  /// ...
  std::vector<Parameter> parameters;
  /// Frequency, period, quality factor, ...: at the amplitude of the first used sample or, of a driven
  /// motion, at that of a sinusoid as strong as the motion.
  std::vector<Parameter> derived;
  std::vector<std::string> fitted;  ///< names of the fitted parameters, in the order of the covariance
  std::vector<double> covariance;   ///< row by row; its diagonal is the squares of the standard errors
  Residual residual;
  std::size_t samples = 0, used = 0;  ///< of the record, and of those that were fitted
  double begin = 0;                   // [s] the first used sample: position and velocity are those there
  std::vector<Candidate> candidates;
  std::vector<SegmentRate> segments;
  std::optional<Estimate> decay_rate_mean;  // [1/s] of the segments
  std::optional<Estimate> reynolds_max;     ///< with a disc diameter: v D/nu at the largest speed of the law
  std::optional<Estimate> keulegan_carpenter;  ///< with a disc diameter: 2 pi A/D at the largest amplitude
  std::string file, column;                    ///< where the record comes from; "" of arrays
  int run = 1;
  bool interrupted = false;     ///< progress ended it; what was not computed is missing
  std::vector<Notice> notices;  ///< what else there is to know
  std::shared_ptr<const core::FittedRecording> detail{};  ///< for at() and document.h

  bool succeeded() const { return detail && status == FitStatus::converged; }

  /// A number among parameters and derived; empty where none has that name.
  CROMER_API std::optional<Estimate> find(std::string_view name) const;

  /// The law's motion at times [s] that strictly increase from the first used sample's on. An Error where the
  /// fit has no values, or a recorded force drives the motion (motion() has it at the samples).
  CROMER_API Result<Trajectory> at(std::span<const double> t) const;

  /// The motion at the samples; an Error where the fit has no values.
  CROMER_API Result<FittedMotion> motion() const;

  /// The law with its mass, or per unit mass where none was given: what simulate() takes. An Error where the
  /// fit has no values.
  CROMER_API Result<Oscillator> oscillator() const;
};

/// The law of the motion that was seen at times t [s], strictly increasing, as y [SI unit of what was
/// observed]. NaN in y is a missing value. At least one and a half periods are needed. An Error names the
/// argument; a record that cannot be fitted is a status. Method: the whole waveform is fitted by
/// Levenberg-Marquardt, the law's motion integrated with its derivatives; intervals allow for correlated
/// residuals (docs/identify.md).
CROMER_API Result<LawFit> fit(std::span<const double> t, std::span<const double> y,
                              const FitOptions& options = {});

/// The same of the runs of a recording, one fit for each that is selected.
CROMER_API Result<std::vector<LawFit>> fit(const Recording& recording, const FitOptions& options = {},
                                           const Selection& selection = {});

}  // namespace cromer
