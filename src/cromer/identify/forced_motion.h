// A forced motion integrated through a record, with its derivatives: one pass, no memory beyond the data.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "cromer/base/state.h"
#include "cromer/identify/forced_system.h"
#include "cromer/methods/rk4.h"

namespace cromer {

/// What a forced motion is laid beside: times [s], strictly increasing, and values from a fixed level; NaN
/// where a sample is missing or set aside.
struct ForcedSamples {
  std::span<const double> t, z;

  ForcedSamples first(std::size_t count) const { return {t.first(count), z.first(count)}; }
};

/// Calls visit(i, position) at each sample while the motion stays finite; each interval is cut into equal
/// steps of at most h [s] of rk4. The drive is prepared along the way, its times from the first sample.
template <ForcedTerms terms, int N, class Drive, class Visit>
void integrate_forced(const Parameters& p, Drive& drive, std::span<const double> t, double h, Visit visit) {
  using System = ForcedSystem<Drive, terms, N>;
  constexpr ForcedLayout at = System::at;
  const System system(p, drive);
  const Rk4 method;
  State<Tangent<N>> y{};
  y.x.value = p[at.position];
  y.v.value = p[at.velocity];
  if constexpr (N > 0) {
    y.x.derivative[at.position] = 1;
    y.v.derivative[at.velocity] = 1;
  }
  visit(std::size_t{0}, y.x);
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    // From the first sample: a clock's time would cost digits.
    const double begin = t[i] - t.front(), dt = t[i + 1] - t[i];
    const int steps = std::max(1, static_cast<int>(std::ceil(dt / h - 1e-9)));
    const double step = dt / steps;
    drive.prepare(i, begin, dt, steps);
    auto memory = method.start(system, begin, y);
    for (int n = 0; n < steps; ++n) y = method.step(system, begin + n * step, step, y, memory).y;
    if (!std::isfinite(y.x.value)) return;
    visit(i + 1, y.x);
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

/// The motion at the samples; shorter than they where it does not stay finite.
template <class Drive>
std::vector<double> forced_motion(ForcedTerms terms, const Parameters& p, Drive drive,
                                  std::span<const double> t, double h) {
  std::vector<double> z;
  z.reserve(t.size());
  with_forced_terms(terms, [&]<ForcedTerms present>() {
    integrate_forced<present, 0>(
        p, drive, t, h, [&](std::size_t, const Tangent<0>& position) { z.push_back(position.value); });
  });
  return z;
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
    integrate_forced<present, n>(p, drive, samples.t, h, [&](std::size_t i, const Tangent<n>& position) {
      reached = i + 1;
      const double r = samples.z[i] - position.value;
      if (std::isnan(r)) return;
      for (int j = 0; j < n; ++j) {
        right[j] += position.derivative[j] * r;
        for (int l = 0; l < n; ++l) gram[j][l] += position.derivative[j] * position.derivative[l];
      }
      sum_of_squares += r * r;
    });
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
