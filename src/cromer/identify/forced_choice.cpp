#include "cromer/identify/forced_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cromer/identify/choose/criterion.h"

namespace cromer {
namespace {

constexpr std::size_t enough_samples = 100'000;

bool converged(const ForcedFit& fit) { return fit.law.status == FitStatus::converged; }

bool excludes_zero(const Estimate& term) { return term.low > 0 || term.high < 0; }

// Every term that the linear law lacks shows itself.
bool needs_its_terms(const ForcedFit& fit) {
  if (fit.law.drag && !excludes_zero(*fit.law.drag)) return false;
  return !fit.law.cubic || excludes_zero(*fit.law.cubic) || excludes_zero(*fit.quadratic);
}

ForcedTerms terms_of(const ForcedFit& fit) { return {fit.law.law.drag, fit.law.law.cubic}; }

// The converged one that leaves least; the first if none converged.
std::size_t closest(const std::vector<ForcedFit>& fits) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < fits.size(); ++i)
    if (converged(fits[i]) &&
        (!converged(fits[best]) || fits[i].law.residual.rms < fits[best].law.residual.rms))
      best = i;
  return best;
}

// Of as many samples as are independent. The quantities count one name more than there are parameters, which
// tells no candidate from another. Residuals below what rounding leaves only follow the rounding's pattern.
void set_criterion(std::vector<ForcedFit>& fits, double independent, double resolution) {
  for (ForcedFit& fit : fits)
    if (fit.law.residual.rms > 0 && independent > 0)
      fit.law.bic =
          bayesian_criterion(independent, std::max(fit.law.residual.rms, resolution / std::sqrt(12.0)),
                             static_cast<double>(fit.law.names.size()));
}

constexpr double strong = 6;  // see criterion.h

// What one fit makes of the coefficients that another makes otherwise, in its own standard errors.
std::string differences(const ForcedFit& chosen, const ForcedFit& other) {
  std::string text;
  const auto compare = [&](const char* what, const Estimate& here, const Estimate& there) {
    const double off = std::abs(there.value - here.value) / here.standard_error;
    if (!(off > 1)) return;
    text += fmt::format("{}{} {:.6g} ({:.1f} of its standard errors away)", text.empty() ? "" : ", ", what,
                        there.value, off);
  };
  const auto compare_both = [&](const char* what, const std::optional<Estimate>& here,
                                const std::optional<Estimate>& there) {
    if (here && there) compare(what, *here, *there);
  };
  compare("angular frequency", chosen.law.angular_frequency, other.law.angular_frequency);
  compare("decay rate", chosen.law.decay_rate, other.law.decay_rate);
  compare_both("drag", chosen.law.drag, other.law.drag);
  compare_both("cubic", chosen.law.cubic, other.law.cubic);
  compare_both("force gain", chosen.force_gain, other.force_gain);
  return text;
}

// Other readings of the force, under the same law, that leave about as little. Fills the choice's candidates
// with them; where the straight line between samples is one of them it is taken, as the plainest.
void settle_reading(ForcedChoice& choice, const ForcedRecord& record, double independent,
                    const Watch& watch) {
  if (!converged(choice.chosen)) return;
  const ForcedTerms terms = terms_of(choice.chosen);
  const auto criterion_off = [&](const ForcedFit& other, const ForcedFit& same_law) {
    return independent * 2 * std::log(other.law.residual.rms / same_law.law.residual.rms);
  };
  std::vector<ForcedFit> alike;
  for (const ForcedFit& reading : std::vector<ForcedFit>(choice.candidates)) {
    if (!converged(reading) || reading.between == choice.chosen.between || watch.interrupted()) continue;
    constexpr double worth_a_fit = 30;
    if (criterion_off(reading, choice.chosen) > worth_a_fit) continue;
    ForcedFit fit = reading;
    if (terms_of(reading) != terms || reading.motion.empty()) {
      const ForcedStart from{
          adapt_forced(reading.parameters, terms_of(reading), terms, RecordedForce::parameters)};
      fit = fit_recorded_force(record, terms, reading.between, from, watch);
      if (terms_of(reading) != terms) choice.candidates.push_back(fit);
    }
    if (converged(fit) && std::abs(criterion_off(fit, choice.chosen)) < strong)
      alike.push_back(std::move(fit));
  }
  if (alike.empty()) return;
  for (ForcedFit& fit : alike)
    if (fit.between == ForceBetween::linear) std::swap(fit, choice.chosen);
  for (const ForcedFit& other : alike) {
    const std::string differ = differences(choice.chosen, other);
    choice.chosen.law.warnings.push_back(
        fmt::format("what the force did between its samples is open: taken as {} it leaves {:.4g}, as {} "
                    "{:.4g}, too little "
                    "apart to tell{}{}; --between-samples says which, if it is known",
                    name(choice.chosen.between), choice.chosen.law.residual.rms, name(other.between),
                    other.law.residual.rms, differ.empty() ? "" : "; the other would make the ", differ));
  }
}

