// Arrays in, the law out: no file is needed.
#include <cromer/cromer.h>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  std::vector<double> t, y;
  for (int i = 0; i < 2000; ++i) {
    t.push_back(0.01 * i);
    y.push_back(0.05 * std::exp(-0.05 * t[i]) * std::cos(3 * t[i]) + 1e-4 * std::sin(7919.0 * i * i));
  }
  const auto fit = cromer::fit(t, y, {.law = "viscous", .mass = {0.2176, 0.0003}});
  if (!fit) return std::fprintf(stderr, "%s\n", fit.error().message().c_str()), 2;
  const cromer::Estimate rate = fit->find("decay_rate").value(), k = fit->find("stiffness").value();
  std::printf("decay rate %.5f 1/s, 95 %% from %.5f to %.5f\n", rate.value, rate.low, rate.high);
  std::printf("spring constant %.4f +- %.4f N/m\n", k.value, k.standard_error);
  return rate.low < 0.05 && 0.05 < rate.high ? 0 : 1;
}
