#include "cromer/cluster/differences.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace cromer::core {
namespace {

using Json = nlohmann::ordered_json;

/// "/drive/frequency" as people write it: "drive.frequency".
std::string name_of(std::string pointer) {
  pointer.erase(0, 1);
  std::replace(pointer.begin(), pointer.end(), '/', '.');
  return pointer.empty() ? "the whole" : pointer;
}

std::string shortened(const Json& value) {
  std::string text = value.dump();
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

}  // namespace

std::vector<Notice> differences(const std::string& there, const std::string& here) {
  if (there == here) return {};
  const Json a = Json::parse(there, nullptr, false), b = Json::parse(here, nullptr, false);
  if (a.is_discarded() || b.is_discarded() || a == b) return {Notice{"described_otherwise"}};
  constexpr std::size_t most = 4;
  const Json changes = Json::diff(a, b);
  std::vector<Notice> said;
  for (std::size_t i = 0; i < std::min(changes.size(), most); ++i) {
    const std::string path = changes[i]["path"], kind = changes[i]["op"];
    const std::string name = name_of(path);
    if (kind == "add")
      said.push_back(Notice{"missing_there", {{"name", name}}});
    else if (kind == "remove")
      said.push_back(Notice{"missing_here", {{"name", name}}});
    else
      said.push_back(Notice{"differs",
                            {{"name", name},
                             {"there", shortened(a.at(Json::json_pointer(path)))},
                             {"here", shortened(changes[i]["value"])}}});
  }
  if (changes.size() > most) said.push_back(Notice{"and_more"});
  return said;
}

}  // namespace cromer::core
