// The resonance curve of a spring that stiffens, upwards and downwards: the jumps differ.
#include <cromer/cromer.h>

#include <cstdio>
#include <vector>

int main() {
  const cromer::Oscillator duffing{.mass = 1, .stiffness = 1, .damping = 0.1, .cubic = 0.5};
  std::vector<double> frequencies;
  for (int i = 0; i <= 40; ++i) frequencies.push_back(0.6 + 0.03 * i);
  const auto swept = cromer::sweep(
      duffing, frequencies,
      {.method = "rk4", .drive_amplitude = 0.3, .direction = cromer::SweepOptions::Direction::both});
  if (!swept) return std::fprintf(stderr, "%s\n", swept.error().message().c_str()), 2;
  const std::size_t n = frequencies.size();
  for (std::size_t i = 0; i < n; i += 4)
    std::printf("%.2f rad/s: up %.3f m, down %.3f m\n", frequencies[i], swept->amplitude[i],
                swept->amplitude[n + i]);
}
