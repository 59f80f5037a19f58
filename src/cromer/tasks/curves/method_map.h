// Task: the damping and the frequency that each method really simulates, against the step.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cromer/result.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

/// The linear law and the methods are those of `simulate`; the steps are set here.
struct MethodMapOptions {
  SimulateOptions simulate;
  double from = 0.02;      ///< shortest w h, > 0
  double to = 2.5;         ///< longest w h, > from
  long long points = 200;  ///< >= 2, evenly spaced in log(w h)
};

/// What a method makes of the law at one step; NaN where its motion does not oscillate or no step is found.
struct MethodMapPoint {
  double decay_rate = 0;       // [1/s]
  double frequency_error = 0;  ///< |effective over the law's own damped frequency - 1|
  double decay_error = 0;      ///< |effective decay rate - the law's| over the natural frequency
  double energy_factor = 0;    ///< of the energy per cycle
};

/// One method.
struct MethodMapCurve {
  std::string method;
  int order = 0;                         ///< 0: exact
  std::vector<double> wh;                ///< natural frequency times step
  std::vector<MethodMapPoint> at;        ///< one for each
  MethodMapPoint at_a_tenth;             ///< at w h = 0.1, the place to compare methods at
  std::optional<double> stable_up_to{};  ///< w h; 0 where no step is stable, empty where every one is
};

struct MethodMapResult {
  double natural_frequency = 0;        // [rad/s]
  double decay_rate = 0;               // [1/s] of the law
  std::vector<MethodMapCurve> curves;  ///< in the order of the methods
};

/// Of an underdamped linear law. An adaptive method is shown at the steps that it might choose.
Result<MethodMapResult> method_map(const MethodMapOptions& options);

}  // namespace cromer::core
