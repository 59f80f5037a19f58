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
#include <limits>
#include <numbers>
#include <optional>
#include <type_traits>
#include <vector>

#include "cromer/analysis/frequency_response.h"
#include "cromer/base/complex.h"
#include "cromer/methods/method.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

/// More digits than double where the machine has them: beyond the stability limit the small eigenvalue is a
/// difference of large numbers. Where long double is 113 digits in software it costs too much.
using Precise = std::conditional_t<std::numeric_limits<long double>::digits == 113, double, long double>;

/// One step of the linear law: z' = map z + drive Re e^{i W t}, of (x, h v) and, where the method carries an
/// acceleration of its own, h^2 a. All in metres: entries stay comparable at every step.
template <class Number>
struct StepMapOf {
  std::size_t size = 2;                           ///< 2, or 3 with a carried acceleration
  std::array<std::array<Number, 3>, 3> column{};  ///< images of the basis
  std::array<Complex<Number>, 3> drive{};         // [m]
  bool converged = true;                          ///< false: an implicit step found no solution
};
using StepMap = StepMapOf<Precise>;

/// The oscillator that the method simulates.
struct EffectiveOscillator {
  std::vector<Complex<double>> eigenvalues{};    ///< of one step; the physical pair first
  double spectral_radius = 0;                    ///< largest modulus of them
  std::optional<double> decay_rate{};            // [1/s]; empty where nothing oscillates
  std::optional<double> angular_frequency{};     // [rad/s]; likewise. At most pi/h
  std::optional<SteadyState> steady_state{};     ///< where a driven motion settles, its lag from -pi/2 to
                                                 ///< 3 pi/2; empty without drive or
                                                 ///< where it never does
  std::optional<SteadyState> steady_velocity{};  // [m/s] of the same motion: the method's own, not i W x
  std::optional<double> energy_factor() const;   ///< of the energy per cycle; empty where nothing oscillates

  /// The motion stays bounded: spectral radius at most 1, to rounding.
  bool stable() const { return spectral_radius <= 1 + 1e-12; }
};

/// The acceleration of its own that the method keeps in its memory; nullptr where it keeps none.
template <class Number, class M, class Memory>
Number* carried_acceleration([[maybe_unused]] const M& method, [[maybe_unused]] Memory& memory) {
  if constexpr (CarriesAcceleration<M, Memory>)
    return &method.carried(memory);
  else
    return nullptr;
}

/// The map from images of states: image.template operator()<terms>(per_mass, force, z, map) is one step from
/// (x, h v, h^2 a) under the law with these terms, and notes in the map its size and whether it converged.
template <class Number, class ImageOf>
StepMapOf<Number> step_map_of(const ImageOf& image, const LinearLaw<double>& law) {
  using Image = std::array<Number, 3>;
  StepMapOf<Number> map;
  const Oscillator<Number> per_mass{
      .mass = 1, .stiffness = law.stiffness, .damping = 2 * Number(law.decay_rate)};
  // Undamped, methods may spare an equation: the run would, so the map does.
  const auto free = [&](const Image& z) {
    return law.decay_rate == 0
               ? image.template operator()<Terms{}>(per_mass, {}, z, map)
               : image.template operator()<Terms{.law = law_of("viscous")}>(per_mass, {}, z, map);
  };
  map.column[0] = free({1, 0, 0});
  map.column[1] = free({0, 1, 0});
  if (map.size == 3) map.column[2] = free({0, 0, 1});
  if (law.drive_amplitude != 0) {
    // By cos(W t) and by sin(W t): the real and the imaginary part.
    const auto driven = [&](Number phase) {
      return image.template operator()<Terms{.drive = true, .law = law_of("viscous")}>(
          per_mass, HarmonicForce<Number>{law.drive_amplitude, law.drive_frequency, phase}, Image{0, 0, 0},
          map);
    };
    const Image real = driven(0), imaginary = driven(-std::numbers::pi_v<Number> / 2);
    for (std::size_t i = 0; i < 3; ++i) map.drive[i] = {real[i], imaginary[i]};
  }
  return map;
}

/// The map of one step h > 0 of the method on the law.
template <class Number = Precise, class M>
StepMapOf<Number> step_map(const M& method, const LinearLaw<double>& law, double step) {
  using Image = std::array<Number, 3>;
  const Number h = step;
  const auto image = [&]<Terms terms>(const Oscillator<Number>& per_mass, const HarmonicForce<Number>& force,
                                      const Image& z, StepMapOf<Number>& map) {
    const DrivenOscillator<Number, terms> system(per_mass, force);
    const State<Number> y{z[0], z[1] / h};
    auto memory = method.start(system, Number(0), y);
    if (Number* carried = carried_acceleration<Number>(method, memory)) {
      map.size = 3;
      *carried = z[2] / (h * h);
    }
    const auto trial = method.step(system, Number(0), h, y, memory);
    map.converged = map.converged && trial.converged;
    Image result{trial.y.x, h * trial.y.v, 0};
    if (const Number* carried = carried_acceleration<Number>(method, memory)) result[2] = h * h * *carried;
    return result;
  };
  return step_map_of<Number>(image, law);
}

/// Eigenvalues and what follows from them; the steady state where W > 0.
EffectiveOscillator analyse(const StepMap& map, double h, double drive_frequency);

