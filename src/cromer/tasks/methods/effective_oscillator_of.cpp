#include "cromer/methods/all.h"
#include "cromer/tasks/methods/method_effect.h"
#include "cromer/tasks/methods/step_map_of.h"

namespace cromer::core {

EffectiveOscillator effective_oscillator_of(std::string_view method, const MethodSettings& settings,
                                            const LinearLaw<double>& law, double h) {
  return visit_method(method, settings,
                      [&](const auto& named) { return effective_oscillator(named, law, h); });
}

StepMap step_map_of(std::string_view method, const MethodSettings& settings, const LinearLaw<double>& law,
                    double h) {
  return visit_method(method, settings, [&](const auto& named) { return step_map(named, law, h); });
}

}  // namespace cromer::core
