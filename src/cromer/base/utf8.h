// UTF-8, the text that everything works on but the first stage of reading; and what of it may be shown.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cromer::core {

/// Whether all bytes are UTF-8: no overlong forms, no surrogates, nothing beyond U+10FFFF.
bool is_utf8(std::string_view s);

/// The same text; each byte that is none as U+FFFD.
std::string as_utf8(std::string_view text);

/// Text fit for a terminal, and UTF-8: bytes that are none, control characters but the line's end and the
/// tab, and marks that change the direction of writing are spelled out, as \x1b and \u202e.
std::string printable(std::string_view text);
/// The same of a JSON document, spelled as its strings do.
std::string printable_json(std::string_view document);

/// Appends a code point up to U+10FFFF.
void append_utf8(std::string& text, std::uint32_t code);

}  // namespace cromer::core
