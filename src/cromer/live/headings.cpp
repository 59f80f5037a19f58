#include "cromer/live/headings.h"

#include "cromer/base/ascii.h"

namespace cromer::core {

std::string plain_heading(std::string text) {
  for (char& c : text)
    if (c == ',' || c == '"' || (c >= 0 && c < ' ')) c = ' ';
  return std::string(trimmed(text));
}

bool is_named(std::string_view heading, std::string_view name) {
  return heading == name || heading.substr(0, heading.find(" (")) == name;
}

}  // namespace cromer::core
