// UTF-8, the text all stages but the first work on.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cromer::dialects {

/// Whether all bytes are UTF-8: no overlong forms, no surrogates, nothing beyond U+10FFFF.
bool is_utf8(std::string_view s);

/// Appends a code point up to U+10FFFF.
void append_utf8(std::string& text, std::uint32_t code);

}  // namespace cromer::dialects
