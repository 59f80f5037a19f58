// The same driven oscillator at many frequencies.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <cromer/export.h>
#include <cromer/methods.h>
#include <cromer/notice.h>
#include <cromer/oscillator.h>
#include <cromer/result.h>
#include <cromer/status.h>

namespace cromer {

namespace core {
struct SweepResult;
}

struct SweepOptions {
  Method method = "euler-cromer";
  double drive_amplitude = 1;  // [N] > 0, F
  enum class Direction { each_by_itself, up, down, both };
  Direction direction =
      Direction::each_by_itself;  ///< up, down: each point starts where the one before ended
  std::optional<double> step{};   // [s] > 0; 1/200 of the shorter of natural and drive period
  int threads = 0;                ///< 0: one for each processor
  Progress progress{};
};

/// Settled motions, one value for each frequency (with both directions: up, then down); NaN where a motion
/// does not settle, or was not reached.
struct FrequencyResponse {
  std::vector<double> frequency;  // [rad/s]
  std::vector<double> amplitude;  // [m] of the motion at the drive's frequency
  std::vector<double> phase;      // [rad] lag behind the force
  /// "settled", "settled_by_own_damping" (of the method; the law has none), "not_settled", "unstable",
  /// "not_finite", "no_convergence" or "not_reached".
  std::vector<std::string> status;
  std::string way;  ///< how they were found: "closed form", "stepped until settled", ...
  bool interrupted = false;
  std::vector<Notice> notices;  ///< what else there is to know
  std::shared_ptr<const core::SweepResult> detail{};
};

/// Amplitude and phase of the settled motion, as the method simulates it (the law itself: "exact"), under F
/// cos(w t) at each angular frequency [rad/s] > 0: in closed form of the method's own oscillator where the
/// law is linear, else stepped until the changes still to come are below 1e-6 of the amplitude. A law with
/// hysteresis is refused. An Error names the argument.
CROMER_API Result<FrequencyResponse> sweep(const Oscillator& oscillator,
                                           std::span<const double> drive_frequency,
                                           const SweepOptions& options = {});

}  // namespace cromer
