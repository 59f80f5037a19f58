// W6: chains of masses between two walls. Prints lines of tab-separated "row, who, seconds": a step of a
// chain of 1000 and of 10,000 masses, beside a plain loop, and beside how fast the processor adds one array
// to another of that length; and a whole run with errors below 1e-6, as its peer makes it.
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "bench/stopwatch.h"
#include "cromer/base/wide.h"
#include "cromer/methods/all.h"
#include "cromer/methods/vector_newton.h"
#include "cromer/model/network_system.h"
#include "cromer/run/solve.h"

namespace {

using namespace cromer::core;
using cromer::State;

constexpr double stiffness = 8, step = 0.01;

double mass_of(std::size_t i) { return 0.5 + 0.001 * static_cast<double>(i % 7); }

Network chain(std::size_t masses) {
  Network network;
  for (std::size_t i = 0; i < masses; ++i) network.masses.push_back({"m", mass_of(i)});
  for (std::size_t i = 0; i <= masses; ++i)
    network.links.push_back({i == 0 ? ground : i - 1, i == masses ? ground : i, {.stiffness = stiffness}});
  network.masses[masses / 2].start.x = 1;
  return network;
}

void print(const std::string& row, const char* who, double seconds) {
  std::printf("%s\t%s\t%.6g\n", row.c_str(), who, seconds);
  std::fflush(stdout);
}

volatile double used = 0;

template <class M>
void run(const NetworkSystem<>& system, const M& method, const State<MassVector>& start, double until,
         StepControl control) {
  solve(system, method, {0, until}, start, control,
        [](double, const State<MassVector>& y) { used = y.x.first[0]; });
}

/// Semi-implicit Euler as a careful programmer writes it for this chain alone.
void plain_loop(std::size_t masses, int steps) {
  std::vector<double> x(masses + 2), v(masses + 2), factor(masses + 2);
  for (std::size_t i = 0; i < masses; ++i) factor[i + 1] = step * stiffness / mass_of(i);
  x[masses / 2 + 1] = 1;
  for (int n = 0; n < steps; ++n) {
    for (std::size_t i = 1; i <= masses; ++i) v[i] += factor[i] * ((x[i - 1] - x[i]) + (x[i + 1] - x[i]));
    for (std::size_t i = 1; i <= masses; ++i) x[i] += step * v[i];
  }
  used = x[1];
}

/// a += s b, over and over, as fast as the processor can: two flops and 24 bytes a number. A step of the
/// chain must read and write twice as many.
void add_arrays(std::vector<double>& a, const std::vector<double>& b, int times) {
  for (int n = 0; n < times; ++n) {
    const double s = 1e-9 * n;
    for_each_index(a.size(), [s, from = b.data(), to = a.data()](std::size_t i) { to[i] += s * from[i]; });
  }
  used = a[0];
}

}  // namespace

int main() {
  for (const std::size_t masses : {std::size_t{1000}, std::size_t{10000}}) {
    const Network network = chain(masses);
    const NetworkSystem<> system(network);
    const State<MassVector> start = start_of(network);
    const int steps = static_cast<int>(2000000 / masses), few = steps / 20;
    const std::string row = "chain of " + std::to_string(masses) + ", ";
    std::vector<double> a(masses), b(masses, 1.0);
    const std::vector<double> times = bench::medians<std::function<void()>>(
        {[&] { run(system, EulerCromer{}, start, steps * step, step); }, [&] { plain_loop(masses, steps); },
         [&] { add_arrays(a, b, steps); }, [&] { run(system, Rk4{}, start, few * step, step); },
         [&] { run(system, Newmark{}, start, few * step, step); }},
        7);
    print(row + "euler-cromer, a step", "cromer", times[0] / steps);
    print(row + "euler-cromer, a step", "plain loop", times[1] / steps);
    print(row + "euler-cromer, a step", "one a += s b", times[2] / steps);
    print(row + "rk4, a step", "cromer", times[3] / few);
    print(row + "newmark, a step", "cromer", times[4] / few);
  }
  const Network network = chain(1000);
  const NetworkSystem<> system(network);
  print("chain of 1000, 10 s, errors below 1e-6", "cromer",
        bench::median_seconds(
            [&] { run(system, DormandPrince{}, start_of(network), 10, StepControl(0.1, 3e-7)); }, 5));
}
