// The law that a method with a step turns into the motion that was seen.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "cromer/methods/method_settings.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

struct LawBeforeMethod {
  double frequency = 0;  // [Hz] |eigenvalue|/2 pi
  double damping_ratio = 0;
  LinearLaw<double> law{};
  /// Derivatives of frequency and damping ratio by those that were seen.
  std::array<std::array<double, 2>, 2> slopes{};
};

/// By Newton's iteration on the method's own step, to a billionth of the frequency. The method takes steps
/// h > 0 [s]. Empty where it turns no law near by into this motion.
std::optional<LawBeforeMethod> law_before_method(std::string_view method, const MethodSettings& settings,
                                                 double h, double frequency, double damping_ratio);

}  // namespace cromer::core
