// The JSON type all documents are built from, and how they are written. For .cpp files only.
#pragma once

#include <string>
#include <vector>

#include "cromer/base/utf8.h"
#include "cromer/read/recording.h"

#ifdef CROMER_PAGE       // which has no JSON library
#include <json_value.h>  // apps/web/core
#else
#include <nlohmann/json.hpp>
#endif

namespace cromer::core {

/// Keeps the fields in the order they were set.
#ifdef CROMER_PAGE
using Json = JsonValue;
#else
using Json = nlohmann::ordered_json;
#endif

/// Indented by two, or on one line; NaN and infinity as null, bytes that are not UTF-8 as U+FFFD, a newline
/// at the end.
inline std::string to_text(const Json& document, [[maybe_unused]] bool on_one_line = false) {
#ifdef CROMER_PAGE
  return document.text();
#else
  return printable_json(document.dump(on_one_line ? -1 : 2, ' ', false, Json::error_handler_t::replace)) +
         "\n";
#endif
}

}  // namespace cromer::core
