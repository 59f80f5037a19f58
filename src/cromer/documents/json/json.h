// The JSON type that all documents are built from, how it is written, and notices in it. For .cpp files only.
#pragma once

#include <span>
#include <string>
#include <string_view>

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

/// The document as text, indented by two or on one line, with a newline at the end. NaN and infinity are
/// null; bytes that are not UTF-8 become U+FFFD. The page's is always on one line, without the newline.
inline std::string to_text(const Json& document, [[maybe_unused]] bool on_one_line = false) {
#ifdef CROMER_PAGE
  return document.text();
#else
  return printable_json(document.dump(on_one_line ? -1 : 2, ' ', false, Json::error_handler_t::replace)) +
         "\n";
#endif
}

/// The sentence of a notice. For the page {"en", "de"}: its user may change the language.
Json said(const Notice& notice, const Voice& voice);

/// {"code", "severity", "text", "values": {name: number, text, list or another notice's code and values}}. Of
/// a notice about a run its own code, and "run" (or "runs") among its values.
Json notice_object(const Notice& notice, const Voice& voice);

/// {"message", "argument", "code", "values"} of input that was not taken; "argument" is null where none is at
/// fault.
Json refusal_object(const Notice& why, std::string_view argument, const Voice& voice);

/// Adds "warnings", the sentences, and "notices", the same as objects.
void add_notices(Json& object, std::span<const Notice> notices, const Voice& voice);

}  // namespace cromer::core
