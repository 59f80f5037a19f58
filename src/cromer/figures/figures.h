// What each task draws, as figures.
#pragma once

#include <vector>

#include "cromer/report/figure.h"
#include "cromer/result.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

/// Positions of simulated runs in one plot: methods by their own colours, the exact solution first; one
/// method at several drive frequencies as an ordered family. A run that grows without end is cut at the frame
/// and said to grow.
Figure simulate_figure(const SimulateResult& result);

/// Motion and residual of each recording that could be fitted, one above the other, and what else its fit
/// shows (decay, samples held out, hysteretic swings); measured samples alone of one that could not. More
/// than three recordings stand in a grid.
Figure fit_figure(const std::vector<FittedRecording>& fits);

/// One panel for each recording: the measured motion, and its simulations over it.
Figure compare_figure(const std::vector<CompareResult>& comparisons);

/// One panel for each measure. Over one option a curve; over two, of which the outer takes at most five
/// values, a curve for each of them, else a map. An Error where more than two are swept.
Result<Figure> sweep_figure(const SweepResult& result);

/// Pseudo-acceleration against period (of two components with their rotations), or a shock spectrum against
/// frequency.
Figure spectrum_figure(const SpectrumResult& result);

/// Pseudo-velocity against period, both logarithmic, over lines of equal displacement and acceleration.
Figure tripartite_figure(const SpectrumResult& result);

/// Position at rest against mass, and what the line leaves.
Figure static_figure(const StaticStiffness& found);

/// Period squared against mass, and what the line leaves.
Figure mass_line_figure(const MassLine& line);

}  // namespace cromer::core
