#include "cromer/analysis/air.h"

#include <algorithm>
#include <cmath>

namespace cromer::core {

double air_density(double T) {
  constexpr double pressure = 101325;                                // [Pa]
  constexpr double specific_gas_constant = 8.314462618 / 0.0289647;  // [J/(kg K)]
  return pressure / (specific_gas_constant * T);
}

double air_dynamic_viscosity(double T) {
  constexpr double beta = 1.458e-6;  // [kg/(s m K^0.5)]
  constexpr double S = 110.4;        // [K]
  return beta * T * std::sqrt(T) / (T + S);
}

double air_kinematic_viscosity(double T) { return air_dynamic_viscosity(T) / air_density(T); }

namespace {

struct Top {
  double t, speed;
};

// |v| at sample i, or at the top of the parabola through it and its neighbours where that lies within half a
// step of it. The two steps are taken as equal.
Top top_at(std::span<const double> t, std::span<const double> v, std::size_t i) {
  const double middle = std::abs(v[i]);
  if (i == 0 || i + 1 == v.size()) return {t[i], middle};
  const double sign = v[i] < 0 ? -1 : 1;
  const double left = sign * v[i - 1], right = sign * v[i + 1];
  const double curvature = left - 2 * middle + right;
  if (!(middle >= left && middle >= right && curvature < 0)) return {t[i], middle};
  const double offset = 0.5 * (left - right) / curvature;
  return {t[i] + offset * 0.5 * (t[i + 1] - t[i - 1]),
          middle - 0.125 * (left - right) * (left - right) / curvature};
}

}  // namespace

double reynolds_number(double v, double D, double nu) { return std::abs(v) * D / nu; }

std::vector<SpeedWindow> speed_windows(std::span<const double> t, std::span<const double> v, double length) {
  std::vector<SpeedWindow> windows;
  if (t.empty()) return windows;
  const double step = t.size() > 1 ? (t.back() - t.front()) / static_cast<double>(t.size() - 1) : 0;
  const double end = t.back() + 0.5 * step;  // the last sample stands for half a step after it
  std::size_t i = 0;
  for (long long k = 0;; ++k) {
    const double begin = t.front() + static_cast<double>(k) * length;
    if (begin + length > end) return windows;
    const double next =
        begin + length - 1e-9 * length;  // rounding must not put a boundary's sample into both
    SpeedWindow window{begin, -1, begin};
    for (; i < t.size() && t[i] < next; ++i) {
      const Top top = top_at(t, v, i);
      if (top.speed > window.speed) window = {begin, top.speed, std::clamp(top.t, begin, begin + length)};
    }
    if (window.speed >= 0) windows.push_back(window);
  }
}

}  // namespace cromer::core
