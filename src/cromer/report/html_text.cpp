#include "cromer/report/html_text.h"

#include "cromer/base/ascii.h"
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

namespace {

constexpr std::string_view no_break = "\u00A0";

bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
bool starts_with(std::string_view text, std::string_view with) { return text.substr(0, with.size()) == with; }

// The place where the run that `mark` opened before text[from] closes; npos if it does not.
std::size_t closing(std::string_view text, std::size_t from, std::string_view mark) {
  if (from >= text.size() || is_blank(text[from])) return std::string_view::npos;
  for (std::size_t i = from; i + mark.size() <= text.size(); ++i) {
    if (text[i] == '`') {  // stars in code do not count
      const std::size_t end = text.find('`', i + 1);
      if (end != std::string_view::npos) i = end;
      continue;
    }
    if (text.substr(i, mark.size()) != mark) continue;
    if (mark == "*" && i + 1 < text.size() && text[i + 1] == '*') {
      ++i;  // a bold mark inside italics
      continue;
    }
    if (i == from || is_blank(text[i - 1])) continue;
    return i;
  }
  return std::string_view::npos;
}

std::size_t closing_brace(std::string_view text, std::size_t from) {
  int depth = 1;
  for (std::size_t i = from; i < text.size(); ++i) {
    if (text[i] == '{') ++depth;
    if (text[i] == '}' && --depth == 0) return i;
  }
  return std::string_view::npos;
}

// A unit or ± after a number stays on the number's line.
bool keeps_together(std::string_view text, std::size_t blank) {
  if (blank == 0 || blank + 1 >= text.size()) return false;
  const std::string_view after = text.substr(blank + 1);
  if (starts_with(after, "±") || starts_with(after, "×") || starts_with(after, "%")) return true;
  if (starts_with(text.substr(blank >= 2 ? blank - 2 : 0), "±") ||
      starts_with(text.substr(blank >= 2 ? blank - 2 : 0), "×"))
    return true;
  if (!is_digit(text[blank - 1]) && text[blank - 1] != ')') return false;
  std::size_t end = 0;
  while (end < after.size() && !is_blank(after[end])) ++end;
  while (end > 0 && std::string_view(".,;:)").find(after[end - 1]) != std::string_view::npos) --end;
  const std::string_view word = after.substr(0, end);
  for (const std::string_view unit :
       {"m",    "cm",   "mm",   "µm",   "s",    "ms",  "µs",   "min", "kg",    "g",   "mg",  "N",
        "mN",   "N/m",  "J",    "mJ",   "µJ",   "Hz",  "kHz",  "rad", "rad/s", "1/s", "1/m", "m/s",
        "cm/s", "mm/s", "m/s²", "kg/s", "kg/m", "g/s", "N/m³", "°C",  "°",     "V",   "K"}) {
    if (word == unit) return true;
  }
  return false;
}

std::string element(std::string_view name, const std::string& content) {
  std::string out;
  out.append("<").append(name).append(">").append(content).append("</").append(name).append(">");
  return out;
}

}  // namespace

std::string inline_html(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '`') {
      const std::size_t end = text.find('`', i + 1);
      if (end != std::string_view::npos) {
        out += element("code", escaped(text.substr(i + 1, end - i - 1)));
        i = end + 1;
        continue;
      }
    }
    if (c == '*') {
      const bool bold = text.substr(i, 2) == "**";
      const std::string_view mark = bold ? "**" : "*";
      const std::size_t from = i + mark.size(), end = closing(text, from, mark);
      if (end != std::string_view::npos) {
        out += element(bold ? "strong" : "em", inline_html(text.substr(from, end - from)));
        i = end + mark.size();
        continue;
      }
    }
    if ((c == '_' || c == '^') && i + 1 < text.size() && text[i + 1] == '{') {
      const std::size_t end = closing_brace(text, i + 2);
      if (end != std::string_view::npos) {
        const std::string first =
            element(c == '_' ? "sub" : "sup", inline_html(text.substr(i + 2, end - i - 2)));
        i = end + 1;
        const char other = c == '_' ? '^' : '_';
        const std::size_t second = i + 1 < text.size() && text[i] == other && text[i + 1] == '{'
                                       ? closing_brace(text, i + 2)
                                       : std::string_view::npos;
        if (second == std::string_view::npos) {
          out += first;
        } else {
          const std::string above =
              element(c == '_' ? "sup" : "sub", inline_html(text.substr(i + 2, second - i - 2)));
          out.append("<span class=\"both\">")
              .append(c == '_' ? above : first)
              .append(c == '_' ? first : above)
              .append("</span>");
          i = second + 1;
        }
        continue;
      }
    }
    if (c == ' ' && keeps_together(text, i))
      out += no_break;
    else
      out += escaped(text.substr(i, 1));
    ++i;
  }
  return out;
}

std::string paragraphs_html(std::string_view text) {
  std::string out, paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) out.append("<p>").append(inline_html(paragraph)).append("</p>\n");
    paragraph.clear();
  };
  for (std::size_t i = 0; i <= text.size();) {
    const std::size_t end = std::min(text.find('\n', i), text.size());
    std::string_view line = text.substr(i, end - i);
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    if (line.empty())
      end_paragraph();
    else
      (paragraph += paragraph.empty() ? "" : " ") += line;
    i = end + 1;
  }
  end_paragraph();
  return out;
}

std::string plain_words(std::string_view text) {
  const std::string html = inline_html(text);
  std::string words;
  bool in_tag = false;
  for (const char c : html) {
    if (c == '<') in_tag = true;
    if (!in_tag) words += c;
    if (c == '>') in_tag = false;
  }
  return words;
}

}  // namespace cromer::core
