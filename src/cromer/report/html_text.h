// Text made safe for HTML and SVG, and the small markup of a report's texts as HTML.
#pragma once

#include <string>
#include <string_view>

namespace cromer::core {

/// & < > " ' as character references.
std::string escaped(std::string_view text);

/// A whole document as XML can read it: UTF-8, with control characters and marks that change the direction of
/// writing spelled out, as on a terminal.
std::string well_formed(std::string document);

/// One paragraph as HTML; its markup is told in markup.h, and the rest is escaped.
std::string inline_html(std::string_view text);

/// Paragraphs, separated by blank lines, each in <p>.
std::string paragraphs_html(std::string_view text);

/// The words without markup, escaped, for titles.
std::string plain_words(std::string_view text);

}  // namespace cromer::core
