// Task: one run for each method and drive frequency asked for.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cromer/analysis/energy.h"
#include "cromer/analysis/energy_balance.h"
#include "cromer/analysis/frequency_response.h"
#include "cromer/analysis/measured_oscillator.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/quantity.h"
#include "cromer/methods/method_settings.h"
#include "cromer/model/general_drive.h"
#include "cromer/model/oscillator.h"
#include "cromer/notice.h"
#include "cromer/result.h"
#include "cromer/run/course.h"
#include "cromer/run/event.h"
#include "cromer/tasks/methods/method_effect.h"
#include "cromer/tasks/simulate/drive_record.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// A simulated motion sensor: offset + x + noise, rounded to the resolution.
struct SensorOptions {
  double noise = 0;       // [m] standard deviation, >= 0
  double resolution = 0;  // [m] >= 0; 0: not rounded
  double offset = 0;      // [m]
  unsigned long long seed = 1;
  bool used = false;  ///< any of these options was given
};

/// What `cromer simulate` takes; empty optionals are the documented defaults.
struct SimulateOptions {
  double mass = 1;                            // [kg] > 0
  std::optional<double> stiffness{};          // [N/m] any sign; 1 by default
  std::optional<double> damping{};            // [kg/s] >= 0; 0 by default
  double loss_factor = 0;                     // >= 0; of sweeps alone, not an option of simulate
  Oscillator<double> law{};                   ///< only the coefficients of its other terms are used
  std::optional<double> static_friction{};    // [N] >= friction; by default equal to it
  std::optional<double> natural_frequency{};  // [rad/s] > 0, in place of stiffness
  std::optional<double> damping_ratio{};      // >= 0, in place of damping
  std::optional<double> quality_factor{};     // > 0, in place of damping
  std::string drive{};                        ///< a name that --drive takes; harmonic by default
  double drive_amplitude = 0;                 // [N] >= 0
  std::vector<double> drive_frequency{};      // [rad/s] >= 0; one run each; where a chirp begins
  double drive_phase = 0;                     // [rad]
  std::optional<double> drive_to{};           // [rad/s] >= 0, where a chirp ends
  std::optional<double> drive_start{};        // [s] >= 0, of pulses and chirps; 0
  std::optional<double> drive_duration{};     // [s] > 0, of pulses and chirps; a chirp: to the end
  std::optional<double> unbalance_mass{};     // [kg] > 0
  std::optional<double> eccentricity{};       // [m] > 0, of the unbalance
  std::optional<double> base_displacement{};  // [m] > 0, amplitude of a shaking base
  std::string drive_file{};                   ///< recorded force
  std::string base_motion{};                  ///< recorded acceleration of the ground
  std::string drive_column{};                 ///< of that file
  std::string between_samples{};              ///< linear (by default), hold or band-limited
  ReadOptions read{};                         ///< of that file
  std::optional<DriveRecord> drive_record{};  ///< what that file holds, read by the caller; not an option
  std::optional<double> position{};           // [m]; 1 when nothing else sets the motion going
  std::optional<double> velocity{};           // [m/s]; 0
  std::vector<std::string> method{};          ///< names; euler-cromer by default
  std::optional<double> step{};               // [s] > 0; 1/200 of the shorter of natural and drive period
  std::optional<double> until{};              // [s] > 0; 20 natural periods
  std::optional<double> tolerance{};  // 1e-15 to 1e-2; Newton's last update relative to the motion's scale
  std::optional<double> beta{}, gamma{};  // of newmark, 0 to 1; 1/4 and 1/2 by default
  std::optional<double> rho_inf{};        // of generalized-alpha, 0 to 1; 0.8 by default
  std::optional<double> accuracy{};       ///< 1e-9 to 0.5, in place of step: the largest that keeps to it
  std::vector<std::string> event{};       ///< as parse_event reads them
  long long every = 1;                    ///< keep every Nth state, > 0
  bool compensated = false;               ///< states in compensated sums, for very long runs
  SensorOptions sensor{};
  double memory =
      0;  // [bytes] most that the kept states may take; 0: no limit. Set by the caller, not an option
  bool motion_only = false;  ///< no energy balance, nothing measured or transmitted. Set by the caller
};

