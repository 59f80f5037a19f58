#include "cromer/study/json/documents.h"
#include "cromer/study/json/json.h"

namespace cromer {

std::string to_json(std::span<const MethodRow> methods) {
  Json document;
  Json& rows = document["methods"] = Json::array();
  for (const auto& method : methods)
    rows.push_back({{"name", method.name},
                    {"order", method.order ? Json(*method.order) : Json(nullptr)},
                    {"implicit", method.implicit},
                    {"symplectic", method.symplectic},
                    {"adaptive", method.adaptive},
                    {"source", method.source}});
  return to_text(document);
}

}  // namespace cromer
