#include "cromer/study/write_report.h"

#include "cromer/documents/json/json.h"
#include "cromer/documents/words/words.h"

namespace cromer::core {

std::string to_json(const Results& results) {
  Json document = Json::object();
  for (const auto& [name, fact] : results.facts()) {
    if (const auto* text = std::get_if<std::string>(&fact)) {
      document[name] = *text;
      continue;
    }
    const Number& number = std::get<Number>(fact);
    Json& entry = document[name];
    entry["value"] = number.quantity.value;
    if (number.quantity.uncertainty > 0) entry["standard_error"] = number.quantity.uncertainty;
    entry["unit"] = number.unit;
  }
  return to_text(document);
}

std::string to_json(const WrittenReport& report) {
  Json document = {{"index", report.index.empty() ? Json(nullptr) : Json(report.index)},
                   {"figures", report.figures}};
  add_notices(document, report.notices, {});
  document["shown"] = in_words(report.shown);
  if (!report.failure.empty()) document["message"] = in_words(report.failure);
  return to_text(document);
}

}  // namespace cromer::core
