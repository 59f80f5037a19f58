// Measured and computed motions as curves of a panel.
#pragma once

#include <string>
#include <vector>

#include "cromer/figures/measured_axis.h"
#include "cromer/report/figure.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

/// A motion at increasing times.
struct SampledMotion {
  std::vector<double> t;  // [s]
  std::vector<double> y;  ///< in the unit of the axis, from the equilibrium
};

/// The samples that the fit was made of, as dots, broken where samples are missing.
Curve measured_curve(const FittedRecording& fitted, const MeasuredAxis& axis);

/// Those and, as crosses that the axes do not follow, the samples set aside.
void add_measured(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis);

/// What the law has less the equilibrium, at the samples of the series (`smooth`: closely enough in time for
/// a smooth curve).
SampledMotion law_motion(const FittedRecording& fitted, const MeasuredAxis& axis, bool smooth);

/// Measured less fitted at the samples of the fit, as dots.
Curve residual_curve(const FittedRecording& fitted, const MeasuredAxis& axis);

/// Whether a recorded force drives it: its swings follow no envelope.
bool irregular(const FittedRecording& fitted);

/// Of an irregular motion some periods about its largest swing: `fitted` with those samples alone, or all of
/// them where it has no period.
FittedRecording largest_swings(const FittedRecording& fitted);

/// What was held out, as a recording of its own.
FittedRecording held_out_part(const FittedRecording& fitted);

/// Adds a computed motion, in the axis's units, with the look of `look`, as a line broken at gaps.
void add_line(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis,
              const SampledMotion& motion, Curve look);

/// The same, or, where its swings are too many to be told apart, as its envelope above and below.
void add_motion(Panel& panel, const FittedRecording& fitted, const MeasuredAxis& axis, SampledMotion motion,
                const Curve& look);

}  // namespace cromer::core
