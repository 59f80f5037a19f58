// Stage 1: bytes to UTF-8.
#pragma once

#include <string>
#include <string_view>

#include "cromer/result.h"

namespace cromer::core::dialects {

/// A file's text as UTF-8. UTF-8 is not copied: `text` then points into the bytes given.
struct Decoded {
  std::string converted;  ///< empty unless the bytes had to be converted
  std::string_view original;
  std::string encoding;  ///< "UTF-8", "UTF-8 with BOM", "UTF-16 LE", "cp1252"

  std::string_view text() const { return converted.empty() ? original : std::string_view(converted); }
};

/// An empty file, damaged UTF-16, archives and other binary files are errors (without the file's name).
Result<Decoded> decode(std::string_view bytes);

}  // namespace cromer::core::dialects
