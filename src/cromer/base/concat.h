// Text from pieces, for the folders that do without a formatting library.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace cromer::core {

inline std::string concat(std::initializer_list<std::string_view> pieces) {
  std::string text;
  for (const std::string_view piece : pieces) text.append(piece);
  return text;
}

}  // namespace cromer::core
