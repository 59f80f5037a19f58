// A simulated motion sensor: offset + x + noise, rounded to the resolution.
//
// The same seed gives the same samples on every machine. The generator is integer arithmetic. The normal
// deviates need only sums, products, quotients and square roots, which IEEE 754 fixes to the last bit; the
// library's log differs between platforms and is not used.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "cromer/base/number.h"

namespace cromer::core {

/// What the sensor makes of a position.
struct Sensor {
  double noise = 0;       // [m] standard deviation, >= 0
  double resolution = 0;  // [m] >= 0; 0: not rounded
  double offset = 0;      // [m] reading at x = 0
  std::uint64_t seed = 1;
};

/// SplitMix64: G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", OOPSLA
/// 2014. Period 2^64.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15u;  // 2^64 over the golden ratio
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /// Uniform in [-1, 1), a multiple of 2^-52.
  double next_signed_unit() { return static_cast<double>(next() >> 11) * 0x1p-52 - 1; }

 private:
  std::uint64_t state_;
};

/// ln(x) for finite x > 0, to 2 units in the last place, the same bits everywhere. With x = m 2^e and m near
/// 1 it is 2 artanh((m - 1)/(m + 1)) + e ln 2.
inline double portable_log(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0.70710678118654752) {
    m *= 2;
    --exponent;
  }
  const double s = (m - 1) / (m + 1);  // |s| < 0.1716: the first term left out is below 1e-17 of the sum
  double sum = 0;
  for (int power = 21; power >= 1; power -= 2) sum = sum * s * s + 1.0 / power;
  return 2 * s * sum + exponent * 0.69314718055994531;
}

/// Standard normal deviates by the polar method: G. Marsaglia, T. A. Bray, SIAM Review 6, 260 (1964).
class NormalDeviates {
 public:
  explicit NormalDeviates(std::uint64_t seed) : uniform_(seed) {}

  double next() {
    if (has_second_) {
      has_second_ = false;
      return second_;
    }
    double u = 0, v = 0, s = 0;
    do {
      u = uniform_.next_signed_unit();
      v = uniform_.next_signed_unit();
      s = u * u + v * v;
    } while (s >= 1 || s == 0);
    const double scale = std::sqrt(-2 * portable_log(s) / s);
    second_ = v * scale;
    has_second_ = true;
    return u * scale;
  }

 private:
  SplitMix64 uniform_;
  double second_ = 0;
  bool has_second_ = false;
};

/// The readings of one sensor, one after another.
class SensorReadings {
 public:
  explicit SensorReadings(const Sensor& sensor) : sensor_(sensor), deviates_(sensor.seed) {}

  /// The next reading [m], of position x [m]; always finite.
  double next(double x) {
    constexpr double largest = std::numeric_limits<double>::max();
    const double sum = sensor_.offset + x + (sensor_.noise > 0 ? sensor_.noise * deviates_.next() : 0.0);
    const double reading = std::clamp(sum, -largest, largest);
    // From 2^53 steps on every double is a whole number of them.
    if (sensor_.resolution <= 0 || !(std::abs(reading) / sensor_.resolution < 0x1p53)) return reading;
    return to_15_digits(std::round(reading / sensor_.resolution) * sensor_.resolution);
  }

 private:
  Sensor sensor_;
  NormalDeviates deviates_;
};

}  // namespace cromer::core
