#include "cromer/report/escape.h"

#include "cromer/base/utf8.h"

namespace cromer::core {
std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string well_formed(std::string document) {
  document = printable(as_utf8(document));
  // U+FFFE and U+FFFF, which XML does not allow.
  for (const std::string_view none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
    for (std::size_t i = 0; (i = document.find(none, i)) != std::string::npos;)
      document.replace(i, none.size(), "\uFFFD");
  return document;
}

}  // namespace cromer::core
