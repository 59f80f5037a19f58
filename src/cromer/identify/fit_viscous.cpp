#include "cromer/identify/fit_viscous.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cromer/base/dual.h"
#include "cromer/base/pi.h"
#include "cromer/base/state.h"
#include "cromer/identify/describe_fit.h"
#include "cromer/identify/diagnose/refusal.h"
#include "cromer/identify/fit_settings.h"
#include "cromer/identify/least_squares/noise.h"
#include "cromer/identify/motion/damped_phasor.h"
#include "cromer/identify/start/start_values.h"

namespace cromer::core {
namespace {

// The viscous law in the phasor's own parameters, grown from a first part to the whole record. `least` is the
// lowest decay rate that may be.
Minimum fit_phasor(const Record& record, StartValues start, double least, const LawFitOptions& options,
                   const Watch& watch) {
  Minimum minimum;
  double& decay_rate = start.phasor[DampedPhasor::decay_rate];
  decay_rate = std::max(least, decay_rate);
  int iterations = 0;
  for (;;) {
    if (start.samples < record.t.size()) start = grown(record, start);
    const Record part = record.part(start.first, start.samples);
    LeastSquaresOptions settings = least_squares_options(part, options);
    const double duration = part.t.back() - part.t.front();
    settings.lower[DampedPhasor::angular_frequency] = 1e-3 / duration;
    settings.lower[DampedPhasor::decay_rate] = least;
    const bool whole = start.samples == record.t.size();
    const auto model = interruptible(DampedPhasor(part), watch);
    // Near critical damping the sum of squares is a long valley: many short steps lead to its minimum. The
    // limit is there for what has none.
    if (2 * decay_rate > start.phasor[DampedPhasor::angular_frequency]) settings.iteration_limit *= 4;
    if (whole) {
      minimum = minimise_both(model, start.phasor, settings);
      break;
    }
    settings.error_tolerance = 1e-2;
    const LeastSquaresSummary summary = minimise(model, start.phasor, settings);
    start.phasor = summary.parameters;
    start.frequency_error = frequency_error(summary, start.samples);
    iterations += summary.iterations;
  }
  minimum.bounded.iterations += iterations;
  return minimum;
}

// The law's parameters from those of the phasor, over any scalar: of the displacement, whatever its
// derivative in the record.
template <class Real>
struct Converted {
  Real angular_frequency, decay_rate, equilibrium;
  State<Real> start;
};

template <class Real>
Converted<Real> converted(const Real& w, const Real& g, const Real& E, const Real& A, const Real& B,
                          int derivative) {
  using std::hypot;
  const Real w0 = hypot(w, g);
  State<Real> y{A, w * B - g * A};
  // What obeys x'' = -w0² x - 2 g x' is the derivative of something that does.
  for (int i = 0; i < derivative; ++i) y = {-(y.v + Real(2) * g * y.x) / (w0 * w0), y.x};
  return {w0, g, E, y};
}

Motion motion_of_phasor(const Parameters& p, int derivative) {
  const auto c = converted<double>(p[DampedPhasor::angular_frequency], p[DampedPhasor::decay_rate],
                                   p[DampedPhasor::equilibrium], p[DampedPhasor::cosine],
                                   p[DampedPhasor::sine], derivative);
  Motion motion{.equilibrium = c.equilibrium, .position = c.start.x, .velocity = c.start.v};
  motion.set_angular_frequency(c.angular_frequency);
  motion.set_decay_rate(c.decay_rate);
  return motion;
}

// Row by row, of angular_frequency, decay_rate, equilibrium, position and velocity.
SquareMatrix jacobian_of(const Parameters& p, int derivative) {
  constexpr int n = DampedPhasor::parameter_count;
  using Real = Dual<double, n>;
  const auto variable = [&](int i) { return Real::variable(p[i], static_cast<std::size_t>(i)); };
  const auto c = converted<Real>(variable(0), variable(1), variable(2), variable(3), variable(4), derivative);
  SquareMatrix jacobian{};
  const Real rows[] = {c.angular_frequency, c.decay_rate, c.equilibrium, c.start.x, c.start.v};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) jacobian[i][j] = rows[i].derivative[static_cast<std::size_t>(j)];
  return jacobian;
}

/// Of the observed motion, sample by sample, with respect to angular_frequency, decay_rate, equilibrium,
/// position and velocity: the waveform's own derivatives, and those of the phasor by the motion.
std::vector<double> sample_jacobian(const Motion& motion, const Record& record) {
  constexpr int n = DampedPhasor::parameter_count;
  using Real = Dual<double, n>;
  const auto variable = [](double value, std::size_t i) { return Real::variable(value, i); };
  const Real w0 = variable(motion.angular_frequency(), 0), g = variable(motion.decay_rate(), 1);
  const Real E = variable(motion.equilibrium, 2);
  State<Real> y{variable(motion.position, 3), variable(motion.velocity, 4)};
  for (int i = 0; i < record.derivative; ++i) y = {y.v, -w0 * w0 * y.x - Real(2) * g * y.v};
  const Real w = sqrt(w0 * w0 - g * g), A = y.x, B = (y.v + g * y.x) / w;
  std::vector<double> rows;
  rows.reserve(n * record.t.size());
  for (const double t : record.t) {
    const Real s(t - record.t.front());
    const Real value = E + exp(-g * s) * (A * cos(w * s) + B * sin(w * s));
    rows.insert(rows.end(), value.derivative.begin(), value.derivative.end());
  }
  return rows;
}

// Whether two frequencies come apart by half a turn from one sample to the next: a period can be lost there.
bool part_in_a_gap(std::span<const double> t, double one, double other) {
  double longest = 0;
  for (std::size_t i = 1; i < t.size(); ++i) longest = std::max(longest, t[i] - t[i - 1]);
  return std::abs(one - other) * longest > pi;
}

LawFit fit_from(const StartValues& start, const Record& record, const LawFitOptions& options,
                const Watch& watch) {
  LawFit fit;
  fit.law = law_of("viscous");
  const FittedParameters fitted = fitted_parameters(fit.law, DriveKind::none, {}, {}, options.may_grow);
  const double least = fitted.lower_bounds()[fitted.place_of("decay_rate")];
  const Minimum minimum = fit_phasor(record, start, least, options, watch);
  if (watch.interrupted()) return interrupted_fit(options, watch);
  fit.iterations = minimum.bounded.iterations;
  const Parameters& p = minimum.bounded.parameters;
  const Motion motion = motion_of_phasor(p, record.derivative);

  // The same covariance, for the motion's parameters.
  constexpr int n = DampedPhasor::parameter_count;
  const SquareMatrix jacobian = jacobian_of(p, record.derivative);
  const SquareMatrix phasor_inverse = inverse(minimum.free.equations.matrix, n);
  SquareMatrix inverse_matrix{};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        for (int l = 0; l < n; ++l)
          inverse_matrix[i][j] += jacobian[i][k] * phasor_inverse[k][l] * jacobian[j][l];

  std::vector<double> residuals;
  DampedPhasor(record).residuals(p, residuals);
  Parameters bias{};
  if (const std::vector<double> y = rounded_motion(record, residuals); !y.empty()) {
    const Parameters right = DampedPhasor({record.t, y, 0})(p).right;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) bias[i] += jacobian[i][k] * phasor_inverse[k][j] * right[j];
  }
  const double w0 = motion.angular_frequency();
  fit.step = motion_step(w0, record.t.back() - record.t.front(), 1e-9);
  DescribedMinimum described{
      .fitted = fitted,
      .parameters = fitted.pack(motion),
      .without_bounds = fitted.pack(motion_of_phasor(minimum.free.parameters, record.derivative)),
      .matrix = inverse(inverse_matrix, n),
      .rounding_bias = bias,
      .residuals = residuals};
  described.jacobian = [&] { return sample_jacobian(motion, record); };
  describe_fit(fit, record, described);
  set_status(fit, minimum.bounded.reason);
  // Twice the logarithm of the likelihoods' ratio: one in four hundred by chance.
  constexpr double as_good = 12;
  if (start.rival > 0 && start.rival_excess * fit.independent_samples < as_good &&
      part_in_a_gap(record.t, start.rival, w0))
    fit.notices.push_back(Notice{"periods_in_gaps_unsure", {{"rival", start.rival}, {"frequency", w0}}});
  if (const auto refusal = refuse_fit(record, fit)) refuse(fit, *refusal);
  return fit;
}

}  // namespace

