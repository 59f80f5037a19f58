#include "cromer/documents/text/words.h"

#include <algorithm>

#include "cromer/base/quantity.h"

namespace cromer::core {

std::string readable_name(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string in_words(const Estimate& estimate, std::string_view unit) {
  return format_quantity({estimate.value, estimate.standard_error}, unit == "1" ? "" : unit);
}

std::string fitted_unit(const FittedRecording& fitted) {
  for (const auto& parameter : fitted.parameters)
    if (parameter.name == "equilibrium") return parameter.unit;
  return "";
}

}  // namespace cromer::core
