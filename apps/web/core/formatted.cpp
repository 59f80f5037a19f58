#include "formatted.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "cromer/base/number.h"

namespace cromer::core::page {
namespace {

/// A decimal number: digits[0].digits[1]... × 10^exponent; "0" and 0 for zero.
struct Decimal {
  std::string digits;
  int exponent = 0;
};

/// A large whole number in words of 32 bits, the lowest first.
class Whole {
 public:
  explicit Whole(std::uint64_t value)
      : figures_{static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32)} {}

  void multiply(std::uint32_t factor) {
    std::uint64_t carry = 0;
    for (std::uint32_t& figure : figures_) {
      carry += std::uint64_t{figure} * factor;
      figure = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    if (carry > 0) figures_.push_back(static_cast<std::uint32_t>(carry));
  }

  /// Returns the remainder.
  std::uint32_t divide(std::uint32_t divisor) {
    std::uint64_t rest = 0;
    for (std::size_t i = figures_.size(); i-- > 0;) {
      rest = rest << 32 | figures_[i];
      figures_[i] = static_cast<std::uint32_t>(rest / divisor);
      rest %= divisor;
    }
    while (!figures_.empty() && figures_.back() == 0) figures_.pop_back();
    return static_cast<std::uint32_t>(rest);
  }

  bool is_zero() const { return figures_.empty(); }

 private:
  std::vector<std::uint32_t> figures_;
};

/// The exact decimal value of a double, which has at most 767 digits.
Decimal all_digits(double value) {
  if (value == 0) return {"0", 0};
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  exponent -= 53;
  Whole whole(static_cast<std::uint64_t>(std::ldexp(fraction, 53)));
  // m × 2^-k is m × 5^k × 10^-k.
  const std::uint32_t factor = exponent < 0 ? 5 : 2, thirteen_times = exponent < 0 ? 1'220'703'125 : 8192;
  int times = std::abs(exponent);
  for (; times >= 13; times -= 13) whole.multiply(thirteen_times);
  for (; times > 0; --times) whole.multiply(factor);
  std::string digits;
  while (!whole.is_zero()) {
    std::uint32_t nine = whole.divide(1'000'000'000);
    for (int i = 0; i < 9; ++i, nine /= 10) digits += static_cast<char>('0' + nine % 10);
  }
  while (digits.back() == '0') digits.pop_back();
  std::reverse(digits.begin(), digits.end());
  return {digits, static_cast<int>(digits.size()) - 1 + std::min(exponent, 0)};
}

Decimal one_more(Decimal decimal) {
  std::size_t i = decimal.digits.size();
  while (i > 0 && decimal.digits[i - 1] == '9') decimal.digits[--i] = '0';
  if (i > 0) {
    ++decimal.digits[i - 1];
  } else {
    decimal.digits.insert(decimal.digits.begin(), '1');
    if (decimal.digits.size() > 1) decimal.digits.pop_back();
    ++decimal.exponent;
  }
  return decimal;
}

/// The first digits of a number, and whether the rest rounds them up.
struct Cut {
  Decimal first;
  bool up = false;
};

Cut cut(const Decimal& all, int count) {
  Decimal first{all.digits.substr(0, static_cast<std::size_t>(count)), all.exponent};
  first.digits.resize(static_cast<std::size_t>(count), '0');
  if (all.digits.size() <= static_cast<std::size_t>(count)) return {first, false};
  const std::string_view others = std::string_view(all.digits).substr(static_cast<std::size_t>(count));
  const bool half = others[0] == '5' && others.find_first_not_of('0', 1) == others.npos;
  const bool odd = count > 0 && (first.digits.back() & 1) != 0;
  return {first, half ? odd : others[0] >= '5'};
}

Decimal rounded(const Decimal& all, int count) {
  const Cut at = cut(all, count);
  return at.up ? one_more(at.first) : at.first;
}

/// 10^power; exact up to 22.
double power_of_ten(int power) {
  double ten = 1;
  for (; power > 0; --power) ten *= 10;
  return ten;
}

/// Rounded digits, and the number that they are read as.
struct Quick {
  Decimal decimal;
  double read = 0;
};

/// Up to 15 digits of numbers of everyday size, in double arithmetic, whose error is less than a tenth of the
/// last digit. Empty where that may round the wrong way.
std::optional<Quick> quick(double value, int count) {
  if (!(value > 1e-8 && value < 1e15) || count < 1 || count > 15) return std::nullopt;
  const int exponent = static_cast<int>(std::floor(std::log10(value))), shift = count - 1 - exponent;
  if (std::abs(shift) > 22) return std::nullopt;
  const double ten = power_of_ten(std::abs(shift));
  const double exact = shift < 0 ? value / ten : value * ten, whole = std::round(exact);
  if (std::fabs(std::fabs(exact - whole) - 0.5) < 0.1) return std::nullopt;
  std::string digits = std::to_string(static_cast<long long>(whole));
  if (digits.size() != static_cast<std::size_t>(count)) return std::nullopt;
  return Quick{{std::move(digits), exponent}, shift < 0 ? whole * ten : whole / ten};
}

void drop_zeros(Decimal& decimal) {
  while (decimal.digits.size() > 1 && decimal.digits.back() == '0') decimal.digits.pop_back();
}

double value_of(const Decimal& decimal) {
  return leading_number(decimal.digits.substr(0, 1) + '.' + decimal.digits.substr(1) + 'e' +
                        std::to_string(decimal.exponent))
      ->value;
}

/// The value rounded to `count` significant digits, halves to even. It is finite and not negative.
Decimal significant(double value, int count) {
  if (auto digits = quick(value, count)) return std::move(digits->decimal);
  return rounded(all_digits(value), count);
}

/// The value rounded to `count` digits behind the point.
Decimal behind_point(double value, int count) {
  const Decimal all = all_digits(value);
  const int significant_digits = all.exponent + 1 + count;
  if (significant_digits < 0) return {"0", -count};
  Decimal decimal = rounded(all, significant_digits);
  // Rounding has added a digit: 9.96 to one digit becomes 10.0.
  if (decimal.exponent > all.exponent && significant_digits > 0) decimal.digits += '0';
  if (decimal.digits.empty()) return {"0", -count};
  return decimal;
}

/// The fewest digits that are read back as the same double; among those the nearest to it.
Decimal fewest_digits(double value) {
  if (value == 0) return {"0", 0};
  if (auto digits = quick(value, 15); digits && digits->read == value) {
    drop_zeros(digits->decimal);
    return std::move(digits->decimal);
  }
  const Decimal all = all_digits(value);
  // Two decimals of 15 digits are never read as the same normal double: fewer digits need no try of their
  // own.
  for (int count = std::isnormal(value) ? 15 : 1;; ++count) {
    const Cut at = cut(all, count);
    const Decimal above = one_more(at.first);
    // Below a power of two doubles lie closer together than above it.
    for (const Decimal& each : {at.up ? above : at.first, above}) {
      if (value_of(each) != value) continue;
      Decimal fewest = each;
      drop_zeros(fewest);
      return fewest;
    }
  }
}

void append_scientific(std::string& text, const Decimal& decimal) {
  text += decimal.digits[0];
  if (decimal.digits.size() > 1) (text += '.') += decimal.digits.substr(1);
  const int size = std::abs(decimal.exponent);
  text += decimal.exponent < 0 ? "e-" : "e+";
  if (size < 10) text += '0';
  text += std::to_string(size);
}

void append_plain(std::string& text, const Decimal& decimal) {
  const std::string& digits = decimal.digits;
  if (decimal.exponent < 0) {
    text += "0." + std::string(static_cast<std::size_t>(-decimal.exponent - 1), '0') + digits;
    return;
  }
  const auto whole = static_cast<std::size_t>(decimal.exponent) + 1;
  text += digits.substr(0, whole);
  if (digits.size() > whole)
    (text += '.') += digits.substr(whole);
  else
    text.append(whole - digits.size(), '0');
}

void append_number(std::string& text, double value, char how, int digits) {
  if (std::signbit(value)) text += '-';
  value = std::fabs(value);
  if (!std::isfinite(value)) {
    text += std::isnan(value) ? "nan" : "inf";
    return;
  }
  if (how == 'f') return append_plain(text, behind_point(value, digits));
  if (how == 'e') return append_scientific(text, significant(value, digits + 1));
  constexpr int most_shortest = 16;
  Decimal decimal = how == 'g' ? significant(value, std::max(digits, 1)) : fewest_digits(value);
  const int most = how == 'g' ? std::max(digits, 1) : most_shortest;
  drop_zeros(decimal);
  if (decimal.exponent < -4 || decimal.exponent >= most)
    append_scientific(text, decimal);
  else
    append_plain(text, decimal);
}

}  // namespace

void Argument::append_to(std::string& text, std::string_view how, int digits) const {
  if (kind_ == Kind::text) text += text_;
  if (kind_ == Kind::whole) text += std::to_string(whole_);
  if (kind_ == Kind::number) append_number(text, number_, how.empty() ? ' ' : how.back(), digits);
}

std::string formatted(std::string_view text, std::initializer_list<Argument> arguments) {
  std::string result;
  const Argument* next = arguments.begin();
  while (!text.empty()) {
    const std::size_t brace = text.find('{');
    result += text.substr(0, brace);
    if (brace == text.npos) break;
    text.remove_prefix(brace + 1);
    const bool numbered = text[0] >= '0' && text[0] <= '9';
    const Argument& argument = numbered ? arguments.begin()[text[0] - '0'] : *next++;
    int digits = 0;
    if (text.starts_with(":.{}")) {
      digits = (next++)->whole();
      text.remove_prefix(4);
    } else if (text.starts_with(":.")) {
      for (text.remove_prefix(2); text[0] >= '0' && text[0] <= '9'; text.remove_prefix(1))
        digits = 10 * digits + (text[0] - '0');
    }
    const std::size_t end = text.find('}');
    argument.append_to(result, text.substr(0, end), digits);
    text.remove_prefix(end + 1);
  }
  return result;
}

}  // namespace cromer::core::page
