#include "cromer/identify/choose/rival_laws.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cromer/base/quantity.h"
#include "cromer/identify/choose/criterion.h"
#include "cromer/identify/diagnose/mean_decay.h"

namespace cromer::core {
namespace {

bool is_off(const Estimate& here, double there) {
  return std::abs(there - here.value) > 3 * here.standard_error;
}

// Another law would give other numbers for the same coefficients.
bool moves_the_numbers(const LawFit& chosen, const LawFit& rival) {
  for (std::size_t i = 0; i < chosen.names.size(); ++i) {
    if (chosen.names[i] == "equilibrium" || is_of_the_start(chosen.names[i])) continue;
    const Estimate* there = rival.find(chosen.names[i]);
    if (there && is_off(chosen.estimates[i], there->value)) return true;
  }
  return false;
}

bool has_other_damping(const LawFit& chosen, const LawFit& rival) {
  const Law of_energy = dampings.with(bounding_terms);
  return Law{chosen.law.terms & of_energy.terms}.without(rival.law) != Law{};
}

Notice named_rival(const LawFit& fit) {
  std::vector<Notice> coefficients;
  for (std::size_t i = 0; i < fit.names.size(); ++i) {
    const std::string& name = fit.names[i];
    if (name == "equilibrium" || name == "angular_frequency" || is_of_the_start(name)) continue;
    coefficients.push_back(
        Notice{"coefficient",
               {{"parameter", parameter_named(name)},
                {"value", format_quantity({fit.estimates[i].value, fit.estimates[i].standard_error}, "")}}});
  }
  return Notice{"law_with_coefficients", {{"law", to_text(fit.law)}, {"coefficients", coefficients}}};
}

}  // namespace

Notice rival_laws(const Record& record, const std::vector<LawFit>& candidates, std::size_t chosen) {
  const LawFit& best = candidates[chosen];
  if (best.status != FitStatus::converged || !best.law.shares(springs)) return {};
  const std::optional<MeanDecay> decay = mean_decay(best, record);
  if (!decay || !(decay->rate.low > 0 || is_fed(best))) return {};  // no damping is seen, whichever it be
  std::vector<const LawFit*> rivals;
  for (const LawFit& rival : candidates) {
    if (&rival == &best || rival.status != FitStatus::converged || rival.bic > best.bic + strong_evidence)
      continue;
    const int terms = rival.fitted;
    if (terms != best.fitted && terms != best.fitted + 1) continue;
    if (moves_the_numbers(best, rival) || (terms == best.fitted && has_other_damping(best, rival)))
      rivals.push_back(&rival);
  }
  if (rivals.empty()) return {};
  std::sort(rivals.begin(), rivals.end(),
            [](const LawFit* one, const LawFit* other) { return one->bic < other->bic; });
  constexpr std::size_t most = 3;
  std::vector<Notice> named;
  for (std::size_t i = 0; i < std::min(most, rivals.size()); ++i) named.push_back(named_rival(*rivals[i]));
  if (is_fed(best))
    return Notice{"rival_laws_of_a_fed_swing", {{"law", to_text(best.law)}, {"rivals", named}}};
  return Notice{"rival_laws", {{"law", to_text(best.law)}, {"rivals", named}, {"known", as_clause(*decay)}}};
}

}  // namespace cromer::core
