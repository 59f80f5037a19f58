#include "cromer/documents/described/compare.h"
#include "cromer/documents/json/described.h"
#include "cromer/documents/json/documents.h"
#include "cromer/documents/json/fit.h"

namespace cromer::core {

std::string to_json(std::span<const CompareResult> comparisons, const Voice& voice) {
  if (comparisons.size() == 1) return to_text(json_of(comparisons.front(), voice));
  Json all;
  Json& list = all["comparisons"] = Json::array();
  std::size_t failed = 0;
  for (const auto& comparison : comparisons) {
    list.push_back(json_of(comparison, voice));
    failed += comparison.recording.fit.status != FitStatus::converged;
  }
  add_failures(all, failed, comparisons.size(), voice);
  return to_text(all);
}

}  // namespace cromer::core
