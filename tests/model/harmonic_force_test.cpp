#include "cromer/model/harmonic_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace cromer::core {
namespace CROMER_FILE {

struct FiveNodes {
  static constexpr std::array nodes{1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0};
};
struct TwoNodes {
  static constexpr std::array nodes{0.0, 1.0};
};

static_assert(slots_for_nodes<FiveNodes>() == 9);
static_assert(slots_for_nodes<TwoNodes>() == 1);

const HarmonicForce<double> force{2.0, 3.0, 0.7};

template <class Nodes>
double worst_in_step(NodeForce<double, Nodes>& ready, double t, double h) {
  ready.move_to(t, h);
  double worst = 0;
  for (const double node : Nodes::nodes)
    worst = std::max(worst, std::abs(ready(t + node * h) - force(t + node * h)));
  return worst;
}

TEST(NodeForce, IsTheForceInEqualSteps) {
  NodeForce<double, FiveNodes> ready(force);
  const double h = 0.0371;
  double worst = 0;
  for (int n = 0; n < 1000; ++n) worst = std::max(worst, worst_in_step(ready, n * h, h));
  EXPECT_LT(worst, 2 * 8e-14);  // some roundings of a phase of 111 rad
  EXPECT_GT(worst, 0);
}

TEST(NodeForce, IsTheForceWhereTheLengthChanges) {
  NodeForce<double, FiveNodes> ready(force);
  double t = 0, worst = 0;
  for (int n = 0; n < 1000; ++n) {
    const double h = n % 7 < 4 ? 0.02 : 0.013 * (1 + n % 5);
    worst = std::max(worst, worst_in_step(ready, t, h));
    t += h;
  }
  EXPECT_LT(worst, 2 * 3e-14);
}

TEST(NodeForce, IsTheForceAfterAStepBackAndALeap) {
  NodeForce<double, TwoNodes> ready(force);
  EXPECT_LT(worst_in_step(ready, 1.0, 0.1), 4e-15);
  EXPECT_LT(worst_in_step(ready, 1.0, 0.03), 4e-15);  // rejected, tried again
  EXPECT_LT(worst_in_step(ready, 5.0, 0.03), 4e-15);
  EXPECT_LT(worst_in_step(ready, 5.03, 50.0), 1e-13);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
