#include "cromer/identify/forced_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cromer/identify/forced_minimum.h"
#include "cromer/identify/start/forced_start.h"

namespace cromer {
namespace {

constexpr std::size_t fewest_samples = 32;

// The instrument's zero lies amid the motion: within a tenth of its rms of the mean.
bool zero_is_amid(double mean, double rms) { return std::abs(mean) <= 0.1 * rms; }

// The start where it follows most of the motion; else grown from a first part, in which a frequency that is
// a little off has no time to lose step.
template <class MakeDrive>
Parameters grow(const MakeDrive& drive, ForcedTerms terms, const Parameters& start,
                const ForcedSamples& samples, double spacing, const Watch& watch) {
  const ForcedLayout at = forced_layout(RecordedForce::parameters, terms);
  const double h = coarse_step(drive, terms, start, samples);
  const auto misfit = [&](const Parameters& p) {
    return forced_equations(terms, p, drive(p, h), samples, h).sum_of_squares;
  };
  const double rms = rms_of(samples.z), n = static_cast<double>(samples_of(samples.z));
  const double before = misfit(start);
  constexpr double followed = 0.3;  // of the motion's squares
  if (before < followed * rms * rms * n) return start;
  const double period = 2 * std::numbers::pi / std::sqrt(start[at.stiffness]);
  Parameters grown = start;
  for (auto count = static_cast<std::size_t>(std::max(20 * period / spacing, 64.0));
       count < samples.t.size() && !watch.interrupted(); count *= 2) {
    LeastSquaresOptions options;
    options.scale = rms * std::sqrt(static_cast<double>(count));
    options.residuals = static_cast<int>(count);
    options.error_tolerance = 0.1;
    options.iteration_limit = 12;
    options.lower[at.decay] = 0;
    if (at.drag >= 0) options.lower[at.drag] = 0;
    grown = minimise(
                [&](const Parameters& p) {
                  NormalEquations nowhere;
                  nowhere.sum_of_squares = HUGE_VAL;
                  return p[at.stiffness] > 0
                             ? forced_equations(terms, p, drive(p, h), samples.first(count), h)
                             : nowhere;
                },
                grown, options)
                .parameters;
  }
  return misfit(grown) < before ? grown : start;
}

/// By central differences; for where a fit begins, noise does no harm.
std::vector<double> slopes(const std::vector<double>& values, double spacing) {
  const std::size_t last = values.size() - 1;
  std::vector<double> result(values.size());
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, last);
    result[i] = (values[after] - values[before]) / (static_cast<double>(after - before) * spacing);
  }
  return result;
}

}  // namespace

ForcedFit fit_recorded_force(const ForcedRecord& record, ForcedTerms terms, ForceBetween between,
                             const std::optional<ForcedStart>& start, const Watch& watch) {
  ForcedFit fit;
  fit.law.law = Law{true, terms.drag, false, terms.curved};
  fit.between = between;
  const auto refuse = [&](FitStatus status, std::string message) {
    fit.law.status = status;
    fit.law.message = std::move(message);
    return fit;
  };
  const ForcedLayout at = forced_layout(RecordedForce::parameters, terms);
  const std::span<const double> seen = record.y.first(record.fitted);
  const std::size_t there = samples_of(seen);
  if (there < std::max(fewest_samples, 3 * static_cast<std::size_t>(at.size)))
    return refuse(FitStatus::too_short,
                  fmt::format("{} samples are too few for the {} parameters of this law", there, at.size));
  double level = 0;
  for (double y : seen)
    if (!std::isnan(y)) level += y / static_cast<double>(there);
  std::vector<double> z(seen.begin(), seen.end());
  for (double& value : z) value -= level;
  const double rms = rms_of(z);
  if (!(rms > 1e-14 * std::abs(level)))
    return refuse(FitStatus::no_oscillation, "nothing moves: all values are equal");
  const int derivative = record.derivative;
  const ForcedSamples samples{record.t.first(record.fitted), z, derivative};

  const auto drive = [&](const Parameters&, double h) {
    const int steps = std::max(1, static_cast<int>(std::ceil(record.spacing / h - 1e-9)));
    return RecordedForce(record.force, record.spacing, record.first, between, steps);
  };
  Parameters first;
  if (start) {
    first = start->parameters;
  } else {
    // The derivative of a linear motion is the motion under the force's derivative.
    const bool curved = terms.curved && derivative == 0;
    std::vector<double> force(
        record.force.begin() + static_cast<std::ptrdiff_t>(record.first),
        record.force.begin() + static_cast<std::ptrdiff_t>(record.first + record.fitted));
    std::vector<double> before(static_cast<std::size_t>(derivative), 0.0);  // the force's first values
    for (double& value : before) {
      value = force.front();
      force = slopes(force, record.spacing);
    }
    Parameters found = forced_start(force, samples, record.spacing, curved);
    const ForcedLayout linear = forced_layout(RecordedForce::parameters, {});
    for (int d = derivative; d > 0; --d)
      integrate_start(found, linear, found[RecordedForce::gain] * before[static_cast<std::size_t>(d - 1)],
                      d == derivative);
    first = adapt_forced(found, {.curved = curved}, terms, RecordedForce::parameters);
  }
  if (!(first[at.stiffness] > 0))
    return refuse(FitStatus::no_oscillation, "no oscillation found: the force explains no resonance");
  if (!start) first = grow(drive, terms, first, samples, record.spacing, watch);
  ForcedMinimum minimum =
      minimise_forced(drive, terms, first, samples, start ? start->rms_to_beat : HUGE_VAL, watch);
  if (watch.interrupted()) return refuse(FitStatus::iteration_limit, "interrupted before the fit was done");

  fit.parameters = minimum.summary.parameters;
  fit.motion = forced_motion(terms, fit.parameters, drive(fit.parameters, minimum.step), record.t, derivative,
                             minimum.step);
  find_rounding_bias(minimum, drive, terms, samples, fit.motion, record.resolution);
  for (double& value : fit.motion) value += level;
  const ForcedQuantities quantities =
      recorded_quantities(fit.parameters, terms, level, derivative, zero_is_amid(level, rms));
  if (!(quantities.values.front() > 0))
    return refuse(FitStatus::no_oscillation, "no oscillation found: the law has no stiffness where it rests");
  describe_forced(fit, minimum, quantities, samples.t, seen, record.resolution);
  fit.states = states_from_rest(forced_states(terms, fit.parameters, drive(fit.parameters, minimum.step),
                                              record.t, derivative, minimum.step),
                                fit.law);
  if (explains_too_little(fit))
    return refuse(FitStatus::too_noisy,
                  fmt::format("the force accounts for {:.1f} % of the motion's variance only",
                              100 * std::max(0.0, fit.law.explained)));
  return fit;
}

}  // namespace cromer
