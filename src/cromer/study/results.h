// The results of a study's tasks by name: numbers for its texts and tables, columns for its figures; and the
// texts with results in them: "k = {two.stiffness}".
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cromer/base/quantity.h"
#include "cromer/result.h"

namespace cromer::core {

/// A number with its SI unit ("" for a plain one).
struct Number {
  Quantity quantity;
  std::string unit;
};

/// A column of numbers, all in one SI unit.
struct ResultColumn {
  std::vector<double> values;
  std::string unit;
  std::string name;  ///< for an axis: "position {/:Italic x}"
};

/// Names are paths: "two.stiffness", "damped.3.steady.amplitude". Asking for a missing name is an Error that
/// suggests the nearest one.
class Results {
 public:
  Results() = default;
  explicit Results(Language language) : language_(language) {}

  /// Of numbers in texts, and of sentences among the results.
  Language language() const { return language_; }
  void set(const std::string& name, Quantity quantity, std::string_view unit) {
    facts_[name] = Number{quantity, std::string(unit)};
  }
  void set(const std::string& name, double value, std::string_view unit = "") {
    set(name, Quantity{value, 0}, unit);
  }
  void set(const std::string& name, std::string text) { facts_[name] = std::move(text); }
  void set_column(const std::string& name, std::vector<double> values, std::string_view unit,
                  std::string_view axis) {
    columns_[name] = ResultColumn{std::move(values), std::string(unit), std::string(axis)};
  }

  using Fact = std::variant<Number, std::string>;
  Result<Fact> fact(std::string_view name) const;
  Result<const ResultColumn*> column(std::string_view name) const;
  const std::map<std::string, Fact, std::less<>>& facts() const { return facts_; }
  const std::map<std::string, ResultColumn, std::less<>>& columns() const { return columns_; }

 private:
  Language language_ = Language::english;
  std::map<std::string, Fact, std::less<>> facts_;
  std::map<std::string, ResultColumn, std::less<>> columns_;
};

/// {"two.stiffness": {"value", "standard_error", "unit"}, "two.law": "text", ...}: all numbers, in SI units,
/// and all texts.
std::string to_json(const Results& results);

/// Replaces each {name, modifier, ...} by its result. Modifiers: a whole number (of significant digits), a
/// unit to convert to ("cm", "%", "mJ"), "bare" (without the unit), "no ±" (without the uncertainty),
/// "concise" (the uncertainty in brackets behind the last digit), "signed" (a leading + or minus), "abs" (the
/// magnitude), "si" (the value alone, exact, for options). A name that begins with a point is relative to
/// `scope`: {.label}. A brace is written {{; one behind _ or ^ is markup and stays. An unknown name or
/// modifier is an Error.
Result<std::string> fill(std::string_view text, const Results& results, std::string_view scope = "");

}  // namespace cromer::core
