#include "cromer/analysis/butterworth.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace cromer::core {
namespace {

using InPlane = std::complex<double>;  // of the s or the z plane

/// The poles of the analogue filter [1/s] over 2/h, those with a positive imaginary part and the real ones.
std::vector<InPlane> analogue_poles(int order, const PassBand& band, double low, double high) {
  std::vector<InPlane> poles;
  for (int k = 0; k < order; ++k) {
    const InPlane pole = std::polar(1.0, std::numbers::pi * (2 * k + order + 1) / (2.0 * order));
    if (!band.has_low()) {
      poles.push_back(high * pole);
    } else if (!band.has_high()) {
      poles.push_back(low / pole);
    } else {
      // s^2 - B p s + Wl Wh = 0, the smaller root from the larger one.
      const InPlane half = (high - low) / 2 * pole, root = std::sqrt(half * half - low * high);
      const InPlane larger = std::abs(half + root) > std::abs(half - root) ? half + root : half - root;
      poles.push_back(larger);
      poles.push_back(low * high / larger);
    }
  }
  return poles;
}

InPlane section_response(const FilterSection& s, InPlane z) {
  return (s.b0 + (s.b1 + s.b2 / z) / z) / (1.0 + (s.a1 + s.a2 / z) / z);
}

}  // namespace

std::vector<FilterSection> butterworth(int order, const PassBand& band, double h) {
  const double low = band.has_low() ? std::tan(std::numbers::pi * band.low * h) : 0;
  const double high = band.has_high() ? std::tan(std::numbers::pi * band.high * h) : 0;
  std::vector<InPlane> pairs;  // one of each pair of conjugates
  std::vector<double> reals;
  for (const InPlane& s : analogue_poles(order, band, low, high)) {
    const InPlane z = (1.0 + s) / (1.0 - s);
    if (std::abs(s.imag()) < 1e-12 * std::abs(s))
      reals.push_back(z.real());
    else if (s.imag() > 0)
      pairs.push_back(z);
  }
  std::vector<FilterSection> sections;
  const auto slower = [](const InPlane& a, const InPlane& b) { return std::arg(a) < std::arg(b); };
  std::sort(pairs.begin(), pairs.end(), slower);
  for (const InPlane& z : pairs) sections.push_back({0, 0, 0, -2 * z.real(), std::norm(z)});
  std::sort(reals.begin(), reals.end());
  for (std::size_t i = 0; i < reals.size(); i += 2) {
    const double other = i + 1 < reals.size() ? reals[i + 1] : 0;
    sections.push_back({0, 0, 0, -(reals[i] + other), reals[i] * other});
  }
  // Zeros at z = 1 for what is too slow, at -1 for what is too fast; 1 where the filter lets all through.
  const double centre = 2 * std::atan(std::sqrt(low * high));
  const InPlane through = band.has_low() && band.has_high() ? std::polar(1.0, centre)
                          : band.has_low()                  ? InPlane(-1)
                                                            : InPlane(1);
  // Of a band the slow half of the sections stops what is too slow, the fast half what is too fast, and one
  // that is left over both: so none amplifies what others have to take off again.
  const bool both = band.has_low() && band.has_high();
  const std::size_t half = static_cast<std::size_t>(order) / 2;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    FilterSection& s = sections[i];
    const bool single = s.a2 == 0, slow = i < half, fast = i < pairs.size() && i >= pairs.size() - half;
    const double sign = (both ? slow : band.has_low()) ? -1 : 1;
    s.b0 = 1;
    if (both && !slow && !fast)
      s.b2 = -1;
    else
      s.b1 = single ? sign : 2 * sign, s.b2 = single ? 0 : 1;
    const double gain = std::abs(section_response(s, through));
    for (double* b : {&s.b0, &s.b1, &s.b2}) *b /= gain;
  }
  return sections;
}

double memory_of(std::span<const FilterSection> sections, double h) {
  double largest = 0;
  for (const FilterSection& s : sections) {
    const double half = -s.a1 / 2, square = half * half - s.a2;
    largest = std::max(largest, square < 0 ? std::sqrt(s.a2) : std::abs(half) + std::sqrt(square));
  }
  return largest > 0 ? h * std::log(1e-6) / std::log(largest) : 0;
}

void filter(std::span<const FilterSection> sections, std::vector<double>& samples) {
  for (const FilterSection& s : sections) {
    double first = 0, second = 0;
    for (double& x : samples) {
      const double y = s.b0 * x + first;
      first = s.b1 * x - s.a1 * y + second;
      second = s.b2 * x - s.a2 * y;
      x = y;
    }
  }
}

void filter_both_ways(std::span<const FilterSection> sections, std::vector<double>& samples) {
  filter(sections, samples);
  std::reverse(samples.begin(), samples.end());
  filter(sections, samples);
  std::reverse(samples.begin(), samples.end());
}

}  // namespace cromer::core
