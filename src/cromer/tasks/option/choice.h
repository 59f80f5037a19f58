// Options that take one of a few words.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/nearest.h"
#include "cromer/result.h"

namespace cromer::core {

/// The place of the word typed; the first one where nothing is. An Error names the words and suggests the
/// nearest one.
template <std::size_t n>
Result<std::size_t> choice(std::string_view option, const std::string& typed,
                           const std::array<std::string_view, n>& words) {
  if (typed.empty()) return std::size_t{0};
  const auto found = std::find(words.begin(), words.end(), typed);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  const std::string near = nearest(typed, {words.begin(), words.end()});
  return Error{"unknown_choice",
               {{"option", option},
                {"typed", typed},
                {"words", std::vector<std::string>(words.begin(), words.end())},
                {"near", near.empty() ? Notice{} : Notice{"perhaps_choice", {{"near", near}}}}}};
}

}  // namespace cromer::core
