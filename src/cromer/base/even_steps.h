// How even the steps of some times are.
#pragma once

#include <span>

namespace cromer::core {

/// The mean step and the largest distance of a step from it; of two times at least.
struct EvenSteps {
  double mean, farthest;
};
EvenSteps even_steps(std::span<const double> t);

}  // namespace cromer::core
