#include "cromer/identify/modal/steady_lines.h"

#include <algorithm>
#include <cmath>

namespace cromer::core {

bool is_steady(const ModalRecord& record, const std::complex<double>& eigenvalue) {
  constexpr double change = 0.3;
  return std::abs(eigenvalue.real()) * (record.time(record.samples() - 1) - record.time(0)) < change;
}

Eigenvalues steady_lines(const ModalRecord& record, const std::vector<double>& candidates, double reach) {
  Eigenvalues lines;
  if (candidates.empty()) return lines;
  Eigen::MatrixXd values = values_of(record);
  values = DecayBasis(record, values, {}).residuals();
  const Eigen::VectorXd sizes = values.colwise().norm().cwiseMax(1e-300);
  values *= sizes.cwiseInverse().asDiagonal();
  const Periodogram spectrum = periodogram(values, record, 4);
  const auto last = static_cast<double>(spectrum.power.size() - 1);
  for (const double candidate : candidates) {
    const auto bin = [&](double w) {
      return static_cast<std::ptrdiff_t>(std::clamp(std::round(w / spectrum.step), 1.0, last));
    };
    const auto low = spectrum.power.begin() + bin(candidate - reach),
               high = spectrum.power.begin() + bin(candidate + reach) + 1;
    const auto highest = static_cast<double>(std::max_element(low, high) - spectrum.power.begin());
    const auto fitted = fit_eigenvalues(record, values, {{0, highest * spectrum.step}});
    if (!fitted || !is_steady(record, fitted->front())) continue;
    constexpr double most_of_it = 0.85;
    if (power_about(DecayBasis(record, values, *fitted), values, record, *fitted).share() < most_of_it)
      continue;
    const bool known = std::any_of(lines.begin(), lines.end(), [&](const std::complex<double>& line) {
      return std::abs(line.imag() - fitted->front().imag()) < reach;
    });
    if (!known) lines.push_back(fitted->front());
  }
  return lines;
}

}  // namespace cromer::core
