// Uses the installed library as somebody else would: integrates, and fits what it integrated.
#include <cromer/identify/law_fit.h>
#include <cromer/study/task/simulate.h>
#include <cromer/version.h>

#include <cmath>
#include <cstdio>

int main() {
  cromer::SimulateOptions options;
  options.stiffness = 9;
  options.damping = 0.1;
  options.position = 0.05;
  options.method = {"exact"};
  options.step = 0.01;
  options.until = 60;
  const auto simulated = cromer::simulate(options);
  if (!simulated) return std::fprintf(stderr, "%s\n", simulated.error().message.c_str()), 1;
  const cromer::Trajectory& motion = simulated->runs.front().trajectory;
  const cromer::LawFit found = cromer::fit_law({motion.t, motion.x}, {});
  std::printf("cromer %s: w = %.9f rad/s, decay rate %.9f 1/s\n", CROMER_VERSION,
              found.angular_frequency().value, found.decay_rate().value);
  const bool right =
      std::abs(found.angular_frequency().value - 3) < 1e-6 && std::abs(found.decay_rate().value - 0.05) < 1e-6;
  return right ? 0 : 1;
}
