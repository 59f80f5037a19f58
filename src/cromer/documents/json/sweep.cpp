#include "cromer/documents/described/sweep.h"
#include "cromer/documents/json/described.h"
#include "cromer/documents/json/documents.h"

namespace cromer::core {

std::string to_json(const SweepResult& result, bool with_rows, const Voice& voice) {
  return to_text(json_of(SweepDocument{result, with_rows}, voice), true);
}

}  // namespace cromer::core
