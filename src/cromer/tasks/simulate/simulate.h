// Task: one run for each method and drive frequency asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cromer/analysis/energy_balance.h"
#include "cromer/analysis/invariants.h"
#include "cromer/analysis/measured_oscillator.h"
#include "cromer/base/interrupt.h"
#include "cromer/base/quantity.h"
#include "cromer/methods/method_settings.h"
#include "cromer/model/general_drive.h"
#include "cromer/model/oscillator.h"
#include "cromer/result.h"
#include "cromer/run/course.h"
#include "cromer/run/event.h"
#include "cromer/tasks/methods/method_effect.h"
#include "cromer/tasks/simulate/accuracy.h"
#include "cromer/tasks/simulate/drive_record.h"
#include "cromer/tasks/simulate/run_transmission.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// A simulated motion sensor: offset + x + noise, rounded to the resolution.
struct SensorOptions {
  double noise = 0;       // [m] standard deviation, >= 0
  double resolution = 0;  // [m] >= 0; 0: not rounded
  double offset = 0;      // [m]
  unsigned long long seed = 1;
  bool used = false;  ///< any of them was asked for
};

/// What `cromer simulate` takes; empty optionals are the documented defaults.
struct SimulateOptions {
  double mass = 1;                            // [kg] > 0
  std::optional<double> stiffness{};          // [N/m] any sign; 1 by default
  std::optional<double> damping{};            // [kg/s] >= 0; 0 by default
  double loss_factor = 0;                     // >= 0; of sweeps alone, not an option of simulate
  Oscillator<double> law{};                   ///< its other terms' coefficients, and no more, are looked at
  std::optional<double> static_friction{};    // [N] >= friction, which it is by default
  std::optional<double> natural_frequency{};  // [rad/s] > 0, in place of stiffness
  std::optional<double> damping_ratio{};      // >= 0, in place of damping
  std::optional<double> quality_factor{};     // > 0, in place of damping
  std::string drive{};                        ///< a name of drive_setup.h; harmonic by default
  double drive_amplitude = 0;                 // [N] >= 0
  std::vector<double> drive_frequency{};      // [rad/s] >= 0; one run each; where a chirp begins
  double drive_phase = 0;                     // [rad]
  std::optional<double> drive_to{};           // [rad/s] >= 0, where a chirp ends
  std::optional<double> drive_start{};        // [s] >= 0, of pulses and chirps; 0
  std::optional<double> drive_duration{};     // [s] > 0, of pulses and chirps; a chirp's: to the end
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
  std::vector<std::string> event{};       ///< as event_option.h reads them
  long long every = 1;                    ///< keep every Nth state, > 0
  bool compensated = false;               ///< states in compensated sums, for very long runs
  SensorOptions sensor{};
  double memory =
      0;  // [bytes] most that the kept states may take; 0: no limit. Set by the caller, not an option
  bool motion_only = false;  ///< no energy balance, nothing measured or transmitted. Set by the caller
};

/// One run and everything that defines it.
struct SimulatedRun {
  std::string method;
  std::string label;  ///< what tells it from the others: "euler-cromer, 3 rad/s"
  Oscillator<double> oscillator;
  HarmonicDrive<double> drive;  ///< amplitude 0 where nothing drives, or another drive does
  std::optional<GeneralDrive<double>> general{};
  State<double> start;
  double step = 0;   // [s]
  double until = 0;  // [s]
  double tolerance = 0;
  MethodSettings settings{};                      ///< what the method takes besides
  bool compensated = false;                       ///< states in compensated sums
  std::optional<MethodEffect> effect{};           ///< what it really simulates, of linear laws
  std::optional<RunTransmission> transmission{};  ///< what gets through, of driven linear laws
  Outcome outcome;
  Trajectory trajectory;
  std::vector<double> sensor{};                     ///< one sample per kept state; empty without a sensor
  Notice message;                                   ///< why it ended early, with time and step
  EventLog events{};                                ///< what was watched for and found
  std::optional<Accuracy> accuracy{};               ///< where it was asked for
  std::optional<MeasuredOscillator> measured{};     ///< of a free motion that is not the linear law's
  std::optional<EnergyBalance> energy_balance{};    ///< where the kept states are dense enough for it
  std::optional<ModifiedEnergy> modified_energy{};  ///< where the method conserves one

  /// It reached its end, or an event that was to stop it.
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

}  // namespace cromer::core
