#include "cromer/study/results.h"

#include "cromer/base/nearest.h"

namespace cromer::core {
namespace {

/// The nearest name, as a question.
template <class Map>
Notice near_in(const Map& map, std::string_view name) {
  std::vector<std::string_view> names;
  for (const auto& [key, value] : map) names.push_back(key);
  const std::string near = nearest(name, names);
  return near.empty() ? Notice{} : Notice{"perhaps_quoted", {{"near", near}}};
}

}  // namespace

Result<Results::Fact> Results::fact(std::string_view name) const {
  const auto found = facts_.find(name);
  if (found == facts_.end())
    return Error{"no_such_result", {{"name", name}, {"near", near_in(facts_, name)}}};
  return found->second;
}

Result<const ResultColumn*> Results::column(std::string_view name) const {
  const auto found = columns_.find(name);
  if (found == columns_.end())
    return Error{"no_such_result_column", {{"name", name}, {"near", near_in(columns_, name)}}};
  return &found->second;
}

}  // namespace cromer::core
