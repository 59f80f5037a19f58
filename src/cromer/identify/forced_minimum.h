// The least-squares minimum of a forced motion, as fine in time as its residuals ask for.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/identify/forced_fit.h"
#include "cromer/identify/forced_motion.h"
#include "cromer/identify/forced_quantities.h"
#include "cromer/identify/least_squares/levenberg_marquardt.h"
#include "cromer/identify/least_squares/rounding_bias.h"

namespace cromer {

struct ForcedMinimum {
  LeastSquaresSummary summary;
  double step = 0;             // [s] of the method
  Parameters rounding_bias{};  ///< by how much the rounding of the values may have moved the parameters
};

/// Rms of z over the samples that are there.
double rms_of(std::span<const double> z);

/// How many samples are there.
std::size_t samples_of(std::span<const double> z);

/// The rms difference between the motions at steps of h and of h/2.
template <class MakeDrive>
double method_error(const MakeDrive& drive, ForcedTerms terms, const Parameters& p,
                    const ForcedSamples& samples, double h) {
  const auto motion = [&](double step) {
    return forced_motion(terms, p, drive(p, step), samples.t, samples.derivative, step);
  };
  const std::vector<double> z = motion(h), finer = motion(h / 2);
  double sum = 0;
  const std::size_t n = std::min(z.size(), finer.size());
  for (std::size_t i = 0; i < n; ++i) sum += (z[i] - finer[i]) * (z[i] - finer[i]);
  return std::sqrt(sum / static_cast<double>(n));
}

/// Steps fine enough to begin with: the method is off by less than a two-hundredth of the motion in the
/// beginning of the record.
template <class MakeDrive>
double coarse_step(const MakeDrive& drive, ForcedTerms terms, const Parameters& start,
                   const ForcedSamples& samples) {
  const ForcedLayout at = forced_layout(decltype(drive(start, 1.0))::parameters, terms);
  const double spacing = (samples.t.back() - samples.t.front()) / static_cast<double>(samples.t.size() - 1);
  double h = std::min(spacing, 0.5 / std::sqrt(start[at.stiffness]));
  const auto beginning = samples.first(std::min<std::size_t>(samples.t.size(), 1000));
  const double enough = 0.005 * rms_of(samples.z);
  for (int halvings = 0; halvings < 4; ++halvings, h /= 2)
    if (method_error(drive, terms, start, beginning, h) < enough) break;
  return h;
}

/// `drive(parameters, h)` makes the drive for steps of h. Coarse steps first, then halved until the method's
/// error, measured by halving, could move no parameter by a tenth of its standard error; only those if they
/// leave 1.2 times `rms_to_beat`.
template <class MakeDrive>
ForcedMinimum minimise_forced(const MakeDrive& drive, ForcedTerms terms, const Parameters& start,
                              const ForcedSamples& samples, double rms_to_beat, const Watch& watch) {
  using Drive = decltype(drive(start, 1.0));
  const ForcedLayout at = forced_layout(Drive::parameters, terms);
  const auto n = static_cast<double>(samples_of(samples.z));
  LeastSquaresOptions options;
  options.scale = rms_of(samples.z) * std::sqrt(n);
  options.residuals = static_cast<int>(n);
  options.lower[at.decay] = 0;
  if (at.drag >= 0) options.lower[at.drag] = 0;

  ForcedMinimum at_minimum;
  double& h = at_minimum.step;
  LeastSquaresSummary& summary = at_minimum.summary;
  summary.parameters = start;
  const auto minimise_at = [&](double error_tolerance, int iteration_limit) {
    options.error_tolerance = error_tolerance;
    options.iteration_limit = iteration_limit;
    const auto model = [&](const Parameters& p) {
      NormalEquations nowhere;
      nowhere.sum_of_squares = HUGE_VAL;
      const bool possible = p[at.stiffness] > 0 && !watch.interrupted();
      return possible ? forced_equations(terms, p, drive(p, h), samples, h) : nowhere;
    };
    const int before = summary.iterations;
    summary = minimise(model, summary.parameters, options);
    summary.iterations += before;
  };

  h = coarse_step(drive, terms, start, samples);
  minimise_at(1e-2, 40);
  if (summary.equations.sum_of_squares > 1.44 * rms_to_beat * rms_to_beat * n) return at_minimum;
  for (int halvings = 0; halvings < 6 && summary.reason == LeastSquaresReason::converged; ++halvings) {
    const double error = method_error(drive, terms, summary.parameters, samples, h);
    // A standard error moves the motion by one residual's rms in all.
    if (error * error * n <= 0.01 * summary.equations.sum_of_squares / n) break;
    h /= 2;
  }
  minimise_at(1e-3, 40);
  return at_minimum;
}

/// Sets the minimum's rounding_bias; none where samples are missing. `motion` is the law's, from the same
/// level as the samples.
template <class MakeDrive>
void find_rounding_bias(ForcedMinimum& minimum, const MakeDrive& drive, ForcedTerms terms,
                        const ForcedSamples& samples, std::span<const double> motion, double resolution) {
  if (samples_of(samples.z) != samples.t.size() || motion.size() < samples.t.size()) return;
  std::vector<double> residuals(samples.z.size());
  for (std::size_t i = 0; i < residuals.size(); ++i) residuals[i] = samples.z[i] - motion[i];
  const std::vector<double> rounded = rounded_motion({samples.t, samples.z, resolution}, residuals);
  if (rounded.empty()) return;
  const LeastSquaresSummary& summary = minimum.summary;
  const Parameters& p = summary.parameters;
  const NormalEquations pull = forced_equations(terms, p, drive(p, minimum.step),
                                                {samples.t, rounded, samples.derivative}, minimum.step);
  const SquareMatrix inverse_matrix = inverse(summary.equations.matrix, pull.size);
  for (int i = 0; i < pull.size; ++i)
    for (int j = 0; j < pull.size; ++j) minimum.rounding_bias[i] += inverse_matrix[i][j] * pull.right[j];
}

/// The parameters of a linear motion Y as those of the motion x whose derivative it is, from where x rests;
/// `pull` is the drive's acceleration of x at the first time. What Y rests at becomes the sensor's offset if
/// `observed`.
void integrate_start(Parameters& parameters, const ForcedLayout& at, double pull, bool observed);

/// Of states as forced_layout has them, the displacements from the law's equilibrium.
Trajectory states_from_rest(Trajectory states, const FreeDecay& law);

/// Fills a fit from its minimum; its motion is there already, at all times `t` at least.
void describe_forced(ForcedFit& fit, const ForcedMinimum& minimum, const ForcedQuantities& quantities,
                     std::span<const double> t, std::span<const double> y, double resolution);

/// A minimum was found, but its law accounts for less than three tenths of the motion's variance: it is not
/// the one.
inline bool explains_too_little(const ForcedFit& fit) {
  constexpr double least = 0.3;
  return fit.law.status == FitStatus::converged && fit.law.explained < least;
}

}  // namespace cromer
