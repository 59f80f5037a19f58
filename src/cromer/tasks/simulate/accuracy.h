// --accuracy: the largest step with which a method keeps to the law over a run.
#pragma once

#include <optional>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/result.h"

namespace cromer::core {

struct SimulateOptions;
struct SimulatedRun;

/// What was asked, the step that gives it, and the errors measured on a run with that step: relative, of the
/// mean frequency, the mean decay rate and the amplitude at the end.
struct Accuracy {
  double asked = 0;                         ///< 1e-9 to 0.5
  double step = 0;                          // [s] a whole number of them fills the run
  std::optional<double> frequency_error{};  ///< empty where the motion is not a free swing
  std::optional<double> decay_error{};      ///< empty likewise, and where nothing is damped
  double amplitude_error = 0;               ///< driven: of the steady amplitude, or of the whole motion

  /// The largest of them.
  double worst() const;
};

/// The largest step, to 1 %, that keeps all errors of the run within `asked`; empty for `exact`, which has
/// none. A linear law under a harmonic drive: solved from the oscillator that the method really simulates,
/// then measured on a free run. Other laws and drives: by halving, each trial measured against a fine
/// reference. An Error says why there is none. `options` ask for this one run; its step is not looked at.
Result<std::optional<Accuracy>> find_step(const SimulateOptions& options, const SimulatedRun& run,
                                          const Watch& watch = {});

/// Sets step and accuracy of every run; an Error also where its states would take too much memory.
Result<void> choose_steps(const SimulateOptions& options, std::vector<SimulatedRun>& runs,
                          const Watch& watch);

}  // namespace cromer::core
