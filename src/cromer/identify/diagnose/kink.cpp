#include "cromer/identify/diagnose/kink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "cromer/identify/least_squares/normal_equations.h"

namespace cromer::core {
namespace {

/// Linear least squares; row(i) gives the values of the n functions at the i-th place.
template <std::size_t n, class Row>
LinearFit fitted(std::span<const double> values, Row row) {
  NormalEquations equations{.size = n};
  for (std::size_t i = 0; i < values.size(); ++i) equations.add_row(row(i), values[i]);
  LinearFit curve = solve(equations);
  if (!curve.ok) return curve;
  // Summed afresh: what is left may be less than the rounding of the squares.
  curve.rest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::array<double, n> f = row(i);
    double off = values[i];
    for (std::size_t j = 0; j < n; ++j) off -= f[j] * curve.x[j];
    curve.rest += off * off;
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
      const LinearFit curve = fitted<3>(half, [&](std::size_t i) {
        const double scale = std::exp(-rate * s[i]) / (2 * envelope[i] * envelope[i]);
        return std::array<double, 3>{scale, scale * std::cos(turn * s[i]), scale * std::sin(turn * s[i])};
      });
      best = std::min(best, curve.rest);
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
  const LinearFit smooth = fitted<5>(values, [&](std::size_t i) {
    const double at = s[i];
    return std::array<double, 5>{1, at, at * at, at * at * at, at * at * at * at};
  });
  LinearFit best;
  double place = 0;
  for (std::size_t i = fewest; i + fewest <= n; ++i) {
    const double kink = s[i];
    const LinearFit bent = fitted<4>(values, [&](std::size_t k) {
      const double before = std::min(s[k] - kink, 0.0), after = std::max(s[k] - kink, 0.0);
      return std::array<double, 4>{1, before, after, after * after};
    });
    if (!(bent.rest < best.rest)) continue;
    best = bent;
    place = kink;
  }
  if (!(3 * best.rest < std::min(smooth.rest, beat_squares(s, amplitude)))) return std::nullopt;
  return Kink{middle + half * place, best.x[1] / half, best.x[2] / half};
}

}  // namespace cromer::core
