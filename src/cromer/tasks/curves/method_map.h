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

/// What a method simulates at one step. NaN if its motion does not oscillate, or an implicit step has no
/// solution.
struct MethodMapPoint {
  double decay_rate = 0;       // [1/s]
  double frequency_error = 0;  ///< |effective over the law's own damped frequency - 1|
  double decay_error = 0;      ///< |effective decay rate - the law's| over the natural frequency
  double energy_factor = 0;    ///< energy after a cycle over the energy before
};

/// One method.
struct MethodMapCurve {
  std::string method;
  int order = 0;                         ///< 0: exact
  std::vector<double> wh;                ///< natural frequency times step
  std::vector<MethodMapPoint> at;        ///< one for each
  MethodMapPoint at_a_tenth;             ///< at w h = 0.1, where methods are compared
  std::optional<double> stable_up_to{};  ///< w h; 0 if no step is stable, empty if every step is
};

struct MethodMapResult {
  double natural_frequency = 0;        // [rad/s]
  double decay_rate = 0;               // [1/s] of the law
  std::vector<MethodMapCurve> curves;  ///< in the order of the methods
};

/// The law must be linear and underdamped. An adaptive method is shown at steps that it might choose.
Result<MethodMapResult> method_map(const MethodMapOptions& options);

}  // namespace cromer::core
