// UTF-16: what Windows programs save as "Unicode" text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cromer/result.h"

namespace cromer::core::dialects {

/// Text in units of two bytes.
struct Utf16 {
  std::string_view units;  ///< behind the byte order mark
  bool marked = false;     ///< it begins with a byte order mark
  bool big = false;        ///< the high byte of a unit stands first
};

/// By the byte order mark; without one, text of which nearly every second byte of the beginning is zero, and
/// no other.
std::optional<Utf16> find_utf16(std::string_view bytes);

/// As UTF-8. Half a surrogate pair, a zero, and half a unit at the end, are an Error that names byte and
/// line.
Result<std::string> from_utf16(const Utf16& text);

/// "UTF-16 LE", "UTF-16 BE with BOM".
std::string utf16_name(const Utf16& text);

}  // namespace cromer::core::dialects
