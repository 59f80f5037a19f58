#include "cromer/study/toml_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "cromer/base/ascii.h"

namespace cromer::core {

std::string toml_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      (out += '\\') += c;
    else if (c == '\n')
      out += "\\n";
    else if (code < 0x20 || code == 0x7f)
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(code));
    else
      out += c;
  }
  return out + '"';
}

std::string verbatim(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool markup = !out.empty() && (out.back() == '_' || out.back() == '^');
    out += std::string(c == '{' && !markup ? 2 : 1, c);
  }
  return out;
}

std::string toml_settings(const std::vector<TypedOption>& options) {
  std::string lines;
  std::vector<std::string_view> written;
  for (const auto& [name, value] : options) {
    if (std::find(written.begin(), written.end(), name) != written.end()) continue;
    written.push_back(name);
    std::string values;
    int count = 0;
    for (const auto& [other, each] : options)
      if (other == name) values += (count++ ? ", " : "") + toml_text(verbatim(each));
    lines += with_underscores(name) + " = " + (count > 1 ? "[" + values + "]" : values) + '\n';
  }
  return lines;
}

}  // namespace cromer::core
