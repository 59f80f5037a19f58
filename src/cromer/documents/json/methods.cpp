#include "cromer/documents/described/methods.h"
#include "cromer/documents/json/described.h"
#include "cromer/documents/json/documents.h"

namespace cromer::core {

std::string to_json(std::span<const MethodRow> methods, const Voice& voice) {
  Json document;
  Json& rows = document["methods"] = Json::array();
  for (const auto& method : methods) rows.push_back(json_of(method, voice));
  return to_text(document);
}

}  // namespace cromer::core
