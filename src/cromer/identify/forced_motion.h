// A forced motion integrated through a record, with its derivatives: one pass, no memory beyond the data.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "cromer/base/state.h"
#include "cromer/identify/forced_system.h"
#include "cromer/methods/rk4.h"
#include "cromer/run/trajectory.h"

namespace cromer {

/// What a forced motion is laid beside: times [s], strictly increasing, and values from a fixed level; NaN
/// where a sample is missing or set aside.
struct ForcedSamples {
  std::span<const double> t, z;
  int derivative = 0;  ///< 1 or 2: z are velocities or accelerations

  ForcedSamples first(std::size_t count) const { return {t.first(count), z.first(count), derivative}; }
};

/// Calls visit(i, observed, state) at each sample while the motion stays finite, `observed` being that
/// derivative of the position, with the sensor's offset; each interval is cut into equal steps of at most h
/// [s] of rk4. The drive is prepared along the way, its times from the first sample.
template <ForcedTerms terms, int N, class Drive, class Visit>
void integrate_forced(const Parameters& p, Drive& drive, std::span<const double> t, int derivative, double h,
                      Visit visit) {
  using System = ForcedSystem<Drive, terms, N>;
  constexpr ForcedLayout at = System::at;
  const System system(p, drive, derivative == 0);
  const Rk4 method;
  State<Tangent<N>> y{};
  y.x.value = p[at.position];
  y.v.value = p[at.velocity];
  if constexpr (N > 0) {
    y.x.derivative[at.position] = 1;
    y.v.derivative[at.velocity] = 1;
  }
  const auto observed = [&](double time) {
    if (derivative == 0) return y.x;
    Tangent<N> value = derivative == 1 ? y.v : system.acceleration(time, y.x, y.v);
    value.value += p[at.bias];
    if constexpr (N > 0) value.derivative[at.bias] += 1;
    return value;
  };
  for (std::size_t i = 0; i < t.size(); ++i) {
    // From the first sample: a clock's time would cost digits.
    const double begin = t[i] - t.front();
    if (i + 1 == t.size()) {
      visit(i, observed(begin), y);
      break;
    }
    const double dt = t[i + 1] - t[i];
    const int steps = std::max(1, static_cast<int>(std::ceil(dt / h - 1e-9)));
    const double step = dt / steps;
    drive.prepare(i, begin, dt, steps);
    visit(i, observed(begin), y);
    auto memory = method.start(system, begin, y);
    for (int n = 0; n < steps; ++n) y = method.step(system, begin + n * step, step, y, memory).y;
    if (!std::isfinite(y.x.value)) return;
  }
}

/// f.operator()<terms>() with the terms as a constant.
template <class F>
decltype(auto) with_forced_terms(ForcedTerms terms, F&& f) {
  if (terms.drag && terms.curved) return f.template operator()<ForcedTerms{true, true}>();
  if (terms.drag) return f.template operator()<ForcedTerms{true, false}>();
  if (terms.curved) return f.template operator()<ForcedTerms{false, true}>();
  return f.template operator()<ForcedTerms{}>();
}

/// What is observed of the motion at the samples' times; shorter than they where it does not stay finite.
template <class Drive>
std::vector<double> forced_motion(ForcedTerms terms, const Parameters& p, Drive drive,
                                  std::span<const double> t, int derivative, double h) {
  std::vector<double> z;
  z.reserve(t.size());
  with_forced_terms(terms, [&]<ForcedTerms present>() {
    integrate_forced<present, 0>(
        p, drive, t, derivative, h,
        [&](std::size_t, const Tangent<0>& observed, const auto&) { z.push_back(observed.value); });
  });
  return z;
}

/// The states there, positions as forced_layout has them.
template <class Drive>
Trajectory forced_states(ForcedTerms terms, const Parameters& p, Drive drive, std::span<const double> t,
                         int derivative, double h) {
  Trajectory states;
  with_forced_terms(terms, [&]<ForcedTerms present>() {
    integrate_forced<present, 0>(p, drive, t, derivative, h,
                                 [&](std::size_t i, const Tangent<0>&, const State<Tangent<0>>& y) {
                                   states.t.push_back(t[i]);
                                   states.x.push_back(y.x.value);
                                   states.v.push_back(y.v.value);
                                 });
  });
  return states;
}

/// The normal equations at p (in the order of forced_layout); their sum of squares is infinite where the
/// motion does not stay finite.
template <class Drive>
NormalEquations forced_equations(ForcedTerms terms, const Parameters& p, Drive drive,
                                 const ForcedSamples& samples, double h) {
  NormalEquations equations;
  with_forced_terms(terms, [&]<ForcedTerms present>() {
    constexpr int n = forced_layout(Drive::parameters, present).size;
    double gram[n][n]{}, right[n]{}, sum_of_squares = 0;
    std::size_t reached = 0;
    const auto add = [&](std::size_t i, const Tangent<n>& observed, const auto&) {
      reached = i + 1;
      const double r = samples.z[i] - observed.value;
      if (std::isnan(r)) return;
      for (int j = 0; j < n; ++j) {
        right[j] += observed.derivative[j] * r;
        for (int l = 0; l < n; ++l) gram[j][l] += observed.derivative[j] * observed.derivative[l];
      }
      sum_of_squares += r * r;
    };
    integrate_forced<present, n>(p, drive, samples.t, samples.derivative, h, add);
    equations.size = n;
    equations.sum_of_squares = reached == samples.t.size() ? sum_of_squares : HUGE_VAL;
    for (int j = 0; j < n; ++j) {
      equations.right[j] = right[j];
      for (int l = 0; l < n; ++l) equations.matrix[j][l] = gram[j][l];
    }
  });
  return equations;
}

}  // namespace cromer
