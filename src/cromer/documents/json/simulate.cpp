#include "cromer/documents/described/simulate.h"
#include "cromer/documents/json/described.h"
#include "cromer/documents/json/documents.h"

namespace cromer::core {

std::string to_json(const SimulateResult& result, bool with_states, const Voice& voice) {
  Json document;
  Json& runs = document["runs"] = Json::array();
  std::string message;
  for (const auto& run : result.runs) {
    runs.push_back(json_of(DescribedRun{run, result.options, with_states}, voice));
    if (!run.message.empty())
      message += (message.empty() ? "" : "; ") + run.label + ": " + in_words(run.message, voice);
  }
  add_notices(document, result.notices, voice);
  if (!message.empty()) document["message"] = message;
  return to_text(document, with_states);
}

}  // namespace cromer::core
