#include "cromer/identify/driven_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/identify/driven_motion.h"
#include "cromer/identify/start/driven_start.h"
#include "cromer/identify/forced_minimum.h"

namespace cromer {

ForcedFit fit_driven(const Record& record, ForcedTerms terms, std::optional<double> drive,
                     const std::optional<Parameters>& start, const Watch& watch) {
  ForcedFit fit;
  fit.law.law = Law{true, terms.drag, false, terms.curved};
  const auto refuse = [&](FitStatus status, std::string message) {
    fit.law.status = status;
    fit.law.message = std::move(message);
    return fit;
  };
  const ForcedLayout at = forced_layout(SinusoidalForce::parameters, terms);
  if (record.t.size() < std::max<std::size_t>(32, 3 * static_cast<std::size_t>(at.size)))
    return refuse(
        FitStatus::too_short,
        fmt::format("{} samples are too few for the {} parameters of this law", record.t.size(), at.size));
  double level = 0;
  for (double y : record.y) level += y / static_cast<double>(record.y.size());
  std::vector<double> z(record.y.begin(), record.y.end());
  for (double& value : z) value -= level;
  if (!(rms_of(z) > 1e-14 * std::abs(level)))
    return refuse(FitStatus::no_oscillation, "nothing moves: all values are equal");

  const ForcedSamples samples{record.t, z, record.derivative};
  std::optional<Parameters> first = start;
  if (!first) {
    first = driven_start({record.t, z, record.resolution, record.derivative}, drive);
    if (!first) return refuse(FitStatus::no_oscillation, "no oscillation found: the spectrum has no line");
    first = adapt_forced(*first, {}, terms, SinusoidalForce::parameters);
  }
  const auto make_drive = [&](const Parameters& p, double) {
    return SinusoidalForce(p[SinusoidalForce::frequency]);
  };
  ForcedMinimum minimum = minimise_forced(make_drive, terms, *first, samples, HUGE_VAL, watch);
  if (watch.interrupted()) return refuse(FitStatus::iteration_limit, "interrupted before the fit was done");
  fit.parameters = minimum.summary.parameters;
  fit.motion = forced_motion(terms, fit.parameters, make_drive(fit.parameters, 0), record.t,
                             record.derivative, minimum.step);
  find_rounding_bias(minimum, make_drive, terms, samples, fit.motion, record.resolution);
  for (double& value : fit.motion) value += level;
  const ForcedQuantities quantities = driven_quantities(fit.parameters, terms, level, record.derivative);
  if (!(quantities.values.front() > 0))
    return refuse(FitStatus::no_oscillation, "no oscillation found: the law has no stiffness where it rests");
  describe_forced(fit, minimum, quantities, record.t, record.y, record.resolution);
  fit.states = states_from_rest(forced_states(terms, fit.parameters, make_drive(fit.parameters, 0), record.t,
                                              record.derivative, minimum.step),
                                fit.law);
  if (explains_too_little(fit))
    return refuse(FitStatus::too_noisy,
                  fmt::format("a decaying and a steady oscillation account for {:.1f} % of the variance only",
                              100 * std::max(0.0, fit.law.explained)));
  return fit;
}

ForcedChoice choose_driven(const Record& record, const std::optional<ForcedTerms>& terms,
                           std::optional<double> drive, const Watch& watch) {
  std::vector<ForcedFit> fits;
  const ForcedTerms first = terms.value_or(ForcedTerms{});
  // The linear law leads the way: it has the widest valley.
  fits.push_back(fit_driven(record, ForcedTerms{}, drive, {}, watch));
  const bool usable = fits.front().law.status == FitStatus::converged ||
                      fits.front().law.status == FitStatus::iteration_limit;
  if (usable) {
    const Parameters start = fits.front().parameters;
    for (const ForcedTerms& other : {ForcedTerms{.drag = true}, ForcedTerms{.curved = true},
                                     ForcedTerms{.drag = true, .curved = true}}) {
      if (watch.interrupted() || (terms && other != first)) continue;
      fits.push_back(fit_driven(record, other, drive,
                                adapt_forced(start, {}, other, SinusoidalForce::parameters), watch));
      if (watch.progress) watch.progress(0.25 * static_cast<double>(fits.size()));
    }
    if (terms && first != ForcedTerms{}) fits.erase(fits.begin());
  }
  ForcedChoice choice;
  choice.chosen = fits[judge_forced(fits, record.resolution)];
  choice.candidates = std::move(fits);
  for (ForcedFit& fit : choice.candidates) fit.motion = {};
  return choice;
}

}  // namespace cromer
