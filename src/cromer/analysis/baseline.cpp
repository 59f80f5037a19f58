#include "cromer/analysis/baseline.h"

#include <cstddef>

namespace cromer::core {

// By polynomials that are orthogonal on the samples (G. E. Forsythe, J. SIAM 5, 74 (1957)).
std::vector<double> least_squares_polynomial(std::span<const double> y, int degree) {
  const std::size_t n = y.size();
  const auto x = [n](std::size_t i) {
    return n > 1 ? 2 * static_cast<double>(i) / static_cast<double>(n - 1) - 1 : 0;
  };
  std::vector<double> sum(n, 0.0), rest(y.begin(), y.end()), p(n, 1.0), before(n, 0.0);
  double norm_before = 1;
  for (int k = 0; k <= degree; ++k) {
    double norm = 0, along = 0, moment = 0;
    for (std::size_t i = 0; i < n; ++i) {
      norm += p[i] * p[i];
      along += rest[i] * p[i];
      moment += x(i) * p[i] * p[i];
    }
    const double factor = along / norm, shift = moment / norm, back = k > 0 ? norm / norm_before : 0;
    for (std::size_t i = 0; i < n; ++i) {
      sum[i] += factor * p[i];
      rest[i] -= factor * p[i];
      const double next = (x(i) - shift) * p[i] - back * before[i];
      before[i] = p[i];
      p[i] = next;
    }
    norm_before = norm;
  }
  return sum;
}

}  // namespace cromer::core
