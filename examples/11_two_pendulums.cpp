// Two pendulums joined by a spring: their beats, their modes, and the spring found from the motion.
#include <cromer/cromer.h>

#include <cstdio>

cromer::Network pendulums(std::optional<double> spring) {
  return {{{.name = "left", .inertia = 0.08, .position = 0.1}, {.name = "right", .inertia = 0.08}},
          {{.to = "left", .terms = {{"pendulum", 1.57}, {"damping", 5e-4}}},
           {.to = "right", .terms = {{"pendulum", 1.57}, {"damping", 5e-4}}},
           {.from = "left", .to = "right", .terms = {{"stiffness", spring}}}}};
}

int main() {
  const auto run = cromer::simulate(pendulums(0.05), {.method = "rk4", .step = 0.01, .until = 60});
  if (!run) return std::fprintf(stderr, "%s\n", run.error().message().c_str()), 2;
  const auto modes = cromer::modes(pendulums(0.05), {.method = {"newmark"}, .step = 0.05});
  for (const cromer::Mode& mode : modes->modes)
    std::printf("%.4f Hz, by newmark %.4f Hz\n", mode.frequency.value, *mode.methods[0].frequency);
  const auto fit = cromer::fit(run->t, run->x, pendulums(cromer::sought));
  if (!fit || !fit->succeeded()) return 1;
  const cromer::Estimate spring = fit->links[2].parameters[0].estimate;
  std::printf("the spring has %.5f N m, %.5f to %.5f\n", spring.value, spring.low, spring.high);
}
