#include "cromer/documents/described/spring.h"
#include "cromer/documents/json/described.h"
#include "cromer/documents/json/documents.h"

namespace cromer::core {

std::string to_json(const StaticStiffness& found) { return to_text(json_of(found, {})); }

std::string to_json(std::span<const FittedRecording> fits, const MassLine& line) {
  Json all = Json::parse(to_json(fits, true));
  all["mass_line"] = json_of(line, {});
  return to_text(all);
}

}  // namespace cromer::core
