#include "cromer/documents/json/documents.h"
#include "cromer/documents/json/effect.h"
#include "cromer/documents/json/json.h"
#include "cromer/documents/json/notices.h"

namespace cromer::core {
namespace {

Json document(const MethodRow& row, const Voice& voice) {
  Json object{{"name", row.name},         {"order", row.order ? Json(*row.order) : Json(nullptr)},
              {"implicit", row.implicit}, {"symplectic", row.symplectic},
              {"adaptive", row.adaptive}, {"reversible", row.reversible},
              {"a_stable", row.a_stable}, {"source", row.source}};
  if (row.effect) {
    object["effective"] = to_json(row.effect->effective);
    object["stable"] = row.effect->stable;
    object["stability_limit"] = json_or_null(row.effect->stability_limit);
    object["energy_factor_per_cycle"] = json_or_null(row.effect->effective.energy_factor());
    object["in_words"] = said(row.words, voice);
  }
  return object;
}

}  // namespace

std::string to_json(std::span<const MethodRow> methods, const Voice& voice) {
  Json document_of_all;
  Json& rows = document_of_all["methods"] = Json::array();
  for (const auto& method : methods) rows.push_back(document(method, voice));
  return to_text(document_of_all);
}

}  // namespace cromer::core
