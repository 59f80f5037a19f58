// Replaces the library fmt: the part of it that the core uses.
#pragma once

#include <algorithm>

#include "../formatted.h"

namespace fmt {

template <class... Values>
std::string format(std::string_view text, const Values&... values) {
  return cromer::core::page::formatted(text, {cromer::core::page::Argument(values)...});
}

template <class... Values>
char* format_to(char* to, std::string_view text, const Values&... values) {
  const std::string result = format(text, values...);
  return std::copy(result.begin(), result.end(), to);
}

template <class List>
std::string join(const List& list, std::string_view between) {
  std::string result;
  for (const auto& each : list) {
    if (!result.empty()) result += between;
    result += each;
  }
  return result;
}

}  // namespace fmt
