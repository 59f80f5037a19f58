#include "cromer/documents/described/inspect.h"
#include "cromer/documents/json/described.h"
#include "cromer/documents/json/documents.h"

namespace cromer::core {

std::string to_json(const Inspection& inspection, bool with_values, const Voice& voice) {
  return to_text(json_of(InspectedFile{inspection, with_values}, voice), with_values);
}

}  // namespace cromer::core
