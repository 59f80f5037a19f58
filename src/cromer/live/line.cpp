#include "cromer/live/line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "cromer/base/ascii.h"
#include "cromer/base/number.h"

namespace cromer::core {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t end = text.find(separator);
    fields.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    text.remove_prefix(end + 1);
  }
}

std::vector<std::string_view> split_at_blanks(std::string_view text) {
  std::vector<std::string_view> fields;
  while (!(text = trimmed(text)).empty()) {
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    fields.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return fields;
}

/// The hard separator of a line, or a blank.
char separator_of(std::string_view text) {
  for (const char hard : {';', '\t', ','})
    if (text.find(hard) != std::string_view::npos) return hard;
  return ' ';
}

/// The number that a whole field is; NaN for a missing one, nothing for anything else.
std::optional<double> number_of(std::string_view field, char decimal) {
  const std::string word = lower(field);
  if (word.empty() || word == "nan" || word == "null") return std::numeric_limits<double>::quiet_NaN();
  const auto number = leading_number(field, decimal);
  if (!number || number->length != field.size() || !std::isfinite(number->value)) return std::nullopt;
  return number->value;
}

bool is_text(std::string_view text) {
  return std::none_of(text.begin(), text.end(),
                      [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t'; });
}

bool is_word(std::string_view field) {
  return std::any_of(field.begin(), field.end(), [](char c) { return lower(c) >= 'a' && lower(c) <= 'z'; });
}

}  // namespace

Line read_line(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) return {};
  if (text.front() == '#' || text.front() == '%') return {LineKind::comment};
  if (!is_text(text)) return {LineKind::garbage};
  const char separator = separator_of(text);
  const auto fields = separator == ' ' ? split_at_blanks(text) : split(text, separator);
  const char decimal =
      (separator == ';' || separator == '\t') && text.find('.') == std::string_view::npos ? ',' : '.';

  Line line{LineKind::numbers};
  std::size_t words = 0;
  for (const auto field : fields) {
    if (const auto number = number_of(field, decimal))
      line.numbers.push_back(*number);
    else
      words += is_word(field) && !is_digit(field.front());
    line.words.emplace_back(field);
  }
  if (line.numbers.size() == fields.size()) return {LineKind::numbers, std::move(line.numbers)};
  // Without hard separators a heading may hold blanks of its own.
  if (separator == ' ' && line.numbers.empty() && is_word(text) && !is_digit(text.front()))
    return {LineKind::words, {}, {std::string(text)}};
  if (words == fields.size()) return {LineKind::words, {}, std::move(line.words)};
  return {LineKind::garbage};
}

std::string shown(std::string_view text, std::size_t longest) {
  std::string out(text.substr(0, longest));
  for (char& c : out)
    if (c < ' ' || c > '~') c = '?';
  return text.size() > longest ? out + "..." : out;
}

}  // namespace cromer::core
