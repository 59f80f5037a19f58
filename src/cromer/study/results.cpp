#include "cromer/study/results.h"

#include "cromer/base/nearest.h"

namespace cromer::core {
namespace {

template <class Map>
Error missing(const Map& map, std::string_view name, const char* what) {
  std::vector<std::string_view> names;
  for (const auto& [key, value] : map) names.push_back(key);
  std::string message = "\"" + std::string(name) + "\" is no " + what + " of this study";
  const std::string near = nearest(name, names);
  if (!near.empty()) message += "; did you mean \"" + near + "\"?";
  return Error{message};
}

}  // namespace

Result<Results::Fact> Results::fact(std::string_view name) const {
  const auto found = facts_.find(name);
  if (found == facts_.end()) return missing(facts_, name, "result");
  return found->second;
}

Result<const ResultColumn*> Results::column(std::string_view name) const {
  const auto found = columns_.find(name);
  if (found == columns_.end()) return missing(columns_, name, "column");
  return &found->second;
}

}  // namespace cromer::core
