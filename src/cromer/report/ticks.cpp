#include "cromer/report/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cromer::core {
namespace {

constexpr double slack = 1e-6;  // of a step: a tick that rounding put just outside still belongs
constexpr int most_ticks = 1000;

std::string fixed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  if (text == "-0") return "0";
  if (text.front() == '-') text.replace(0, 1, "−");
  return text;
}

int exponent_of(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)) + 1e-12)); }

}  // namespace

double tick_step(double low, double high, int most) {
  const double span = high - low;
  if (!(span > 0) || !std::isfinite(span)) return 1;
  for (int exponent = exponent_of(span / most) - 1;; ++exponent) {
    for (const double mantissa : {1.0, 2.0, 2.5, 5.0}) {
      const double step = mantissa * std::pow(10.0, exponent);
      const double count = std::floor(high / step + slack) - std::ceil(low / step - slack) + 1;
      if (count <= most) return step;
    }
  }
}

std::vector<Tick> linear_ticks(double low, double high, double step) {
  std::vector<Tick> ticks;
  const double first = std::ceil(low / step - slack);
  const double last = std::min(std::floor(high / step + slack), first + most_ticks - 1);
  for (double n = first; n <= last; ++n) ticks.push_back({n * step, tick_label(n * step)});
  return ticks;
}

std::vector<Tick> logarithmic_ticks(double low, double high, int most) {
  const int first = static_cast<int>(std::floor(std::log10(low) - slack));
  const int last = static_cast<int>(std::ceil(std::log10(high) + slack));
  const auto inside = [&](double value) { return value >= low * (1 - slack) && value <= high * (1 + slack); };
  int decades = 0;
  for (int e = first; e <= last; ++e) decades += inside(std::pow(10.0, e));
  const int stride = std::max(1, (decades + most - 1) / std::max(most, 1));
  std::vector<Tick> ticks;
  for (int e = first; e <= last; ++e) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, e);
      if (!inside(value)) continue;
      const bool labelled =
          decades >= 3 ? digit == 1 && e % stride == 0 : digit == 1 || digit == 2 || digit == 5;
      if (!labelled && decades > 2 * most) continue;
      const bool plain = std::abs(first) <= 3 && std::abs(last) <= 4;
      ticks.push_back({value, !labelled             ? ""
                              : plain || digit != 1 ? tick_label(value)
                                                    : fmt::format("10^{{{}}}", fixed(e, 0))});
    }
  }
  return ticks;
}

std::string tick_label(double value) {
  if (value == 0) return "0";
  const int exponent = exponent_of(value);
  if (exponent >= -3 && exponent < 4)
    return fixed(value, std::max(0, 3 - std::max(exponent, 0) + (exponent < 0 ? -exponent - 1 : 0)));
  const std::string mantissa = fixed(value / std::pow(10.0, exponent), 2);
  return fmt::format("{}×10^{{{}}}", mantissa, fixed(exponent, 0));
}

}  // namespace cromer::core
