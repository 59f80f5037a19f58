#include "apps/web/core/formatted.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace cromer::core::page {
namespace CROMER_FILE {

/// Halves, powers of two and ten, the smallest and the largest; then doubles of random bits and of everyday
/// size.
std::vector<double> numbers() {
  using Limits = std::numeric_limits<double>;
  std::vector<double> all{0,
                          -0.0,
                          0.5,
                          1.5,
                          2.5,
                          0.125,
                          0.375,
                          9.5,
                          9.96,
                          99.5,
                          0.05,
                          0.0625,
                          1e15,
                          1e16,
                          1e17,
                          1.2345678901234568e17,
                          9.999999e-5,
                          1e-4,
                          Limits::max(),
                          Limits::min(),
                          Limits::denorm_min(),
                          Limits::infinity(),
                          3 * Limits::denorm_min()};
  for (int i = -1074; i < 1024; i += 7) all.push_back(std::ldexp(1, i));
  std::mt19937_64 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const std::uint64_t bits = random();
    double any = 0;
    std::memcpy(&any, &bits, sizeof any);
    if (std::isfinite(any)) all.push_back(any);
    all.push_back(std::uniform_real_distribution<double>(-1000, 1000)(random));
    all.push_back(std::round(1000 * std::uniform_real_distribution<double>(0, 10)(random)) / 1000);
  }
  return all;
}

TEST(Formatted, WritesNumbersAsPrintfDoes) {
  for (const double value : numbers())
    for (const auto& [ours, theirs] : {std::pair{"{:.6g}", "%.6g"},
                                       {"{:.1g}", "%.1g"},
                                       {"{:.15g}", "%.15g"},
                                       {"{:.0f}", "%.0f"},
                                       {"{:.3f}", "%.3f"},
                                       {"{:.0e}", "%.0e"}}) {
      char expected[400];
      std::snprintf(expected, sizeof expected, theirs, value);
      ASSERT_EQ(formatted(ours, {value}), expected);
    }
}

/// The significant digits: no sign, point or exponent, and no zeros at either end.
std::string digits_of(std::string_view number) {
  std::string digits;
  for (const char c : number.substr(0, number.find('e')))
    if (c >= (digits.empty() ? '1' : '0') && c <= '9') digits += c;
  return digits.substr(0, digits.find_last_not_of('0') + 1);
}

TEST(Formatted, WritesTheFewestDigitsThatReadTheSame) {
  for (const double value : numbers()) {
    if (!std::isfinite(value) || value == 0) continue;
    char expected[400];
    *std::to_chars(expected, expected + 400, std::fabs(value), std::chars_format::scientific).ptr = 0;
    const std::string written = formatted("{}", {value});
    ASSERT_EQ(digits_of(written), digits_of(expected));
    ASSERT_EQ(std::strtod(written.c_str(), nullptr), value);
  }
  EXPECT_EQ(formatted("{} {} {} {}", {1e15, 1e16, 0.0001, 0.00001}), "1000000000000000 1e+16 0.0001 1e-05");
  EXPECT_EQ(formatted("{} {} {}", {-0.0, 2.5, -1.0}), "-0 2.5 -1");
}

TEST(Formatted, PutsTextIn) {
  EXPECT_EQ(formatted("", {}), "");
  EXPECT_EQ(formatted("{}, {} of {}{}", {"one", std::string("two"), std::size_t{3}, '!'}), "one, two of 3!");
  EXPECT_EQ(formatted("{:.{}g} {:.1f} %", {3.14159, 3, 0.25}), "3.14 0.2 %");
  EXPECT_EQ(formatted("{0}{1}{0}10", {"a", "b"}), "aba10");
  EXPECT_EQ(formatted("{}", {-7}), "-7");
}

}  // namespace CROMER_FILE
}  // namespace cromer::core::page
