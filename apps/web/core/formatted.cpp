#include "formatted.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "decimal.h"

namespace cromer::core::page {
namespace {

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

void drop_zeros(Decimal& decimal) {
  while (decimal.digits.size() > 1 && decimal.digits.back() == '0') decimal.digits.pop_back();
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
