// What there is to say beside the numbers, as JSON.
#pragma once

#include <span>

#include "cromer/documents/json/json.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {

/// A sentence; on the page {"en", "de"}, which changes its language while it shows one.
Json said(const Notice& notice, const Voice& voice);

/// {"code", "severity", "text", "values": {name: number, text, list or what a notice holds}}
Json notice_object(const Notice& notice, const Voice& voice);

/// "warnings": the sentences, and "notices": each of them as an object.
void add_notices(Json& object, std::span<const Notice> notices, const Voice& voice);

}  // namespace cromer::core
