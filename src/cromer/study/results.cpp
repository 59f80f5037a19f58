#include "cromer/study/results.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"
#include "cromer/documents/json/json.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace {

/// "did you mean" the nearest name; empty if none is near.
template <class Map>
Notice near_in(const Map& map, std::string_view name) {
  std::vector<std::string_view> names;
  for (const auto& [key, value] : map) names.push_back(key);
  const std::string near = nearest(name, names);
  return near.empty() ? Notice{} : Notice{"perhaps_quoted", {{"near", near}}};
}

}  // namespace

Result<Results::Fact> Results::fact(std::string_view name) const {
  const auto found = facts_.find(name);
  if (found == facts_.end())
    return Error{"no_such_result", {{"name", name}, {"near", near_in(facts_, name)}}};
  return found->second;
}

Result<const ResultColumn*> Results::column(std::string_view name) const {
  const auto found = columns_.find(name);
  if (found == columns_.end())
    return Error{"no_such_result_column", {{"name", name}, {"near", near_in(columns_, name)}}};
  return &found->second;
}

std::string to_json(const Results& results) {
  Json document = Json::object();
  for (const auto& [name, fact] : results.facts()) {
    if (const auto* text = std::get_if<std::string>(&fact)) {
      document[name] = *text;
      continue;
    }
    const Number& number = std::get<Number>(fact);
    Json& entry = document[name];
    entry["value"] = number.quantity.value;
    if (number.quantity.uncertainty > 0) entry["standard_error"] = number.quantity.uncertainty;
    entry["unit"] = number.unit;
  }
  return to_text(document);
}

namespace {

/// How to write a number.
struct Format {
  std::optional<int> digits;
  std::string unit;
  double factor = 1;
  bool bare = false, with_uncertainty = true, concise = false, sign = false, si = false, magnitude = false;
};

Result<Format> parse_format(const std::vector<std::string_view>& parts, const Number& number) {
  Format format;
  format.unit = number.unit;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::string_view part = parts[i];
    int digits = 0;
    const auto [end, failed] = std::from_chars(part.data(), part.data() + part.size(), digits);
    if (failed == std::errc{} && end == part.data() + part.size() && digits > 0) {
      format.digits = digits;
    } else if (part == "bare") {
      format.bare = true;
    } else if (part == "no ±") {
      format.with_uncertainty = false;
    } else if (part == "concise") {
      format.concise = true;
    } else if (part == "signed") {
      format.sign = true;
    } else if (part == "abs") {
      format.magnitude = true;
    } else if (part == "si") {
      format.si = true;
    } else {
      const auto from = parse_unit(number.unit);
      const auto to = parse_unit(part);
      if (!to) return Error{"no_way_to_write", {{"part", part}}};
      if (!from || !(from->dimension == to->dimension))
        return Error{"value_not_written_in", {{"from", number.unit}, {"to", part}}};
      format.factor = from->factor / to->factor;
      format.unit = std::string(part);
    }
  }
  return format;
}

std::string write(const Number& number, const Format& format) {
  if (format.si) return shortest(number.quantity.value);
  Quantity quantity{number.quantity.value * format.factor, number.quantity.uncertainty * format.factor};
  if (format.magnitude) quantity.value = std::abs(quantity.value);
  if (!std::isfinite(quantity.value)) return "–";
  const std::string unit = format.bare || format.unit == "1" ? "" : format.unit;
  const std::string sign = format.sign && quantity.value > 0 ? "+" : "";
  if (format.digits)
    return sign + rounded(quantity.value, *format.digits) + (unit.empty() ? "" : "\u00a0" + unit);
  if (!format.with_uncertainty) quantity.uncertainty = 0;
  return sign + (format.concise ? format_concise(quantity, unit) : format_quantity(quantity, unit));
}

Result<std::string> look_up(std::string_view inside, const Results& results, std::string_view scope) {
  const auto parts = split(inside, ',');
  std::string name(parts.front());
  if (!name.empty() && name.front() == '.') name = std::string(scope) + name;
  const auto fact = results.fact(name);
  if (!fact) return fact.error();
  if (const auto* text = std::get_if<std::string>(&*fact)) return *text;
  const Number& number = std::get<Number>(*fact);
  const auto format = parse_format(parts, number);
  if (!format) return Error{"in_braces", {{"braces", inside}, {"what", format.error().notice}}};
  return format->si ? write(number, *format) : with_comma(write(number, *format), results.language());
}

}  // namespace

Result<std::string> fill(std::string_view text, const Results& results, std::string_view scope) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    // x_{0} and x^{2} are markup, not names.
    const bool markup = at > 0 && (text[at - 1] == '_' || text[at - 1] == '^');
    if (text[at] != '{' || markup) {
      out += text[at++];
      continue;
    }
    if (text.substr(at, 2) == "{{") {
      out += '{';
      at += 2;
      continue;
    }
    const auto end = text.find('}', at);
    if (end == std::string_view::npos) return Error{"brace_not_closed", {{"text", text.substr(at, 30)}}};
    const auto value = look_up(text.substr(at + 1, end - at - 1), results, scope);
    if (!value) return value.error();
    out += *value;
    at = end + 1;
  }
  return out;
}

}  // namespace cromer::core
