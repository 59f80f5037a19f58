#include "cromer/tasks/methods/law_before_method.h"

#include <cmath>

#include "cromer/base/pi.h"
#include "cromer/tasks/methods/method_effect.h"

namespace cromer::core {
namespace {

LinearLaw<double> law_of_mode(double frequency, double damping_ratio) {
  const double w = two_pi * frequency;
  return {.decay_rate = damping_ratio * w, .stiffness = w * w};
}

// The frequency [Hz] and damping ratio that are simulated; empty where nothing oscillates.
std::optional<std::array<double, 2>> mode_by_method(std::string_view method, const MethodSettings& settings,
                                                    double h, double frequency, double damping_ratio) {
  const EffectiveOscillator effective =
      effective_oscillator_of(method, settings, law_of_mode(frequency, damping_ratio), h);
  if (!effective.decay_rate || !effective.angular_frequency) return std::nullopt;
  const double w = std::hypot(*effective.decay_rate, *effective.angular_frequency);
  return std::array{w / two_pi, *effective.decay_rate / w};
}

}  // namespace

std::optional<LawBeforeMethod> law_before_method(std::string_view method, const MethodSettings& settings,
                                                 double h, double frequency, double damping_ratio) {
  double f = frequency, z = damping_ratio;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const auto at = mode_by_method(method, settings, h, f, z);
    // Central differences, well above rounding and below any bend of the map.
    constexpr double small = 1e-5;
    const auto faster = mode_by_method(method, settings, h, f * (1 + small), z);
    const auto slower = mode_by_method(method, settings, h, f * (1 - small), z);
    const auto more = mode_by_method(method, settings, h, f, z + small);
    const auto less = mode_by_method(method, settings, h, f, z - small);
    if (!at || !faster || !slower || !more || !less) return std::nullopt;
    const double ff = ((*faster)[0] - (*slower)[0]) / (2 * small * f),
                 fz = ((*more)[0] - (*less)[0]) / (2 * small);
    const double zf = ((*faster)[1] - (*slower)[1]) / (2 * small * f),
                 zz = ((*more)[1] - (*less)[1]) / (2 * small);
    const double determinant = ff * zz - fz * zf;
    if (!(std::abs(determinant) > 1e-9)) return std::nullopt;
    const double off_f = frequency - (*at)[0], off_z = damping_ratio - (*at)[1];
    if (std::abs(off_f) < 1e-12 * frequency && std::abs(off_z) < 1e-12)
      return LawBeforeMethod{
          f,
          z,
          law_of_mode(f, z),
          {{{zz / determinant, -fz / determinant}, {-zf / determinant, ff / determinant}}}};
    f += (zz * off_f - fz * off_z) / determinant;
    z += (ff * off_z - zf * off_f) / determinant;
    if (!(f > 0 && std::abs(z) < 1)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace cromer::core
