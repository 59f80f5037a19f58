// One free swing by forward Euler and by Euler-Cromer: which of them keeps the energy?
#include <cromer/cromer.h>

#include <cstdio>

int main() {
  const cromer::Oscillator oscillator{.mass = 0.2, .stiffness = 16};  // kg, N/m
  for (const char* method : {"forward-euler", "euler-cromer"}) {
    const auto run =
        cromer::simulate(oscillator, {.method = method, .position = 0.03, .step = 0.01, .until = 5});
    if (!run) return std::fprintf(stderr, "%s\n", run.error().message().c_str()), 2;
    std::printf("%-14s energy after 5 s: %.3g times the first\n", method,
                run->energy.back() / run->energy.front());
  }
}