/// The accuracy asked for, the step that gives it, and the errors measured on a run with that step. They are
/// relative: of the mean frequency, the mean decay rate and the amplitude.
struct Accuracy {
  double asked = 0;                         ///< 1e-9 to 0.5
  double step = 0;                          // [s] a whole number of them fills the run
  std::optional<double> frequency_error{};  ///< empty if the motion is not a free swing
  std::optional<double> decay_error{};      ///< empty likewise, and if nothing is damped
  double amplitude_error = 0;  ///< at the end; driven: of the steady amplitude, or of the whole motion

  /// The largest of them.
  double worst() const;
};

/// What the spring and damper of a driven run transmit: from a shaking base to the mass a displacement [m],
/// from a force on the mass to the ground a force [N].
struct RunTransmission {
  bool of_motion = false;
  double sent = 0;                          // [m] or [N] amplitude
  double frequency_ratio = 0;               ///< drive over undamped natural frequency
  Transmission exact{};                     ///< infinite at undamped resonance
  std::optional<Transmission> simulated{};  ///< where the method's own motion settles; empty if it does
                                            ///< not, and for methods that choose their own steps

  bool bounded() const { return std::isfinite(exact.amplitude); }
  /// Relative error of the transmitted amplitude.
  std::optional<double> error() const {
    return simulated && bounded() ? std::optional(simulated->amplitude / exact.amplitude - 1) : std::nullopt;
  }
};

/// One run and everything that defines it.
struct SimulatedRun {
  std::string method;
  std::string label;  ///< what tells it from the others: "euler-cromer, 3 rad/s"
  Oscillator<double> oscillator;
  HarmonicDrive<double> drive;  ///< amplitude 0 if nothing drives, or `general` does
  std::optional<GeneralDrive<double>> general{};
  State<double> start;
  double step = 0;   // [s]
  double until = 0;  // [s]
  double tolerance = 0;
  MethodSettings settings{};                      ///< further settings of the method
  bool compensated = false;                       ///< states in compensated sums
  std::optional<MethodEffect> effect{};           ///< what the method really simulates, of linear laws
  std::optional<RunTransmission> transmission{};  ///< what is transmitted, of driven linear laws
  Outcome outcome;
  Trajectory trajectory;
  std::vector<double> sensor{};                     ///< one sample per kept state; empty without a sensor
  Notice message;                                   ///< why it ended early, with time and step
  EventLog events{};                                ///< what to watch for, and what was found
  std::optional<Accuracy> accuracy{};               ///< if asked for
  std::optional<MeasuredOscillator> measured{};     ///< of a free motion under a law that is not linear
  std::optional<EnergyBalance> energy_balance{};    ///< if the kept states are dense enough
  std::optional<ModifiedEnergy> modified_energy{};  ///< if the method conserves one

  /// It reached its end, or an event that stops it.
  bool done() const {
    return outcome.status == Status::reached_end ||
           (outcome.status == Status::stopped_by_event && !outcome.interrupted);
  }
};

struct SimulateResult {
  SimulateOptions options;  ///< as used, defaults filled in
  std::vector<SimulatedRun> runs{};
  std::vector<Notice> notices{};
  bool ok() const {
    for (const auto& run : runs)
      if (!run.done()) return false;
    return true;
  }
};

/// Checks the options (an Error names option, value and constraint), then runs.
Result<SimulateResult> simulate(const SimulateOptions& options, const Watch& watch = {});

/// Reads the file of a --drive-file or a --base-motion, its path relative to `folder`, into
/// options.drive_record; without one it does nothing. An Error says what is wrong with the file.
Result<void> load_drive(SimulateOptions& options, const std::string& folder);

}  // namespace cromer::core
