// One free swing by forward Euler and by Euler-Cromer: which of them keeps the energy?
#include <cstdio>

#include "cromer/analysis/energy.h"
#include "cromer/methods/euler_cromer.h"
#include "cromer/methods/forward_euler.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

int main() {
  using namespace cromer;
  const Oscillator<double> oscillator{.mass = 0.2, .stiffness = 16};  // kg, N/m
  const State<double> start{.x = 0.03, .v = 0};                       // 3 cm, at rest
  const double before = energy(oscillator, start);

  with_terms(oscillator, HarmonicDrive<double>{}, [&](const auto& system) {
    const auto run = [&](const auto& method) {
      const Outcome outcome =
          solve(system, method, {.from = 0, .until = 5}, start, 0.01, [](double, const State<double>&) {});
      std::printf("%-14s energy after 5 s: %.3g times the first\n", method.info.name.data(),
                  energy(oscillator, outcome.y) / before);
    };
    run(ForwardEuler{});
    run(EulerCromer{});
  });
}
