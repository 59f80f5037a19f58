#include "cromer/methods.h"

#include "cromer/door/results.h"
#include "cromer/door/words.h"
#include "cromer/tasks/methods/methods.h"

namespace cromer {
namespace {

std::vector<MethodInfo> infos_of(const std::vector<core::MethodRow>& rows) {
  std::vector<MethodInfo> infos;
  for (const core::MethodRow& row : rows) {
    MethodInfo& info = infos.emplace_back();
    info.name = row.name;
    info.order = row.order;
    info.implicit = row.implicit;
    info.symplectic = row.symplectic;
    info.adaptive = row.adaptive;
    info.reversible = row.reversible;
    info.a_stable = row.a_stable;
    info.source = row.source;
    if (row.effect) info.effect = core::effect_of(*row.effect);
  }
  return infos;
}

}  // namespace

std::vector<MethodInfo> methods() { return infos_of(*core::list_methods()); }

Result<std::vector<MethodInfo>> methods(const EffectOptions& options) {
  core::MethodsOptions asked;
  asked.natural_frequency = options.natural_frequency;
  asked.damping_ratio = options.damping_ratio;
  asked.step = options.step;
  const auto rows = core::list_methods(asked);
  if (!rows) return core::in_arguments(rows.error());
  return infos_of(*rows);
}

}  // namespace cromer
