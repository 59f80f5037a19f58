#include "cromer/identify/diagnose/kink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "cromer/identify/least_squares/normal_equations.h"

namespace cromer {
namespace {

struct Curve {
  Parameters coefficients{};
  double sum_of_squares = HUGE_VAL;
};

/// Linear least squares; row(i) gives the values of the n functions at the i-th place.
template <std::size_t n, class Row>
Curve fitted(std::span<const double> values, Row row) {
  Parameters right{};
  SquareMatrix matrix{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::array<double, n> f = row(i);
    for (std::size_t j = 0; j < n; ++j) {
      right[j] += f[j] * values[i];
      for (std::size_t k = 0; k < n; ++k) matrix[j][k] += f[j] * f[k];
    }
  }
  std::array<bool, max_parameters> all{};
  all.fill(true);
  const ScaledCholesky factor(matrix, static_cast<int>(n), 0, all);
  Curve curve;
  if (!factor.ok()) return curve;
  curve.coefficients = factor.solve(right);
  curve.sum_of_squares = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::array<double, n> f = row(i);
    double off = values[i];
    for (std::size_t j = 0; j < n; ++j) off -= f[j] * curve.coefficients[j];
    curve.sum_of_squares += off * off;
  }
  return curve;
}

/// The least squares that the envelope of two sinusoids leaves which decay together: its square is a level
/// and a sinusoid times an exponential, s from -1 to 1.
double beat_squares(std::span<const double> s, std::span<const double> envelope) {
  // Over twice the square itself: then its error is one of the logarithm.
  const std::vector<double> half(envelope.size(), 0.5);
  double best = HUGE_VAL;
  for (double turn = 0.6; turn < 30; turn *= 1.12)   // [rad] of the beat in half the stretch
    for (double rate = 0; rate < 3; rate += 0.25) {  // of the squares over it
      const Curve curve = fitted<3>(half, [&](std::size_t i) {
        const double scale = std::exp(-rate * s[i]) / (2 * envelope[i] * envelope[i]);
        return std::array<double, 3>{scale, scale * std::cos(turn * s[i]), scale * std::sin(turn * s[i])};
      });
      best = std::min(best, curve.sum_of_squares);
    }
  return best;
}

}  // namespace

std::optional<Kink> find_kink(std::span<const double> t, std::span<const double> amplitude) {
  constexpr std::size_t fewest = 8;  // on each side
  const std::size_t n = t.size();
  if (n < 2 * fewest) return std::nullopt;
  // From -1 to 1, for the digits.
  const double middle = 0.5 * (t.front() + t.back()), half = 0.5 * (t.back() - t.front());
  std::vector<double> s;
  for (const double each : t) s.push_back((each - middle) / half);
  std::vector<double> values;
  for (const double A : amplitude) values.push_back(std::log(A));
  const Curve smooth = fitted<5>(values, [&](std::size_t i) {
    const double at = s[i];
    return std::array<double, 5>{1, at, at * at, at * at * at, at * at * at * at};
  });
  Curve best;
  double place = 0;
  for (std::size_t i = fewest; i + fewest <= n; ++i) {
    const double kink = s[i];
    const Curve bent = fitted<4>(values, [&](std::size_t k) {
      const double before = std::min(s[k] - kink, 0.0), after = std::max(s[k] - kink, 0.0);
      return std::array<double, 4>{1, before, after, after * after};
    });
    if (!(bent.sum_of_squares < best.sum_of_squares)) continue;
    best = bent;
    place = kink;
  }
  if (!(3 * best.sum_of_squares < std::min(smooth.sum_of_squares, beat_squares(s, amplitude))))
    return std::nullopt;
  return Kink{middle + half * place, best.coefficients[1] / half, best.coefficients[2] / half};
}

}  // namespace cromer
