// What each method makes of an undamped oscillator of 3 rad/s at steps of 0.05 s.
#include <cromer/cromer.h>

#include <cstdio>

int main() {
  const auto methods = cromer::methods({.natural_frequency = 3, .damping_ratio = 0, .step = 0.05});
  if (!methods) return std::fprintf(stderr, "%s\n", methods.error().message().c_str()), 2;
  for (const cromer::MethodInfo& method : *methods) {
    if (!method.effect || !method.effect->decay_rate) continue;
    std::printf("%-18s decay rate %+.2e 1/s, swings at %.6f rad/s, %s\n", method.name.c_str(),
                *method.effect->decay_rate, *method.effect->angular_frequency,
                method.effect->stable ? "stable" : "grows");
  }
}
