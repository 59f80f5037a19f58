// From a law of motion to its motion, by any classical method.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <cromer/drive.h>
#include <cromer/export.h>
#include <cromer/methods.h>
#include <cromer/notice.h>
#include <cromer/oscillator.h>
#include <cromer/result.h>
#include <cromer/status.h>
#include <cromer/trajectory.h>

namespace cromer {

namespace core {
struct SimulateResult;
}

/// Everything about a run but the law. What is left out has a default that depends on the law.
struct SimulateOptions {
  Method method = "euler-cromer";
  Drive drive{};
  std::optional<double> position{};  // [m] at t = 0; 1 where nothing else sets the motion going, else 0
  std::optional<double> velocity{};  // [m/s] at t = 0; 0
  /// [s] > 0; by default 1/200 of the shorter of natural and drive period, under a recorded drive a whole
  /// part of its spacing. A method that chooses its own steps: the spacing of the states.
  std::optional<double> step{};
  /// [s] > 0; by default 20 natural periods, at least to the end of a pulse or chirp; the length of a
  /// recorded drive.
  std::optional<double> until{};
  std::optional<double> tolerance{};      // 1e-15 to 1e-2, relative bound on Newton's last update (1e-12)
                                          // or on an adaptive method's error in a step (1e-9)
  std::optional<double> accuracy{};       ///< 1e-9 to 0.5, in place of step: the largest relative error of
                                          ///< frequency, decay and amplitude over the run
  std::optional<double> beta{}, gamma{};  // of newmark, 0 to 1; 1/4 and 1/2
  std::optional<double> rho_inf{};        // of generalized-alpha, 0 to 1; 0.8
  long long every = 1;                    ///< keep every n-th state, > 0
  /// States in compensated sums, for very long runs by methods of fixed steps: free or under a harmonic
  /// drive, without friction and hysteresis.
  bool compensated = false;
  Progress progress{};
};

/// A run: the kept states (t, x, v), and how it went. It ends early, with a status that says why, where the
/// motion diverges or a step cannot be solved; the states up to there are good.
struct Simulation : Trajectory {
  std::vector<double> energy;  // [J] kinetic and potential, one for each state
  Status status = Status::reached_end;
  bool interrupted = false;  ///< progress asked for it (the status is then stopped_by_event)
  std::string message;       ///< why it ended early, in English; "" where it did not
  Counts counts;
  double step = 0;                                     // [s] as used
  std::optional<MethodEffect> effect{};                ///< what the method really simulates, of linear laws
  std::vector<Notice> notices;                         ///< what else there is to know
  std::shared_ptr<const core::SimulateResult> detail;  ///< for document.h

  bool succeeded() const { return status == Status::reached_end && !interrupted; }
};

/// Integrates from t = 0. An Error names the argument, its value and what it must be: a method that does not
/// exist or cannot integrate this law, a step that is not positive, more states than can be held; a law
/// without a natural period under no periodic drive, unless `step` and `until` are both given.
CROMER_API Result<Simulation> simulate(const Oscillator& oscillator, const SimulateOptions& options = {});

}  // namespace cromer
