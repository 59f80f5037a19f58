#include "cromer/documents/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cromer/base/ascii.h"
#include "cromer/base/quantity.h"
#include "cromer/documents/words/words.h"
#include "cromer/identify/motion/motion.h"

namespace cromer::core {

std::string readable_name(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string_view term_of(const Law& law, std::string_view parameter) {
  std::string_view formula;
  for_each_term([&]<class T>() {
    if (!law.has<T>()) return;
    for (const CoefficientInfo& info : T::coefficients)
      if (info.parameter == parameter || info.in_si == parameter) formula = T::info.formula;
  });
  return formula;
}

std::string viscous_part_in_words(const Law& law, std::string_view parameter, Language language) {
  return is_viscous_part(law, parameter) ? in_words(parameter_named(parameter, law), {language}) : "";
}

std::string in_words(const Estimate& estimate, std::string_view unit) {
  return format_quantity({estimate.value, estimate.standard_error}, unit == "1" ? "" : unit);
}

std::string method_in_words(std::string_view method) { return in_words(Notice{std::string(method)}); }

std::string terms_in_words(const Law& law, Language language) {
  const std::string names = to_text(law);
  std::string words;
  for (const std::string_view name : split(names, '+')) {
    std::string code(name);
    std::replace(code.begin(), code.end(), '-', '_');
    if (name == Viscous::info.name) code = "viscous_damping";
    if (name == Friction::info.name) code = "dry_friction";
    words += (words.empty() ? "" : ", ") + in_words(Notice{std::move(code)}, {language});
  }
  return words;
}

std::string recording_title(const FittedRecording& fitted) {
  const std::string& column = fitted.series.column;
  return fmt::format("{}{}{}, run {}", fitted.file, column.empty() ? "" : ", ", column, fitted.series.run);
}

std::string fitted_unit(const FittedRecording& fitted) {
  for (const auto& parameter : fitted.parameters)
    if (parameter.name == "equilibrium") return parameter.unit;
  return "";
}

std::string percent(double part) {
  if (std::abs(part) < 1e-12) return "0 %";
  return std::abs(part) < 0.995 ? fmt::format("{:.2g} %", 100 * part) : fmt::format("{:.0f} %", 100 * part);
}
std::string percent_off(double part) { return (part >= 1e-12 ? "+" : "") + percent(part); }

int digits_of_end(double end, double low, double high) {
  const double half = (high - low) / 2;
  if (!(half > 0) || !std::isfinite(half)) return 4;
  const double last = std::floor(std::log10(half)) - 1, place = std::pow(10.0, last);
  const double size = std::abs(std::round(end / place)) * place;
  return size > 0 ? std::clamp(static_cast<int>(std::floor(std::log10(size * (1 + 1e-12))) - last) + 1, 1, 15)
                  : 1;
}

std::string interval_text(double low, double high) {
  constexpr double rounding = 1e-10;  // of the ends
  if (high - low <= rounding * std::max(std::abs(low), std::abs(high))) return "to rounding";
  return fmt::format("between {} and {}", rounded(low, digits_of_end(low, low, high)),
                     rounded(high, digits_of_end(high, low, high)));
}

namespace {

/// The number of characters of a UTF-8 text: its bytes without continuation bytes.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

std::vector<std::string> short_names(std::span<const std::string> files) {
  std::map<std::string, std::string> file_of;
  std::vector<std::string> names;
  for (const std::string& file : files) {
    names.push_back(file.substr(file.find_last_of('/') + 1));  // npos + 1 is 0
    if (file_of.emplace(names.back(), file).first->second != file) return {files.begin(), files.end()};
  }
  return names;
}

std::string text_table(const std::vector<std::vector<std::string>>& rows, std::size_t numbers_from,
                       std::size_t numbers_to) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  std::string out;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string fill(widths[i] - width(row[i]), ' ');
      const bool number = i >= numbers_from && i < numbers_to;
      line += (i ? "  " : "") + (number ? fill + row[i] : row[i] + fill);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  }
  return out;
}

}  // namespace cromer::core
