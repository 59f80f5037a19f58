// Numbers written down (written_down.h): rows of a name and what a function gives, each number to a millionth
// of itself or a billionth of the largest in its row.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/written_down.h"

namespace cromer::core::test {

class NumberSheet {
 public:
  void row(const std::string& name, std::span<const double> numbers) {
    text_ += name + ":";
    for (const double each : numbers)
      text_ += std::isnan(each) ? std::string(" nan") : fmt::format(" {:.9g}", each + 0.0);
    text_ += "\n";
  }
  void row(const std::string& name, std::initializer_list<double> numbers) {
    row(name, std::span(numbers.begin(), numbers.size()));
  }
  /// Of a long list: its length, ends, sum, sum of squares, and one in which each has another weight.
  void in_short(const std::string& name, std::span<const double> numbers) {
    if (numbers.empty()) return row(name, {0});
    double sum = 0, squares = 0, weighed = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      sum += numbers[i];
      squares += numbers[i] * numbers[i];
      weighed += numbers[i] * (1 + std::cos(static_cast<double>(i)));
    }
    row(name, {static_cast<double>(numbers.size()), numbers.front(), numbers.back(), sum, squares, weighed});
  }

  void expect_as_in(const std::filesystem::path& file) const {
    expect_as_written_down(text_, file, same_row);
  }

 private:
  std::string text_;

  static bool same_row(const std::string& one, const std::string& other) {
    const std::size_t end = one.rfind(':');
    if (end == std::string::npos || other.compare(0, end + 1, one, 0, end + 1) != 0) return false;
    const std::vector<double> a = numbers_in(one.substr(end + 1)), b = numbers_in(other.substr(end + 1));
    double largest = 0;
    for (const double each : a)
      if (std::isfinite(each)) largest = std::max(largest, std::abs(each));
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (!(std::abs(a[i] - b[i]) <= 1e-6 * std::abs(a[i]) + 1e-9 * largest) &&
          fmt::format("{}", a[i]) != fmt::format("{}", b[i]))
        return false;
    return true;
  }
  static std::vector<double> numbers_in(const std::string& text) {
    std::vector<double> numbers;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
      double value = std::nan("");
      std::from_chars(word.data(), word.data() + word.size(), value);
      numbers.push_back(value);
    }
    return numbers;
  }
};

}  // namespace cromer::core::test
