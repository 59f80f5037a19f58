// The JSON type all documents are built from, how they are written, and what there is to say in them. For
// .cpp files only.
#pragma once

#include <span>
#include <string>

#include "cromer/base/utf8.h"
#include "cromer/documents/words/words.h"

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

/// A sentence; on the page {"en", "de"}, which changes its language while it shows one.
Json said(const Notice& notice, const Voice& voice);

/// {"code", "severity", "text", "values": {name: number, text, list or what a notice holds}}
Json notice_object(const Notice& notice, const Voice& voice);

/// "warnings": the sentences, and "notices": each of them as an object.
void add_notices(Json& object, std::span<const Notice> notices, const Voice& voice);

}  // namespace cromer::core
