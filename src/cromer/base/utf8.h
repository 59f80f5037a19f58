// UTF-8, the encoding of all text after the first stage of reading; and text made fit to be shown.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cromer::core {

/// Whether all bytes are UTF-8: no overlong forms, no surrogates, nothing beyond U+10FFFF.
bool is_utf8(std::string_view s);

/// The text with every byte that is not UTF-8 replaced by U+FFFD.
std::string as_utf8(std::string_view text);

/// Text fit for a terminal, in UTF-8. Spelled out, as \x1b or \u202e, are bytes that are not UTF-8, control
/// characters other than line end and tab, and marks that change the direction of writing.
std::string printable(std::string_view text);
/// The same for a JSON document, spelled as in its strings.
std::string printable_json(std::string_view document);

/// Appends a code point up to U+10FFFF.
void append_utf8(std::string& text, std::uint32_t code);

}  // namespace cromer::core
