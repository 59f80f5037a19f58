// A mass under a recorded force: simulated, then its law found again from force and motion.
#include <cromer/cromer.h>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  std::vector<double> force;
  for (int i = 0; i < 3000; ++i)
    force.push_back(std::sin(2e-6 * i * i) + 0.5 * std::sin(0.031 * i));  // N, each 10 ms
  const cromer::Oscillator truth{.mass = 2, .stiffness = 18, .damping = 0.4};
  const cromer::SampledForce drive{force, 0.01};
  const auto run = cromer::simulate(truth, {.method = "exact", .drive = drive, .step = 0.01, .until = 29.99});
  if (!run) return std::fprintf(stderr, "%s\n", run.error().message().c_str()), 2;
  const auto fit = cromer::fit(run->t, run->x, {.law = "viscous", .force = force});
  if (!fit) return std::fprintf(stderr, "%s\n", fit.error().message().c_str()), 2;
  for (const cromer::Parameter& each : fit->parameters)
    std::printf("%-18s %.6g %s\n", each.name.c_str(), each.estimate.value, each.unit.c_str());
  return fit->succeeded() ? 0 : 1;
}
