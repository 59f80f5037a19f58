#include "cromer/tasks/option/option.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cromer/base/ascii.h"
#include "cromer/base/concat.h"
#include "cromer/base/nearest.h"

namespace cromer::core {
namespace {

Error wrong_option(const Option& option, const Notice& what) {
  return Error{"option_is_wrong", {{"option", option.name}, {"what", what}}};
}

bool in_range(Range range, double value) {
  if (!std::isfinite(value)) return false;
  switch (range) {
    case Range::any:
      return true;
    case Range::positive:
      return value > 0;
    case Range::not_negative:
      return value >= 0;
    case Range::at_least_one:
      return value >= 1;
    case Range::fraction:
      return value >= 0 && value <= 1;
    case Range::tolerance:
      return value >= 1e-15 && value <= 1e-2;
    case Range::accuracy:
      return value >= 1e-9 && value <= 0.5;
    case Range::air_temperature:
      return value >= 100 && value <= 1900;
    case Range::sampling_rate:
      return value >= 1e-6 && value <= 1e12;
    case Range::trials:
      return value >= 1000 && value <= 1e7;
  }
  return false;
}

Result<void> check_value(const Option& option, double value) {
  if (in_range(option.range, value)) return {};
  const bool any = option.range == Range::any;
  return wrong_option(option, Notice{"must_keep_to",
                                     {{"rule", any ? Notice{"be_finite"} : constraint(option.range)},
                                      {"value", value},
                                      {"unit", option.unit == "1" ? std::string_view{} : option.unit}}});
}

Result<Quantity> parse_value(const Option& option, std::string_view text) {
  if (trimmed(text).empty()) return wrong_option(option, Notice{"value_is_empty"});
  auto quantity = parse_quantity(text, option.unit);
  if (!quantity) return wrong_option(option, quantity.error().notice);
  return quantity;
}

Result<Quantity> parse_in_range(const Option& option, std::string_view text) {
  auto quantity = parse_value(option, text);
  if (!quantity) return quantity;
  if (auto good = check_value(option, quantity->value); !good) return good.error();
  return quantity;
}

/// Whether commas of a text are decimal ones: those of one number and its uncertainty, "217,6 g", "217,6 ± 0,3 g",
/// or of a list with blanks behind its other commas, "0,2 kg, 0,3 kg".
bool has_decimal_comma(std::string_view text) {
  const auto digit = [&](std::size_t at) { return at < text.size() && is_digit(text[at]); };
  const auto decimal = [&](std::size_t comma) { return digit(comma - 1) && digit(comma + 1); };
  if (text.find_first_of(".;") != text.npos) return false;
  const std::size_t first = text.find(','), last = text.rfind(',');
  if (first == text.npos) return false;
  if (text.find(", ") != text.npos) {
    for (std::size_t comma = first; comma != text.npos; comma = text.find(',', comma + 1))
      if (decimal(comma)) return true;
    return false;
  }
  if (!decimal(first) || !decimal(last)) return false;
  const std::string_view between = text.substr(first + 1, last - first);
  return first == last || (between.find(',') == between.size() - 1 &&
                           (between.find("±") != between.npos || between.find("+") != between.npos));
}

/// What follows the last digit or bracket: "g" of "48.4(2) g".
std::string_view unit_in(std::string_view part) {
  const auto last = part.find_last_of("0123456789)");
  return last == std::string_view::npos ? std::string_view{} : trimmed(part.substr(last + 1));
}

/// Quantities between commas or semicolons. A unit that only the last has is that of all; on some of them it
/// could mean anything.
Result<std::vector<Quantity>> parse_list(const Option& option, std::string_view text) {
  const char between = text.find(';') == text.npos ? ',' : ';';
  const std::vector<std::string_view> given =
      has_decimal_comma(text) ? std::vector{text} : split(text, between);
  const auto with_unit =
      std::count_if(given.begin(), given.end(), [](std::string_view part) { return !unit_in(part).empty(); });
  std::vector<Quantity> all;
  for (const std::string_view part : given) {
    if (given.size() > 1 && part.empty()) return wrong_option(option, Notice{"value_missing_in_list"});
    const bool of_last = with_unit == 1 && unit_in(part).empty();
    if ((of_last && unit_in(given.back()).empty()) || (with_unit > 1 && unit_in(part).empty()))
      return wrong_option(option, Notice{"unit_missing_in_list", {{"value", part}}});
    auto quantity =
        parse_in_range(option, of_last ? concat({part, " ", unit_in(given.back())}) : std::string(part));
    if (!quantity) return quantity.error();
    all.push_back(*quantity);
  }
  return all;
}

/// A quantity whose uncertainty the task does not use: one that is given is an error, not silently dropped.
Result<double> parse_certain(const Option& option, std::string_view text) {
  auto quantity = parse_in_range(option, text);
  if (!quantity) return quantity.error();
  if (quantity->uncertainty != 0)
    return wrong_option(option, Notice{"uncertainty_not_used", {{"text", text}}});
  return quantity->value;
}

template <class Integer>
Result<Integer> parse_whole(const Option& option, std::string_view text) {
  const std::string_view digits = trimmed(text);
  Integer number = 0;
  const auto [rest, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (status != std::errc{} || rest != digits.data() + digits.size())
    return wrong_option(option, Notice{status == std::errc::result_out_of_range ? "whole_number_too_large"
                                                                                : "not_whole_number",
                                       {{"text", text}}});
  if (auto good = check_value(option, static_cast<double>(number)); !good) return good.error();
  return number;
}

/// Stores a parsed value, or passes the Error on.
template <class T, class Store>
Result<void> keep(Result<T> parsed, Store store) {
  if (!parsed) return parsed.error();
  store(*std::move(parsed));
  return {};
}

struct Assigner {
  const Option& option;
  std::string_view text;

  Result<void> operator()(double* to) const {
    return keep(parse_certain(option, text), [&](double value) { *to = value; });
  }
  Result<void> operator()(std::optional<double>* to) const {
    return keep(parse_certain(option, text), [&](double value) { *to = value; });
  }
  Result<void> operator()(std::vector<double>* to) const {
    return keep(parse_certain(option, text), [&](double value) { to->push_back(value); });
  }
  Result<void> operator()(std::optional<Quantity>* to) const {
    return keep(parse_in_range(option, text), [&](Quantity value) { *to = value; });
  }
  Result<void> operator()(std::vector<Quantity>* to) const {
    return keep(parse_list(option, text),
                [&](const std::vector<Quantity>& more) { to->insert(to->end(), more.begin(), more.end()); });
  }
  Result<void> operator()(std::optional<int>* to) const {
    return keep(parse_whole<int>(option, text), [&](int value) { *to = value; });
  }
  Result<void> operator()(long long* to) const {
    return keep(parse_whole<long long>(option, text), [&](long long value) { *to = value; });
  }
  Result<void> operator()(unsigned long long* to) const {
    return keep(parse_whole<unsigned long long>(option, text),
                [&](unsigned long long value) { *to = value; });
  }
  Result<void> operator()(bool* to) const {
    if (text != "true" && text != "false")
      return wrong_option(option, Notice{"neither_true_nor_false", {{"text", text}}});
    *to = text == "true";
    return {};
  }
  Result<void> operator()(std::string* to) const {
    if (text.empty()) return wrong_option(option, Notice{"value_is_empty"});
    *to = text;
    return {};
  }
  Result<void> operator()(std::vector<std::string>* to) const {
    if (text.empty()) return wrong_option(option, Notice{"value_is_empty"});
    to->emplace_back(text);
    return {};
  }
};

struct Checker {
  const Option& option;

  Result<void> operator()(const double* value) const {
    if (option.unit == "Hz" && *value == 0) return {};  // a rate of 0 says that none was given
    return check_value(option, *value);
  }
  Result<void> operator()(const std::optional<double>* value) const {
    return *value ? check_value(option, **value) : Result<void>{};
  }
  Result<void> operator()(const std::vector<double>* values) const {
    for (const double value : *values)
      if (auto good = check_value(option, value); !good) return good;
    return {};
  }
  Result<void> operator()(const std::optional<Quantity>* value) const {
    return *value ? check_quantity(**value) : Result<void>{};
  }
  Result<void> operator()(const std::vector<Quantity>* values) const {
    for (const Quantity& value : *values)
      if (auto good = check_quantity(value); !good) return good;
    return {};
  }
  Result<void> operator()(const std::optional<int>* value) const {
    return *value ? check_value(option, **value) : Result<void>{};
  }
  Result<void> operator()(const long long* value) const {
    return check_value(option, static_cast<double>(*value));
  }
  Result<void> operator()(const unsigned long long*) const { return {}; }
  Result<void> operator()(const bool*) const { return {}; }
  Result<void> operator()(const std::string*) const { return {}; }
  Result<void> operator()(const std::vector<std::string>*) const { return {}; }

  Result<void> check_quantity(const Quantity& value) const {
    if (!(value.uncertainty >= 0) || !std::isfinite(value.uncertainty))
      return wrong_option(option, Notice{"uncertainty_is_wrong", {{"uncertainty", value.uncertainty}}});
    return check_value(option, value.value);
  }
};

Error unknown_option(std::string_view name, const std::vector<Option>& options, std::string_view task) {
  std::vector<std::string_view> names;
  for (const Option& option : options) names.push_back(option.name);
  const std::string near = nearest(name, names);
  if (near.empty()) return Error{"no_option", {{"option", name}, {"task", task}}};
  return Error{"no_option_but", {{"option", name}, {"task", task}, {"near", near}}};
}

}  // namespace

Notice constraint(Range range) {
  switch (range) {
    case Range::any:
      return {};
    case Range::positive:
      return Notice{"be_positive"};
    case Range::not_negative:
      return Notice{"not_be_negative"};
    case Range::at_least_one:
      return Notice{"be_at_least_one"};
    case Range::fraction:
      return Notice{"be_a_fraction"};
    case Range::tolerance:
      return Notice{"be_a_tolerance"};
    case Range::accuracy:
      return Notice{"be_an_accuracy"};
    case Range::air_temperature:
      return Notice{"be_an_air_temperature"};
    case Range::sampling_rate:
      return Notice{"be_a_sampling_rate"};
    case Range::trials:
      return Notice{"be_a_number_of_trials"};
  }
  return {};
}

Result<void> assign(const Option& option, std::string_view text) {
  auto good = std::visit(Assigner{option, text}, option.target);
  if (good && option.asked) *option.asked = true;
  return good;
}

Result<void> assign(const std::vector<TypedOption>& settings, const std::vector<Option>& options,
                    std::string_view task) {
  for (const TypedOption& setting : settings) {
    const auto option = std::find_if(options.begin(), options.end(),
                                     [&](const Option& each) { return each.name == setting.first; });
    if (option == options.end()) return unknown_option(setting.first, options, task);
    if (auto good = assign(*option, setting.second); !good) return good;
    if (auto good = check(*option); !good) return good;
  }
  return {};
}

Result<void> check(const Option& option) { return std::visit(Checker{option}, option.target); }

}  // namespace cromer::core
