// The work that benchmarks time and tests check.
#pragma once

#include <cmath>

#include "cromer/base/state.h"
#include "cromer/model/law_force.h"
#include "cromer/model/oscillator.h"
#include "cromer/run/course.h"

namespace cromer::core::bench {

/// W1: one forced run, 8000 steps, all states kept. Lab one: m = 1 kg, k = 9 N/m, F = 1 N at 3 rad/s, from
/// rest, 80 s in steps of 10 ms.
struct ForcedRun {
  const char* name;
  Oscillator<double> oscillator;
  HarmonicDrive<double> drive{.amplitude = 1, .frequency = 3};
  State<double> start{0, 0};
  Interval interval{0, 80};
  double step = 0.01;  // [s]
};

inline constexpr ForcedRun forced_runs[] = {
    {"linear", {.mass = 1, .stiffness = 9, .damping = 0.2}},
    {"with cubic and drag", {.mass = 1, .stiffness = 9, .damping = 0.2, .drag = 0.05, .cubic = 2}},
    {"with cubic", {.mass = 1, .stiffness = 9, .damping = 0.2, .cubic = 2}},
};

/// The terms that they have, for peers that are told them when compiled.
inline constexpr Terms linear_terms{.drive = true, .law = law_of("viscous")};
inline constexpr Terms all_smooth_terms{.drive = true, .law = law_of("viscous+drag+cubic")};
inline constexpr Terms duffing_terms{.drive = true, .law = law_of("viscous+cubic")};

/// The law as the peers are given it, its cosine in every evaluation, with the terms the run has [m/s^2].
template <Terms terms>
double acceleration(const ForcedRun& run, double t, double x, double v) {
  const Oscillator<double>& o = run.oscillator;
  double force = run.drive.amplitude * std::cos(run.drive.frequency * t + run.drive.phase) - o.stiffness * x -
                 o.damping * v;
  if constexpr (terms.law.has<Cubic>()) force -= o.cubic * x * x * x;
  if constexpr (terms.law.has<Drag>()) force -= o.drag * v * std::abs(v);
  return force / o.mass;
}

}  // namespace cromer::core::bench
