#include "cromer/tasks/fit/law_doubt.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/base/at_once.h"
#include "cromer/base/pi.h"
#include "cromer/identify/choose/criterion.h"
#include "cromer/tasks/fit/decay_rates.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/fitted_quantities.h"
#include "cromer/tasks/fit/lab_quantities.h"
#include "cromer/tasks/fit/used_samples.h"

namespace cromer::core {
namespace {

// Those of one law of the same motion. `of_spring`: with its own frequency, which beside a hysteretic force
// is not that of small swings.
std::vector<Parameter> common_numbers(const LawFit& fit, const FittedRecording& result,
                                      std::string_view force_unit, bool of_spring) {
  const int derivative = std::max(0, derivative_order(result.series.quantity));
  const std::vector<double>& t = result.series.t;
  std::vector<Parameter> all =
      derived_quantities(fit, unit_of(result.series), derivative,
                         result.driven ? result.driven->states.x : std::vector<double>{}, force_unit);
  for (Parameter& end : decay_rate_ends(fit, t.back() - t.front())) all.push_back(std::move(end));
  const Body body = body_of(result.options);
  const double mass = body.mass ? body.effective_mass().value : 0;
  if (const Estimate* drive = fit.find("drive_amplitude")) {
    all.push_back({"drive_amplitude", *drive, "m/s^2"});
    if (mass > 0) all.push_back({"drive_force", {mass * drive->value, mass * drive->standard_error}, "N"});
  }
  if (!of_spring) return all;
  const Estimate& w = fit.angular_frequency();
  all.push_back({"angular_frequency", w, "rad/s"});
  if (!named(all, "pendulum_length")) all.push_back(pendulum_length(w));
  if (mass > 0)
    all.push_back({"stiffness", {mass * w.value * w.value, 2 * mass * w.value * w.standard_error}, "N/m"});
  return all;
}

// By Akaike's criterion, which holds no term for unlikely before it is seen. What BIC says against it makes
// it fade from a little before strong evidence to a little beyond: there is no step.
double odds_of(const LawFit& other, const LawFit& chosen) {
  const double more = other.fitted - chosen.fitted, n = std::max(3.0, chosen.independent_samples),
               against = other.bic - chosen.bic;
  constexpr double whole = strong_evidence * 2 / 3, none = strong_evidence * 4 / 3, surely = 20;
  return std::exp(0.5 * std::min(surely, more * (std::log(n) - 2) - against)) *
         std::clamp((none - against) / (none - whole), 0.0, 1.0);
}

// Bends of a spring are the first terms of a series: where there are several, what the last one changed shows
// how well all of them together tell the rest. The closest law without one of them; null of fewer.
const LawFit* shorter_series(const LawFit& chosen, const std::vector<LawFit>& candidates) {
  constexpr Law bends = law_with<Quadratic, Cubic, OddQuadratic, Quintic>;
  constexpr int several = 3;
  const LawFit* closest = nullptr;
  if (Law{chosen.law.terms & bends.terms}.size() < several) return closest;
  for (const LawFit& other : candidates) {
    const Law without = chosen.law.without(other.law);
    if (other.status == FitStatus::converged && chosen.law.contains(other.law) && without.size() == 1 &&
        bends.contains(without) && other.drive.force.between == chosen.drive.force.between &&
        (!closest || other.bic < closest->bic))
      closest = &other;
  }
  return closest;
}

double doubt_in(const std::vector<LawDoubt>& doubts, std::string_view name) {
  const auto found =
      std::find_if(doubts.begin(), doubts.end(), [&](const LawDoubt& each) { return each.name == name; });
  return found == doubts.end() ? 0 : found->by;
}

void raise_doubt(std::vector<LawDoubt>& doubts, std::string_view name, double by) {
  if (!(by > doubt_in(doubts, name))) return;
  std::erase_if(doubts, [&](const LawDoubt& each) { return each.name == name; });
  doubts.push_back({std::string(name), by});
}

// A linear law has one decay rate, at all amplitudes and by all its names, and no frequency of small swings
// that is known better than the swing's own.
void share_doubts_of_linear_law(std::vector<LawDoubt>& doubts, const LawFit& fit, double mass) {
  if (fit.law != Law{fit.law.terms & springs.terms}.with(law_with<Viscous>) || !is_linear(fit.law)) return;
  const double w = fit.motion.angular_frequency();
  double rate = w * doubt_in(doubts, "damping_ratio");
  for (const std::string_view end : {"decay_rate_start", "decay_rate_end"})
    rate = std::max(rate, doubt_in(doubts, end));
  for (const std::string_view end : {"decay_rate_start", "decay_rate_end"})
    if (doubt_in(doubts, end) > 0) raise_doubt(doubts, end, rate);
  raise_doubt(doubts, "decay_rate", rate);
  raise_doubt(doubts, "damping", 2 * mass * rate);
  raise_doubt(doubts, "damping_ratio", rate / w);
  raise_doubt(doubts, "logarithmic_decrement", rate * two_pi / w);
  // That of the swing itself is known best.
  const double turn = std::max(doubt_in(doubts, "angular_frequency"), two_pi * doubt_in(doubts, "frequency"));
  raise_doubt(doubts, "angular_frequency", turn);
  raise_doubt(doubts, "stiffness", 2 * mass * w * turn);
}

}  // namespace

std::vector<LawDoubt> law_doubts(const FittedRecording& result, const std::vector<LawFit>& candidates,
                                 std::string_view force_unit) {
  const LawFit* chosen = among(candidates, result.fit);
  if (!chosen) return {};
  std::vector<const LawFit*> laws{chosen};
  std::vector<double> odds{1};
  for (const LawFit* other : alternatives_to(*chosen, candidates))
    if (const double of_other = odds_of(*other, *chosen); of_other > 0) {
      laws.push_back(other);
      odds.push_back(of_other);
    }
  const LawFit* shorter_law = shorter_series(*chosen, candidates);
  if (shorter_law) laws.push_back(shorter_law);
  if (laws.size() == 1) return {};
  std::vector<std::vector<Parameter>> numbers(laws.size());
  at_once(laws.size(), [&](std::size_t i) {
    const bool is_same_spring = laws[i]->law.has<Hysteresis>() == chosen->law.has<Hysteresis>();
    numbers[i] = common_numbers(*laws[i], result, force_unit, is_same_spring);
  });
  const std::vector<Parameter> of_shorter = shorter_law ? numbers.back() : std::vector<Parameter>{};
  std::vector<LawDoubt> doubts;
  for (const Parameter& number : numbers.front()) {
    if (number.name == "at_amplitude") continue;  // it is seen, by whatever law
    const double own = number.estimate.standard_error;
    double squares = 0, all = 1;
    for (std::size_t i = 1; i < odds.size(); ++i) {
      const Parameter* same = named(numbers[i], number.name);
      const double off = same ? same->estimate.value - number.estimate.value : HUGE_VAL,
                   error = same ? same->estimate.standard_error : HUGE_VAL;
      if (!std::isfinite(off) || !std::isfinite(error)) continue;
      // The larger error of a law with one more term is what lets it differ: it counts once.
      squares += odds[i] * std::max(off * off, error * error - own * own);
      all += odds[i];
    }
    const Parameter* shorter = named(of_shorter, number.name);
    const double last = shorter ? shorter->estimate.value - number.estimate.value : 0;
    const double by = std::hypot(std::sqrt(squares / all), std::isfinite(last) ? last : 0);
    if (by > 0) doubts.push_back({number.name, by});
  }
  const Body body = body_of(result.options);
  share_doubts_of_linear_law(doubts, *chosen, body.mass ? body.effective_mass().value : 0);
  return doubts;
}

void add_doubts_of_stretches(std::vector<LawDoubt>& doubts, const std::vector<AmplitudeRate>& stretches) {
  if (stretches.size() < 3) return;
  const AmplitudeRate &first = stretches.front(), &last = stretches.back();
  const double larger = std::max(std::abs(first.law_rate), std::abs(last.law_rate));
  if (std::abs(first.law_rate - last.law_rate) <= alike_rates * larger) return;
  constexpr double by_chance = 2;  // standard errors
  const auto add = [&](std::string_view name, const AmplitudeRate& end) {
    const double off = end.rate.value - end.law_rate, seen = by_chance * end.rate.standard_error;
    if (!(std::abs(off) > seen)) return;
    raise_doubt(doubts, name, std::hypot(doubt_in(doubts, name), std::sqrt(off * off - seen * seen)));
  };
  add("decay_rate_start", first);
  add("decay_rate_end", last);
}

Parameter with_doubt(Parameter number, const std::vector<LawDoubt>& doubts) {
  const double by = doubt_in(doubts, number.name);
  Estimate& known = number.estimate;
  if (!(by > 0 && known.standard_error > 0) || !std::isfinite(known.standard_error)) return number;
  const double error = std::hypot(known.standard_error, by), wider = error / known.standard_error;
  const bool is_not_negative = known.low >= 0;
  known = {known.value, error, known.value - wider * (known.value - known.low),
           known.value + wider * (known.high - known.value)};
  if (is_not_negative) known.low = std::max(known.low, 0.0);
  return number;
}

void add_doubts(std::vector<Parameter>& numbers, const std::vector<LawDoubt>& doubts) {
  for (Parameter& each : numbers) each = with_doubt(std::move(each), doubts);
  // The quality factor is 1/(2 zeta): as well known as the damping ratio, and its interval as skewed.
  const Parameter* damping = named(numbers, "damping_ratio");
  const auto quality = std::find_if(numbers.begin(), numbers.end(),
                                    [](const Parameter& each) { return each.name == "quality_factor"; });
  if (!damping || quality == numbers.end() || !(doubt_in(doubts, "damping_ratio") > 0)) return;
  const Estimate& zeta = damping->estimate;
  if (!(zeta.value > 0)) return;
  const auto inverse = [](double ratio) { return ratio > 0 ? 1 / (2 * ratio) : HUGE_VAL; };
  Estimate& known = quality->estimate;
  known = {known.value, known.value * zeta.standard_error / zeta.value, inverse(zeta.high),
           inverse(zeta.low)};
}

std::vector<double> covariance_with_doubts(const FittedRecording& result) {
  std::vector<double> covariance = result.fit.covariance;
  const std::vector<std::string>& names = result.fit.names;
  const std::size_t n = names.size();
  if (covariance.size() != n * n) return covariance;
  for (std::size_t i = 0; i < n; ++i) {
    const Parameter* known = named(result.parameters, names[i]);
    const double own = result.fit.estimates[i].standard_error;
    if (!known || !(own > 0) || !std::isfinite(own)) continue;
    const double wider = known->estimate.standard_error / own;
    for (std::size_t j = 0; j < n; ++j) covariance[i * n + j] *= wider, covariance[j * n + i] *= wider;
  }
  return covariance;
}

}  // namespace cromer::core
