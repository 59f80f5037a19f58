#include "cromer/documents/described/fit.h"
#include "cromer/documents/json/described.h"
#include "cromer/documents/json/documents.h"
#include "cromer/documents/json/fit.h"
#include "cromer/documents/json/json.h"

namespace cromer::core {

Json fit_object(const FittedRecording& fitted, const Voice& voice) {
  if (!fitted.wrong_input) return json_of(fitted, voice);
  Json object = Json::object();
  described::add_entries(object, Described<FittedRecording>::refused, fitted, voice);
  return object;
}

void add_failures(Json& document, std::size_t failed, std::size_t all, const Voice& voice) {
  if (failed > 0)
    document["message"] = said(Notice{"fits_failed", {{"failed", failed}, {"all", all}}}, voice);
}

std::string to_json(std::span<const FittedRecording> fits, bool as_list, const Voice& voice) {
  if (fits.size() == 1 && !as_list) return to_text(fit_object(fits.front(), voice));
  Json all;
  Json& list = all["fits"] = Json::array();
  std::size_t failed = 0;
  for (const auto& fitted : fits) {
    list.push_back(fit_object(fitted, voice));
    failed += !fitted.succeeded();
  }
  add_failures(all, failed, fits.size(), voice);
  return to_text(all);
}

}  // namespace cromer::core
