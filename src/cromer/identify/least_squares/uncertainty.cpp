#include "cromer/identify/least_squares/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cromer/base/pi.h"

namespace cromer::core {
namespace {

// Gamma(a + 1/2)/(sqrt(a) Gamma(a)): its series in 1/a beyond 40, brought down by Gamma(a + 1) = a Gamma(a).
double gamma_ratio(double a) {
  double shift = 1;
  double b = a;
  for (; b < 40; b += 1) shift *= b / (b + 0.5);
  const double u = 1 / b;
  const double series =
      1 + u * (-1.0 / 8 +
               u * (1.0 / 128 +
                    u * (5.0 / 1024 + u * (-21.0 / 32768 + u * (-399.0 / 262144 + u * (869.0 / 4194304))))));
  return shift * std::sqrt(b / a) * series;
}

// a B(a, b) I_x(a, b)/(x^a (1 - x)^b) as a continued fraction by Lentz's method; x < (a + 1)/(a + b + 2).
double beta_fraction(double x, double a, double b) {
  double c = 1, d = 0, fraction = 1;
  for (int n = 1; n < 100000; ++n) {
    const int m = n / 2;
    const double numerator = n % 2 == 0 ? m * (b - m) * x / ((a + n - 1) * (a + n))
                                        : -(a + m) * (a + b + m) * x / ((a + n - 1) * (a + n));
    d = 1 / (1 + numerator * d);
    c = 1 + numerator / c;
    fraction *= c * d;
    if (std::abs(c * d - 1) <= std::numeric_limits<double>::epsilon()) break;
  }
  return 1 / fraction;
}

// The density at t >= 0 and the probability of values above it.
struct Tail {
  double density, above;
};

Tail tail(double t, double degrees) {
  const double a = degrees / 2, square = t * t / degrees;
  const double constant = gamma_ratio(a) / std::sqrt(two_pi);  // density at 0
  const double power = std::exp(-a * std::log1p(square));      // x^a
  const double x = 1 / (1 + square), rest = square / (1 + square);
  const double density = constant * power / std::sqrt(1 + square);
  // x^a (1 - x)^(1/2)/B(a, 1/2) is t times the density, of two halves each.
  if (x < (a + 1) / (a + 2.5)) return {density, t * density / degrees * beta_fraction(x, a, 0.5)};
  return {density, 0.5 - t * density * beta_fraction(rest, 0.5, a)};
}

}  // namespace

double student_cdf(double t, double degrees) {
  const double above = tail(std::abs(t), degrees).above;
  return t < 0 ? above : 1 - above;
}

namespace {

// The tail is convex: from anywhere below it Newton's iteration climbs to the root and never passes it.
double climb(double t, double p, double degrees) {
  for (int i = 0; i < 200; ++i) {
    const Tail at = tail(t, degrees);
    const double step = (at.above - (1 - p)) / at.density;
    t += step;
    if (!(step > 1e-15 * t)) break;
  }
  return t;
}

}  // namespace

double student_quantile(double p, double degrees) { return climb(0, p, degrees); }

double student_95(double degrees) {
  constexpr double z = 1.959963984540054;  // of infinitely many degrees of freedom
  if (degrees > 1e6) return z;
  // The quantile's series in 1/degrees (Abramowitz and Stegun 26.7.5), broken off, lies below it.
  const double n = std::max(1.0, degrees), square = z * z;
  const double below = z * (1 + ((square + 1) / 4 + (square * (5 * square + 16) + 3) / (96 * n)) / n);
  return climb(below, 0.975, n);
}

Estimate make_estimate(double value, double standard_error, double t) {
  return {value, standard_error, value - t * standard_error, value + t * standard_error};
}

}  // namespace cromer::core
