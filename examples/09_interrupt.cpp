// Long work reports its progress and can be ended early: what was computed by then comes back.
#include <cromer/cromer.h>

#include <cstdio>

int main() {
  const cromer::Oscillator oscillator = cromer::with_frequency(10, 0.001);
  const auto half_way = [](double done) {
    std::printf("%3.0f %%\n", 100 * done);
    return done < 0.5;
  };
  const auto run = cromer::simulate(
      oscillator, {.method = "rk4", .step = 1e-4, .until = 2000, .every = 1000, .progress = half_way});
  if (!run) return std::fprintf(stderr, "%s\n", run.error().message().c_str()), 2;
  std::printf("%s: %zu states, the last at %.1f s\n", run->message.c_str(), run->size(), run->t.back());
  return run->interrupted ? 0 : 1;
}