LawFit fit_sinusoid(const Record& record, const LawFitOptions& options, const Watch& watch) {
  const std::optional<StartValues> start = find_start_values(record);
  if (!start) {
    LawFit fit;
    fit.law = law_of("viscous");
    fit.status = FitStatus::no_oscillation;
    fit.message = Notice{"no_line"};
    return fit;
  }
  return or_growing(fit_from(*start, record, options, watch), options,
                    [&](const LawFitOptions& growing) { return fit_from(*start, record, growing, watch); });
}

std::optional<FirstPeriods> fit_first_periods(const Record& record, double angular_frequency,
                                              const LawFitOptions& options, const Watch& watch) {
  std::optional<FirstPeriods> longest;
  for (const double periods : {8, 6, 4, 3, 2}) {
    const Record beginning = first_periods(record, angular_frequency, periods);
    if (beginning.t.size() >= record.t.size()) continue;
    FirstPeriods first{fit_sinusoid(beginning, options, watch), beginning.t.size()};
    if (first.fit.status != FitStatus::converged) continue;
    if (first.clear()) return first;
    if (!longest) longest = std::move(first);
  }
  return longest;
}

// A swing whose frequency changes as it decays leaves a sinusoid out of step, and is an oscillation all the
// same: its first periods show it.
LawFit fit_viscous(const Record& record, const LawFitOptions& options, const Watch& watch) {
  LawFit fit = fit_sinusoid(record, options, watch);
  const bool refused = fit.status == FitStatus::no_oscillation || fit.status == FitStatus::too_noisy;
  if (!refused || !(fit.angular_frequency().value > 0)) return fit;
  const auto first = fit_first_periods(record, fit.angular_frequency().value, options, watch);
  if (first && first->clear()) {
    fit.status = FitStatus::converged;
    fit.message = {};
    fit.notices.push_back(Notice{"frequency_changes", {{"percent", 100 * std::max(0.0, fit.explained)}}});
  }
  return fit;
}

}  // namespace cromer::core
