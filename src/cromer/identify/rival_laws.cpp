#include "cromer/identify/rival_laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "cromer/base/quantity.h"
#include "cromer/identify/mean_decay.h"

namespace cromer {
namespace {

constexpr double strong = 6;

bool is_off(const Estimate& here, double there) {
  return std::abs(there - here.value) > 3 * here.standard_error;
}

bool is_off(const std::optional<Estimate>& here, const std::optional<Estimate>& there) {
  return here && there && is_off(*here, there->value);
}

// Another law would give other numbers for the same coefficients.
bool moves_the_numbers(const FreeDecay& chosen, const FreeDecay& rival) {
  if (is_off(chosen.angular_frequency, rival.angular_frequency.value) || is_off(chosen.drag, rival.drag) ||
      is_off(chosen.friction, rival.friction) || is_off(chosen.cubic, rival.cubic))
    return true;
  return chosen.law.viscous && rival.law.viscous && is_off(chosen.decay_rate, rival.decay_rate.value);
}

bool has_other_damping(const FreeDecay& chosen, const FreeDecay& rival) {
  const Law &a = chosen.law, &b = rival.law;
  return (a.viscous && !b.viscous) || (a.drag && !b.drag) || (a.friction && !b.friction);
}

std::string coefficients(const FreeDecay& fit) {
  std::string text;
  const auto add = [&](const char* name, const Estimate& value) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name,
                        format_quantity({value.value, value.standard_error}, ""));
  };
  if (fit.law.viscous) add("decay rate", fit.decay_rate);
  if (fit.drag) add("drag", *fit.drag);
  if (fit.friction) add("friction", *fit.friction);
  if (fit.cubic) add("cubic", *fit.cubic);
  return text;
}

}  // namespace

std::string rival_laws(const Record& record, const std::vector<FreeDecay>& candidates, std::size_t chosen) {
  const FreeDecay& best = candidates[chosen];
  if (best.status != FitStatus::converged) return {};
  const MeanDecay decay = mean_decay(best, record);
  if (!(decay.rate.low > 0)) return {};  // no damping is seen, whichever it be
  std::vector<const FreeDecay*> rivals;
  for (const FreeDecay& rival : candidates) {
    if (&rival == &best || rival.status != FitStatus::converged || rival.bic > best.bic + strong) continue;
    const std::size_t terms = rival.names.size();
    if (terms != best.names.size() && terms != best.names.size() + 1) continue;
    if (moves_the_numbers(best, rival) || (terms == best.names.size() && has_other_damping(best, rival)))
      rivals.push_back(&rival);
  }
  if (rivals.empty()) return {};
  std::sort(rivals.begin(), rivals.end(),
            [](const FreeDecay* one, const FreeDecay* other) { return one->bic < other->bic; });
  constexpr std::size_t most = 3;
  std::string list;
  for (std::size_t i = 0; i < std::min(most, rivals.size()); ++i)
    list += fmt::format("{}{} ({})",
                        i == 0                                   ? ""
                        : i + 1 == std::min(most, rivals.size()) ? " or "
                                                                 : ", ",
                        to_text(rivals[i]->law), coefficients(*rivals[i]));
  return fmt::format(
      "this record cannot tell {} from {}: the uncertainties hold only if the law is right. Known whichever "
      "it "
      "is: {}",
      to_text(best.law), list, to_text(decay));
}

}  // namespace cromer
