#include "cromer/report/escape.h"

#include <algorithm>

#include "cromer/base/utf8.h"

namespace cromer {
namespace {

bool is_allowed(char c) {
  return static_cast<unsigned char>(c) >= ' ' || c == '\n' || c == '\r' || c == '\t';
}

}  // namespace

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
        if (is_allowed(c)) out += c;
    }
  }
  return out;
}

std::string well_formed(std::string document) {
  document.erase(std::remove_if(document.begin(), document.end(), [](char c) { return !is_allowed(c); }),
                 document.end());
  // Noncharacters, the only ones of three bytes that are not allowed.
  for (const std::string_view none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
    for (std::size_t i = 0; (i = document.find(none, i)) != std::string::npos;)
      document.replace(i, none.size(), "\uFFFD");
  return as_utf8(document);
}

}  // namespace cromer
