#include "cromer/identify/choose/readings.h"

#include <algorithm>
#include <cmath>

#include "cromer/identify/choose/criterion.h"

namespace cromer::core {
namespace {

bool converged(const LawFit& fit) { return fit.status == FitStatus::converged; }

// Place of the fit that leaves least.
std::size_t best_reading(const std::vector<LawFit>& fits) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < fits.size(); ++i)
    if (converged(fits[i]) && (!converged(fits[best]) || fits[i].residual.rms < fits[best].residual.rms))
      best = i;
  return best;
}

// Parameters that the other fit puts more than one of the chosen one's standard errors away.
std::vector<Notice> differences(const LawFit& chosen, const LawFit& other) {
  std::vector<Notice> found;
  for (std::size_t i = 0; i < chosen.names.size(); ++i) {
    if (is_of_the_start(chosen.names[i])) continue;
    const Estimate &here = chosen.estimates[i], there = other[chosen.names[i]];
    const double off = std::abs(there.value - here.value) / here.standard_error;
    if (!(off > 1)) continue;
    found.push_back(Notice{"parameter_elsewhere",
                           {{"parameter", parameter_named(chosen.names[i], chosen.law)},
                            {"value", there.value},
                            {"errors", off}}});
  }
  return found;
}

// The spread between readings that stay open, each with its weight, into the chosen one's errors.
void spread_over_readings(LawFit& chosen, const std::vector<LawFit>& open) {
  double total = 1;
  std::vector<double> weights;
  for (const LawFit& other : open) {
    weights.push_back(std::exp(-0.5 * (other.bic - chosen.bic)));
    total += weights.back();
  }
  const std::size_t n = chosen.names.size();
  for (std::size_t k = 0; k < open.size(); ++k) {
    std::vector<double> off(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) off[i] = open[k][chosen.names[i]].value - chosen.estimates[i].value;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        chosen.covariance[i * n + j] += weights[k] / total * off[i] * off[j];
  }
  for (std::size_t i = 0; i < n; ++i) {
    Estimate& estimate = chosen.estimates[i];
    const double before = estimate.standard_error,
                 after = std::sqrt(std::max(0.0, chosen.covariance[i * n + i]));
    if (!(before > 0) || !std::isfinite(after)) continue;
    const bool bounded = estimate.low == 0;
    estimate.low = estimate.value - (estimate.value - estimate.low) * after / before;
    estimate.high = estimate.value + (estimate.high - estimate.value) * after / before;
    if (bounded) estimate.low = 0;
    estimate.standard_error = after;
  }
}

}  // namespace

