// The figure of each task.
#pragma once

#include <span>

#include "cromer/figures/panels.h"
#include "cromer/report/figure.h"
#include "cromer/result.h"
#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/spring_constant.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/network_fit/network_fit.h"
#include "cromer/tasks/network_run/network_run.h"
#include "cromer/tasks/simulate/laid_over.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

inline constexpr MotionPanel position_alone[] = {MotionPanel::position};

/// The panels asked for, one under the other, each with all runs. Each method has its own colour, with the
/// exact solution below the others; one method at several drive frequencies is a family of shades. A run that
/// grows without end is cut off and marked.
/// The samples that the runs are laid over are dots in the panel of positions.
Figure simulate_figure(const SimulateResult& result, std::span<const MotionPanel> panels = position_alone,
                       const LaidOver* over = nullptr);

/// The positions of all masses against time, a curve for each; of more than five the first, the last and some
/// between. Of several runs a panel for each mass, of three at most, with a curve for each method.
Figure network_figure(std::span<const NetworkRun> runs);

/// What each mass did, measured and fitted: of many masses the first ones.
Figure network_fit_figure(const FittedNetwork& fitted);

/// Of a network: its drawing, and the shapes of the first modes on it; of many masses as curves over their
/// numbers. Of a recording: the singular values of its spectral matrix with the modes marked, over the
/// stabilisation diagram; beside a network also its shapes on that.
Figure modes_figure(const ModesResult& result);

/// For each recording its motion, its residual, and what else the fit has: samples held out, decay rate
/// against amplitude. A recording that could not be fitted shows its samples alone. More than three
/// recordings share a grid, one panel each.
Figure fit_figure(std::span<const FittedRecording> fits);

/// For each recording the panels asked for, one under the other: the law, one constant rate and the law by
/// each method over the measured motion. More than three recordings share a grid.
Figure compare_figure(std::span<const CompareResult> comparisons,
                      std::span<const MotionPanel> panels = position_alone);

/// One panel for each measure: a curve over one swept option; over two, a curve for each value of the outer
/// one, or a map if it takes more than five. An Error if more than two options are swept.
Result<Figure> sweep_figure(const SweepResult& result);

/// Pseudo-acceleration, or the largest accelerations of a shock, against period or frequency, as asked for.
/// Two components are shown with their geometric mean, RotD50 and RotD100.
Figure spectrum_figure(const SpectrumResult& result);

/// The same of many motions, of two components RotD50 and of a shock the maximax: a panel for each damping
/// ratio, a curve for each motion with the name of its file. Many motions are thin lines under their median
/// and the bounds of 16 and 84 %, very many only these with the lowest and the highest. Without those that
/// could not be computed, which must not be all of them.
Figure spectra_figure(std::span<const MotionSpectra> motions, bool tripartite);

/// Tripartite plot: pseudo-velocity against period, both logarithmic, over lines of equal displacement and of
/// equal pseudo-acceleration.
Figure tripartite_figure(const SpectrumResult& result);

/// Position at rest against mass, and what the line leaves.
Figure static_figure(const StaticStiffness& found);

/// Period squared against mass, and what the line leaves.
Figure mass_line_figure(const MassLine& line);

}  // namespace cromer::core
