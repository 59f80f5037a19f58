// One simulation laid beside a recording.
#pragma once

#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/identify/motion/motion_model.h"
#include "cromer/result.h"
#include "cromer/tasks/compare/compare.h"

namespace cromer::core {

struct NamedLaw {
  std::string label;
  Law law;
  Motion motion;  ///< from the recording's first sample on
};

/// Runs the law by the method and step of the options over the recording's times. Samples set aside are in no
/// figure. A run that ended early, or that grows tenfold, is a notice. The law must be one that the method
/// can integrate, else an Error.
Result<ComparedCurve> simulate_curve(const FittedRecording& recording, const NamedLaw& law,
                                     const CompareOptions& options, double step, std::vector<Notice>& notices,
                                     const Watch& watch);

}  // namespace cromer::core
