#include "cromer/identify/least_squares/autoregression.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace cromer::core {
namespace {

// 1 - sum over k of a_k exp(-i k angle).
std::complex<double> response(const std::vector<double>& coefficients, double angle) {
  std::complex<double> sum = 1;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    sum -= coefficients[k] * std::polar(1.0, -static_cast<double>(k + 1) * angle);
  return sum;
}

}  // namespace

double Autoregression::density(double angle) const {
  return innovation / std::norm(response(coefficients, angle));
}

double Autoregression::log_variance(std::span<const double> slope, double samples) const {
  const std::size_t p = coefficients.size();
  double form = 0;
  for (std::size_t j = 0; j < p; ++j) {
    double a = slope[j], b = 0;
    for (std::size_t i = j; i < p; ++i) {
      if (i > j) a -= slope[i] * coefficients[i - j - 1];
      b += slope[i] * coefficients[p - 1 - (i - j)];
    }
    form += a * a - b * b;
  }
  return (2 + form) / samples;
}

// The recursion of Levinson and Durbin.
Autoregression yule_walker(std::span<const double> rho, std::size_t samples, std::size_t most) {
  const auto n = static_cast<double>(samples);
  Autoregression model, best;
  double least = 0;
  for (std::size_t p = 1; p <= most; ++p) {
    double reflection = rho[p];
    for (std::size_t k = 1; k < p; ++k) reflection -= model.coefficients[k - 1] * rho[p - k];
    reflection /= model.innovation;
    if (!(std::abs(reflection) < 1)) break;  // what is left is predicted to rounding
    const std::vector<double> before = model.coefficients;
    for (std::size_t k = 1; k < p; ++k) model.coefficients[k - 1] -= reflection * before[p - 1 - k];
    model.coefficients.push_back(reflection);
    model.innovation *= 1 - reflection * reflection;
    const double parameters = static_cast<double>(p);
    if (n <= parameters + 2) break;
    const double criterion = n * std::log(model.innovation) + 2 * parameters * n / (n - parameters - 1);
    if (criterion >= least) continue;
    least = criterion;
    best = model;
  }
  return best;
}

}  // namespace cromer::core