ForcedChoice choose_on(const ForcedRecord& record, const std::optional<ForcedTerms>& terms,
                       const std::optional<ForceBetween>& between, const Watch& watch) {
  ForcedTerms first = terms.value_or(ForcedTerms{.curved = true});
  std::vector<ForceBetween> readings{ForceBetween::band_limited, ForceBetween::linear, ForceBetween::hold};
  if (between) readings = {*between};
  std::vector<ForcedFit> by_reading;
  std::optional<ForcedStart> start;
  for (const ForceBetween reading : readings) {
    ForcedFit fit = fit_recorded_force(record, first, reading, start, watch);
    if (!terms && !converged(fit) && first.curved) {
      first.curved = false;
      fit = fit_recorded_force(record, first, reading, {}, watch);
    }
    if (converged(fit) && (!start || fit.law.residual.rms < start->rms_to_beat))
      start = ForcedStart{fit.parameters, fit.law.residual.rms};
    by_reading.push_back(std::move(fit));
    if (watch.progress) watch.progress(0.15 * static_cast<double>(by_reading.size()));
  }
  const std::size_t best = closest(by_reading);
  ForcedChoice choice;
  std::vector<ForcedFit> laws{by_reading[best]};
  if (!terms && converged(laws.front())) {
    for (const ForcedTerms& other : {ForcedTerms{}, ForcedTerms{.drag = true}, ForcedTerms{.curved = true},
                                     ForcedTerms{.drag = true, .curved = true}}) {
      if (other == first || watch.interrupted()) continue;
      const ForcedStart from{adapt_forced(laws.front().parameters, first, other, RecordedForce::parameters),
                             laws.front().law.residual.rms};
      laws.push_back(fit_recorded_force(record, other, laws.front().between, from, watch));
    }
  }
  choice.chosen = laws[judge_forced(laws, record.resolution)];
  by_reading.erase(by_reading.begin() + static_cast<std::ptrdiff_t>(best));
  const double independent = laws[closest(laws)].law.independent_samples;
  choice.candidates = std::move(laws);
  std::move(by_reading.begin(), by_reading.end(), std::back_inserter(choice.candidates));
  if (!between) settle_reading(choice, record, independent, watch);
  set_criterion(choice.candidates, independent, record.resolution);
  for (ForcedFit& fit : choice.candidates) fit.motion = {};
  if (watch.interrupted() && converged(choice.chosen)) {
    choice.chosen.law.status = FitStatus::iteration_limit;
    choice.chosen.law.message = "interrupted before all laws were tried";
  }
  return choice;
}

}  // namespace

std::size_t judge_forced(std::vector<ForcedFit>& candidates, double resolution) {
  set_criterion(candidates, candidates[closest(candidates)].law.independent_samples, resolution);
  const auto stands = [&](std::size_t i) {
    return converged(candidates[i]) && needs_its_terms(candidates[i]);
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < candidates.size(); ++i)
    if (stands(i) && (!stands(best) || candidates[i].law.bic < candidates[best].law.bic)) best = i;
  return best;
}

ForcedChoice choose_forced(const ForcedRecord& record, const std::optional<ForcedTerms>& terms,
                           const std::optional<ForceBetween>& between, const Watch& watch) {
  if (record.fitted <= 2 * enough_samples) return choose_on(record, terms, between, watch);
  ForcedRecord part = record;
  part.fitted = enough_samples;
  part.t = record.t.first(enough_samples);
  part.y = record.y.first(enough_samples);
  ForcedChoice choice = choose_on(part, terms, between, watch);
  if (!converged(choice.chosen)) return choice;
  choice.chosen = fit_recorded_force(record, terms_of(choice.chosen), choice.chosen.between,
                                     ForcedStart{choice.chosen.parameters}, watch);
  choice.chosen.law.warnings.push_back(
      fmt::format("the laws were compared on the first {} of {} samples; the one chosen is fitted to all",
                  enough_samples, record.fitted));
  return choice;
}

}  // namespace cromer
