// What a method with a given step really simulates of the linear law x'' + 2 b x' + s x = f cos(W t).
//
// One step is a linear map of the state (and of what the method carries along). Its eigenvalues rho e^{+- i
// theta} are, exactly, those of another oscillator's motion, seen at the steps: decay rate -ln(rho)/h,
// angular frequency theta/h. The map is found by running the method's own `step` on basis states, so no
// formula is written twice.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "cromer/analysis/frequency_response.h"
#include "cromer/base/complex.h"
#include "cromer/methods/method.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/propagate.h"

namespace cromer {

/// One step of the linear law: z' = map z + drive Re e^{i W t}, of (x, h v) and, where the method carries an
/// acceleration of its own, h^2 a. All in metres: entries stay comparable at every step.
struct StepMap {
  std::size_t size = 2;                           ///< 2, or 3 with a carried acceleration
  std::array<std::array<double, 3>, 3> column{};  ///< images of the basis
  std::array<Complex<double>, 3> drive{};         // [m]
  bool converged = true;                          ///< false: an implicit step found no solution
};

/// The oscillator that the method simulates.
struct EffectiveOscillator {
  std::vector<Complex<double>> eigenvalues{};   ///< of one step; the physical pair first
  double spectral_radius = 0;                   ///< largest modulus of them
  std::optional<double> decay_rate{};           // [1/s]; empty where nothing oscillates
  std::optional<double> angular_frequency{};    // [rad/s]; likewise. At most pi/h
  std::optional<SteadyState> steady_state{};    ///< where a driven motion settles; empty without drive or
                                                ///< where it never does
  std::optional<double> energy_factor() const;  ///< of the energy per cycle; empty where nothing oscillates

  /// The motion stays bounded: spectral radius at most 1, to rounding.
  bool stable() const { return spectral_radius <= 1 + 1e-12; }
};

/// The map of one step h > 0 of the method on the law.
template <class M>
StepMap step_map(const M& method, const LinearLaw<double>& law, double h) {
  StepMap map;
  const Oscillator<double> per_mass{.mass = 1, .stiffness = law.stiffness, .damping = 2 * law.decay_rate};
  const auto step = [&]<Terms terms>(const std::array<double, 3>& z, double drive, double phase) {
    const DrivenOscillator<double, terms> system(per_mass, {drive, law.drive_frequency, phase});
    const State<double> y{z[0], z[1] / h};
    auto memory = method.start(system, 0.0, y);
    if constexpr (requires { method.carried(memory); }) {
      map.size = 3;
      method.carried(memory) = z[2] / (h * h);
    }
    const auto trial = method.step(system, 0.0, h, y, memory);
    map.converged = map.converged && trial.converged;
    std::array<double, 3> image{trial.y.x, h * trial.y.v, 0};
    if constexpr (requires { method.carried(memory); }) image[2] = h * h * method.carried(memory);
    return image;
  };
  // Undamped, methods may spare an equation: the run would, so the map does.
  const auto free = [&](const std::array<double, 3>& z) {
    return law.decay_rate == 0 ? step.template operator()<Terms{}>(z, 0, 0)
                               : step.template operator()<Terms{.damping = true}>(z, 0, 0);
  };
  map.column = {free({1, 0, 0}), free({0, 1, 0}), free({0, 0, 1})};
  if (law.drive_amplitude != 0) {
    // By cos(W t) and by sin(W t): the real and the imaginary part.
    const auto driven = [&](double phase) {
      return step.template operator()<Terms{.drive = true, .damping = true}>({0, 0, 0}, law.drive_amplitude,
                                                                             phase);
    };
    constexpr double quarter = 1.57079632679489661923;
    const auto real = driven(0), imaginary = driven(-quarter);
    for (std::size_t i = 0; i < 3; ++i) map.drive[i] = {real[i], imaginary[i]};
  }
  return map;
}

/// Eigenvalues and what follows from them; the steady state where W > 0.
EffectiveOscillator analyse(const StepMap& map, double h, double drive_frequency);

/// What the method simulates of the law with steps h > 0 [s]. The drive's phase is not looked at. Error:
/// 1e-13 of the natural frequency for w h > 1e-3, growing as 1e-16/(w h) below.
template <class M>
EffectiveOscillator effective_oscillator(const M& method, const LinearLaw<double>& law, double h) {
  return analyse(step_map(method, law, h), h, law.drive_frequency);
}

/// The h at which `spectral_radius` first leaves 1; see stability_limit.
std::optional<double> first_unstable_step(const LinearLaw<double>& law,
                                          const std::function<double(double)>& spectral_radius);

/// The largest h [s] such that no shorter step is unstable; 0 where every step is, empty where none is
/// (looked for up to a million times 1/(w + 2 b)). Damping ratios below 1e-7 count as none. law.stiffness >
/// 0.
template <class M>
std::optional<double> stability_limit(const M& method, const LinearLaw<double>& law) {
  const LinearLaw<double> free{.decay_rate = law.decay_rate, .stiffness = law.stiffness};
  return first_unstable_step(free,
                             [&](double h) { return effective_oscillator(method, free, h).spectral_radius; });
}

}  // namespace cromer
