#include "cromer/tasks/fit/law_doubt.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cromer/identify/choose/criterion.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/fit/fitted_quantities.h"
#include "cromer/tasks/fit/lab_quantities.h"
#include "cromer/tasks/fit/used_samples.h"

namespace cromer::core {
namespace {

// Those of one law of the same motion.
std::vector<Parameter> common_numbers(const LawFit& fit, const FittedRecording& result,
                                      std::string_view force_unit) {
  const int derivative = std::max(0, derivative_order(result.series.quantity));
  const std::vector<double>& t = result.series.t;
  std::vector<Parameter> all =
      derived_quantities(fit, unit_of(result.series), derivative,
                         result.driven ? result.driven->states.x : std::vector<double>{}, force_unit);
  for (Parameter& end : decay_rate_ends(fit, t.back() - t.front())) all.push_back(std::move(end));
  const double w = fit.motion.angular_frequency();
  all.push_back({"angular_frequency", {.value = w}, "rad/s"});
  if (const Body body = body_of(result.options); body.mass)
    all.push_back({"stiffness", {.value = body.effective_mass().value * w * w}, "N/m"});
  return all;
}

}  // namespace

std::vector<LawDoubt> law_doubts(const FittedRecording& result, const std::vector<LawFit>& candidates,
                                 std::string_view force_unit) {
  const std::vector<const LawFit*> rivals = rivals_of(result.fit.law, candidates);
  if (rivals.empty()) return {};
  const auto chosen = std::find_if(candidates.begin(), candidates.end(),
                                   [&](const LawFit& each) { return each.law == result.fit.law; });
  std::vector<std::vector<Parameter>> others;
  std::vector<double> odds;  // against the chosen law
  for (const LawFit* rival : rivals) {
    others.push_back(common_numbers(*rival, result, force_unit));
    odds.push_back(std::exp(0.5 * (chosen->bic - rival->bic)));
  }
  std::vector<LawDoubt> doubts;
  for (const Parameter& number : common_numbers(result.fit, result, force_unit)) {
    double squares = 0, all = 1;
    for (std::size_t i = 0; i < others.size(); ++i) {
      const Parameter* same = named(others[i], number.name);
      const double off = same ? same->estimate.value - number.estimate.value : HUGE_VAL;
      if (!std::isfinite(off)) continue;
      squares += odds[i] * off * off;
      all += odds[i];
    }
    if (squares > 0) doubts.push_back({number.name, std::sqrt(squares / all)});
  }
  return doubts;
}

Parameter with_doubt(Parameter number, const std::vector<LawDoubt>& doubts) {
  const auto doubt = std::find_if(doubts.begin(), doubts.end(),
                                  [&](const LawDoubt& each) { return each.name == number.name; });
  Estimate& known = number.estimate;
  if (doubt == doubts.end() || !(known.standard_error > 0)) return number;
  const double error = std::hypot(known.standard_error, doubt->by), wider = error / known.standard_error;
  const bool cut = known.low == 0 && known.value > 0;
  known = {known.value, error, known.value - wider * (known.value - known.low),
           known.value + wider * (known.high - known.value)};
  if (cut) known.low = 0;
  return number;
}

void add_doubts(std::vector<Parameter>& numbers, const std::vector<LawDoubt>& doubts) {
  for (Parameter& each : numbers) each = with_doubt(std::move(each), doubts);
}

}  // namespace cromer::core
