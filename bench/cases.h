// The work that benchmarks time and tests check.
#pragma once

#include "cromer/base/state.h"
#include "cromer/model/drive.h"
#include "cromer/model/oscillator.h"
#include "cromer/run/steps.h"

namespace cromer::bench {

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
};

}  // namespace cromer::bench
