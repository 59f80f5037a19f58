// 1e8 steps of Euler-Cromer: how far the modified energy that it conserves drifts, with ordinary sums and
// with compensated ones. Prints lines of tab-separated "row, drift, seconds".
#include <chrono>
#include <cstdio>

#include "cromer/analysis/energy.h"
#include "cromer/base/compensated.h"
#include "cromer/methods/euler_cromer.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/run/solve.h"

namespace {

using namespace cromer::core;
using cromer::State;

template <class Number>
void report(const char* row, long long steps, double h) {
  const Oscillator<double> undamped{.mass = 1, .stiffness = 36};
  Drift drift;
  long long n = 0;
  const auto begin = std::chrono::steady_clock::now();
  const DrivenOscillator<double, Terms{}> system(undamped, {});
  solve(system, EulerCromer{}, {0, static_cast<double>(steps) * h}, State<Number>{1.0, 0.3}, {h},
        [&](double, const State<Number>& y) {
          if (n++ % 1000 == 0)
            drift(modified_energy(undamped, h, State<double>{value_of(y.x), value_of(y.v)}));
        });
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::printf("%s, %.0e steps, w h = %.2g\t%.3g\t%.3g\n", row, static_cast<double>(steps), 6 * h,
              drift.largest(), seconds);
}

}  // namespace

int main(int argc, char** argv) {
  const long long steps = argc > 1 ? std::atoll(argv[1]) : 100'000'000;
  for (const double h : {0.01, 0.03, 0.1}) {
    report<double>("ordinary sums", steps, h);
    report<Compensated>("compensated sums", steps, h);
  }
}
