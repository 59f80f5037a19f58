#include "cromer/report/html_text.h"

#include "cromer/base/utf8.h"
#include "cromer/report/markup.h"

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

std::string element(std::string_view name, const std::string& content) {
  std::string out;
  out.append("<").append(name).append(">").append(content).append("</").append(name).append(">");
  return out;
}

std::string html_of(const std::vector<Piece>& pieces);

std::string html_of(const Piece& piece) {
  using Kind = Piece::Kind;
  switch (piece.kind) {
    case Kind::code:
      return element("code", escaped(piece.text));
    case Kind::italic:
      return element("em", html_of(piece.parts));
    case Kind::bold:
      return element("strong", html_of(piece.parts));
    case Kind::above:
      return element("sup", html_of(piece.parts));
    case Kind::below:
      return element("sub", html_of(piece.parts));
    case Kind::both:
      return "<span class=\"both\">" + html_of(piece.parts) + "</span>";
    case Kind::words:
      break;
  }
  return escaped(piece.text);
}

std::string html_of(const std::vector<Piece>& pieces) {
  std::string out;
  for (const Piece& piece : pieces) out += html_of(piece);
  return out;
}

}  // namespace

std::string inline_html(std::string_view text) { return html_of(pieces_of(text)); }

std::string paragraphs_html(std::string_view text) {
  std::string out;
  for (const std::string& paragraph : paragraphs_of(text)) out += element("p", inline_html(paragraph)) + '\n';
  return out;
}

std::string plain_words(std::string_view text) { return escaped(words_of(pieces_of(text))); }

}  // namespace cromer::core
