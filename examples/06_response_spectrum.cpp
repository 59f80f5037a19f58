// The response spectrum of a ground motion: a half sine of 1 m/s^2 that lasts 0.5 s.
#include <cromer/cromer.h>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  std::vector<double> acceleration;
  const double dt = 0.005;
  for (int i = 0; i <= 400; ++i) acceleration.push_back(i <= 100 ? std::sin(3.141592653589793 * i / 100) : 0);
  const std::vector<double> periods{0.1, 0.3, 0.5, 1, 2, 5};
  const auto spectrum =
      cromer::response_spectrum(acceleration, dt, {.damping_ratio = 0.02, .periods = periods});
  if (!spectrum) return std::fprintf(stderr, "%s\n", spectrum.error().message().c_str()), 2;
  for (std::size_t i = 0; i < periods.size(); ++i)
    std::printf("T = %4.1f s: SD = %.5f m, PSA = %.4f m/s^2\n", periods[i], spectrum->displacement[i],
                spectrum->pseudo_acceleration[i]);
}