/// The determinant of a matrix given by a function of row and column.
template <class T, class Entry>
T determinant(const Entry& m) {
  const auto minor = [&](int i, int j) -> T { return m(1, i) * m(2, j) - m(1, j) * m(2, i); };
  return m(0, 0) * minor(1, 2) - m(0, 1) * minor(0, 2) + m(0, 2) * minor(0, 1);
}

/// What the method simulates of the law with steps h > 0 [s]. The drive's phase is not looked at. Error:
/// 1e-13 of the natural frequency for w h > 1e-3, growing as 1e-16/(w h) below.
template <class M>
EffectiveOscillator effective_oscillator(const M& method, const LinearLaw<double>& law, double h) {
  return analyse(step_map(method, law, h), h, law.drive_frequency);
}

/// The h at which `spectral_radius` first exceeds 1; see stability_limit.
std::optional<double> first_unstable_step(const LinearLaw<double>& law,
                                          const std::function<double(double)>& spectral_radius);

/// The largest h [s] such that no shorter step is unstable; 0 where every step is, empty where none is
/// (looked for up to a thousand times 1/(w + 2 b)). Damping ratios below 1e-7 count as none. law.stiffness >
/// 0.
template <class M>
std::optional<double> stability_limit(const M& method, const LinearLaw<double>& law) {
  const LinearLaw<double> free{.decay_rate = law.decay_rate, .stiffness = law.stiffness};
  return first_unstable_step(free,
                             [&](double h) { return effective_oscillator(method, free, h).spectral_radius; });
}

// Where the method's motion settles under a harmonic drive, without stepping there and without eigenvalues:
// quickly, for resonance curves of a million points.

struct MethodSteadyState {
  SteadyState position;  // the lag from -pi/2 to 3 pi/2
  double velocity = 0;   // [m/s] amplitude of the method's own
};

/// True if all eigenvalues of the map lie inside the unit circle by more than rounding. The coefficients of
/// its characteristic polynomial then meet the conditions of E. I. Jury, IRE Trans. Automat. Control 7, 38
/// (1962).
template <class Number>
bool settles(const StepMapOf<Number>& map) {
  constexpr Number least = 1e-14;
  const auto m = [&](std::size_t i, std::size_t j) { return map.column[j][i]; };
  const auto minor = [&](std::size_t i, std::size_t j) { return m(i, i) * m(j, j) - m(i, j) * m(j, i); };
  if (map.size == 2) {
    const Number trace = m(0, 0) + m(1, 1), product = minor(0, 1);
    return std::abs(product) < 1 - least && std::abs(trace) < 1 + product;
  }
  const Number c2 = -(m(0, 0) + m(1, 1) + m(2, 2)), c1 = minor(0, 1) + minor(0, 2) + minor(1, 2);
  const Number c0 = -determinant<Number>(m);
  return std::abs(c0) < 1 - least && 1 + c2 + c1 + c0 > 0 && 1 - c2 + c1 - c0 > 0 &&
         1 - c0 * c0 - std::abs(c0 * c2 - c1) > least;
}

/// The steady state of a map; empty where the motion never settles. `uncertainty` is set to the relative
/// error that rounding may cause.
template <class Number>
std::optional<MethodSteadyState> steady_state_of(const StepMapOf<Number>& map, double drive_frequency,
                                                 double h, double& uncertainty) {
  uncertainty = 0;
  if (!map.converged || !settles(map)) return std::nullopt;
  const Number turn = Number(drive_frequency) * Number(h);
  const Complex<Number> z{std::cos(turn), std::sin(turn)};
  const auto left = [&](std::size_t i, std::size_t j) {
    return Complex<Number>{(i == j ? z.re : Number(0)) - map.column[j][i], i == j ? z.im : Number(0)};
  };
  // (e^{i W h} - map)^-1 drive, by Cramer's rule.
  const auto component = [&](std::size_t k) {
    return [&, k](std::size_t i, std::size_t j) { return j == k ? map.drive[i] : left(i, j); };
  };
  const auto determinant_of = [&](const auto& entry) {
    if (map.size == 3) return determinant<Complex<Number>>(entry);
    return entry(0, 0) * entry(1, 1) - entry(0, 1) * entry(1, 0);
  };
  const Complex<Number> whole = determinant_of(left);
  const auto size = [](const Complex<Number>& c) { return std::sqrt(c.re * c.re + c.im * c.im); };
  uncertainty = static_cast<double>(4 * std::numeric_limits<Number>::epsilon() *
                                    (size(left(0, 0)) + size(left(1, 1)) + size(left(0, 1))) / size(whole));
  const auto position = determinant_of(component(0)) / whole, velocity = determinant_of(component(1)) / whole;
  const Transmission answer =
      transmission(static_cast<double>(position.re), static_cast<double>(-position.im));
  return MethodSteadyState{{answer.amplitude, answer.phase_lag}, static_cast<double>(size(velocity)) / h};
}

/// The steady state of the driven law in steps of h > 0 [s]; empty where the motion never settles. Relative
/// error at most 1e-11: in double where that is enough, else with more digits.
template <class M>
std::optional<MethodSteadyState> method_steady_state(const M& method, const LinearLaw<double>& law,
                                                     double h) {
  double uncertainty = 0;
  auto quick = steady_state_of(step_map<double>(method, law, h), law.drive_frequency, h, uncertainty);
  if (quick && uncertainty <= 1e-11) return quick;
  return steady_state_of(step_map<Precise>(method, law, h), law.drive_frequency, h, uncertainty);
}

}  // namespace cromer::core
