// A fitted law can be simulated: beside the record, by any method, beyond the record's end.
#include <cromer/cromer.h>

#include <cstdio>
#include <string>

int main(int argc, char** argv) {
  const auto swing = cromer::read_file((argc > 1 ? std::string(argv[1]) : "data") + "/recording2.csv");
  if (!swing) return std::fprintf(stderr, "%s\n", swing.error().message().c_str()), 2;
  const auto fits = cromer::fit(*swing, {.mass = {0.2176, 0.0003}});
  if (!fits || !fits->front().succeeded()) return 1;
  const cromer::LawFit& fit = fits->front();
  const auto compared = cromer::compare(fit, {.method = "euler-cromer"});
  if (!compared) return std::fprintf(stderr, "%s\n", compared.error().message().c_str()), 2;
  for (const cromer::ComparedCurve& curve : compared->curves)
    std::printf("%-26s leaves %.3g m\n", curve.label.c_str(), curve.rms);
  const auto run =
      cromer::simulate(*fit.oscillator(), {.method = "rk4", .position = 0.05, .step = 0.001, .until = 20});
  if (!run) return std::fprintf(stderr, "%s\n", run.error().message().c_str()), 2;
  std::printf("after 20 s: x = %.4f m, %.2g of the energy is left\n", run->x.back(),
              run->energy.back() / run->energy.front());
}
