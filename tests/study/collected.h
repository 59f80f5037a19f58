// Named results as tests read them.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <variant>

#include "cromer/study/collect.h"

namespace cromer::core {

inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// "2 m", "2 +- 1 m", "a text", or "none".
inline std::string fact(const Results& results, const std::string& name) {
  const auto found = results.fact(name);
  if (!found) return "none";
  if (const auto* text = std::get_if<std::string>(&*found)) return *text;
  const Number& number = std::get<Number>(*found);
  std::string said = shortest(number.quantity.value);
  if (number.quantity.uncertainty != 0) said += " +- " + shortest(number.quantity.uncertainty);
  return number.unit.empty() ? said : said + " " + number.unit;
}

inline double value(const Results& results, const std::string& name) {
  const auto found = results.fact(name);
  EXPECT_TRUE(found) << name;
  return found ? std::get<Number>(*found).quantity.value : nothing;
}

inline ResultColumn column(const Results& results, const std::string& name) {
  const auto found = results.column(name);
  EXPECT_TRUE(found) << name;
  return found ? **found : ResultColumn{};
}

}  // namespace cromer::core