LawChoice choose_reading(const Record& record, const LawFitOptions& options, const GivenLaw& given,
                         const std::function<LawChoice(const LawFitOptions&)>& choose, const Watch& watch) {
  LawFitOptions one = options;
  if (given.between) {
    one.drive.force.between = *given.between;
    return choose(one);
  }
  // Which reading leaves least, under a law that bends where it may; the law under that one; and the other
  // readings under that law.
  const BetweenSamples readings[] = {BetweenSamples::band_limited, BetweenSamples::linear,
                                     BetweenSamples::hold};
  LawFitOptions bent = options;
  bent.law =
      given.law.value_or(options.law.shares(springs) ? law_of("viscous+quadratic+cubic") : options.law);
  std::vector<LawFit> by_reading;
  for (const BetweenSamples between : readings) {
    bent.drive.force.between = between;
    by_reading.push_back(fit_law(record, bent, watch));
    if (!converged(by_reading.back()) && !given.law && options.law.shares(springs)) {
      LawFitOptions linear = bent;
      linear.law = law_of("viscous");
      by_reading.back() = fit_law(record, linear, watch);
    }
    if (converged(by_reading.back()))
      bent.rms_to_beat = std::min(bent.rms_to_beat, by_reading.back().residual.rms);
    if (watch.progress) watch.progress(0.15 * static_cast<double>(by_reading.size()));
  }
  // A search that ended in a false minimum is made again from where another reading's ended.
  constexpr double false_minimum = 1.5;  // times what that one leaves
  const LawFit leading = by_reading[best_reading(by_reading)];
  for (std::size_t i = 0; i < by_reading.size() && converged(leading) && !watch.interrupted(); ++i) {
    if (converged(by_reading[i]) && by_reading[i].residual.rms < false_minimum * leading.residual.rms)
      continue;
    LawFitOptions again = bent;
    again.law = leading.law;
    again.drive.force.between = readings[i];
    again.rms_to_beat = HUGE_VAL;
    // Through much of a strongly bent motion the two part: from its beginning on.
    again.start = KnownMotion{leading.motion, std::min<std::size_t>(record.t.size(), 50), 0};
    LawFit fit = fit_law(record, again, watch);
    if (converged(fit) && !(fit.residual.rms > by_reading[i].residual.rms)) by_reading[i] = std::move(fit);
  }
  // The law under one reading, and the other readings under that law.
  std::vector<LawFit> open;
  const auto choose_under = [&](std::size_t best) {
    one.drive.force.between = readings[best];
    if (by_reading[best].has_values() && given.law)
      one.start = KnownMotion{by_reading[best].motion, record.t.size(), 0};
    LawChoice choice = choose(one);
    open.clear();
    if (!converged(choice.chosen) || watch.interrupted()) return choice;
    const double independent = choice.chosen.independent_samples;
    const Criterion criterion({&choice.chosen}, record.resolution);
    choice.chosen.bic = criterion.of(choice.chosen);
    for (LawFit& candidate : choice.candidates) candidate.bic = criterion.of(candidate);
    for (std::size_t i = 0; i < by_reading.size() && !watch.interrupted(); ++i) {
      if (i == best || !by_reading[i].has_values()) continue;
      // Five times strong evidence: a reading that far behind is not fitted again under the chosen law.
      constexpr double worth_a_fit = 30;
      LawFit other = by_reading[i];
      if (independent * 2 * std::log(other.residual.rms / by_reading[best].residual.rms) < worth_a_fit) {
        LawFitOptions same = options;
        same.law = choice.chosen.law;
        same.drive.force.between = readings[i];
        same.start = KnownMotion{choice.chosen.motion, record.t.size(), 0};
        other = fit_law(record, same, watch);
      }
      other.bic = criterion.of(other);
      choice.candidates.push_back(other);
      if (converged(other) && other.law == choice.chosen.law) open.push_back(std::move(other));
    }
    return choice;
  };
  const std::size_t best = best_reading(by_reading);
  LawChoice choice = choose_under(best);
  // A law that the first choice lacked may have made another reading look best: the law is then chosen again,
  // under the reading that the better law asks for.
  const auto lowest = std::min_element(open.begin(), open.end(),
                                       [](const LawFit& a, const LawFit& b) { return a.bic < b.bic; });
  if (lowest != open.end() && lowest->bic < choice.chosen.bic - strong_evidence && !given.law &&
      !watch.interrupted())
    choice = choose_under(static_cast<std::size_t>(
        std::find(std::begin(readings), std::end(readings), lowest->drive.force.between) -
        std::begin(readings)));
  if (!converged(choice.chosen) || watch.interrupted()) return choice;
  for (LawFit& other : open)
    if (other.bic < choice.chosen.bic) std::swap(other, choice.chosen);
  open.erase(
      std::remove_if(open.begin(), open.end(),
                     [&](const LawFit& other) { return other.bic > choice.chosen.bic + strong_evidence; }),
      open.end());
  if (!open.empty()) spread_over_readings(choice.chosen, open);
  for (const LawFit& other : open) {
    const std::vector<Notice> differ = differences(choice.chosen, other);
    choice.chosen.notices.push_back(
        Notice{differ.empty() ? "force_between_samples_open" : "force_between_samples_open_and_matters",
               {{"reading", name(choice.chosen.drive.force.between)},
                {"rms", choice.chosen.residual.rms},
                {"other_reading", name(other.drive.force.between)},
                {"other_rms", other.residual.rms},
                {"differences", differ}}});
  }
  return choice;
}

}  // namespace cromer::core
