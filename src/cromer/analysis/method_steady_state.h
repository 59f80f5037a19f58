// Where a method's own motion settles under a harmonic drive, without stepping there: quickly, for resonance
// curves of a million points.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "cromer/analysis/effective_oscillator.h"
#include "cromer/analysis/frequency_response.h"
#include "cromer/base/complex.h"
#include "cromer/model/propagate.h"

namespace cromer::core {

struct MethodSteadyState {
  SteadyState position;  // the lag from -pi/2 to 3 pi/2
  double velocity = 0;   // [m/s] amplitude of the method's own
};

/// All eigenvalues of the map lie inside the unit circle, by more than rounding: the coefficients of its
/// characteristic polynomial keep to the conditions of E. I. Jury, IRE Trans. Automat. Control 7, 38 (1962).
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

/// The same from a map; `uncertainty` is set to what rounding may do to it, relative.
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

/// Of the driven law, stepped by h > 0 [s]: empty where the motion never settles. Relative error at most
/// 1e-11: in doubles where they are good for that, else with more digits.
template <class M>
std::optional<MethodSteadyState> method_steady_state(const M& method, const LinearLaw<double>& law,
                                                     double h) {
  double uncertainty = 0;
  auto quick = steady_state_of(step_map<double>(method, law, h), law.drive_frequency, h, uncertainty);
  if (quick && uncertainty <= 1e-11) return quick;
  return steady_state_of(step_map<Precise>(method, law, h), law.drive_frequency, h, uncertainty);
}

}  // namespace cromer::core
