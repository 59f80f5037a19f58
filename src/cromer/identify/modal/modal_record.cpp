#include "cromer/identify/modal/modal_record.h"

namespace cromer::core {

double modal_assurance(std::span<const std::complex<double>> a, std::span<const std::complex<double>> b) {
  std::complex<double> product = 0;
  double size_a = 0, size_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    product += std::conj(a[i]) * b[i];
    size_a += std::norm(a[i]);
    size_b += std::norm(b[i]);
  }
  return std::norm(product) / (size_a * size_b);
}

}  // namespace cromer::core
