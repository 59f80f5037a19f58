// Sweeps for tests, from options as they are typed.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cromer/documents/words/words.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {

using Values = std::map<std::string_view, std::string>;

inline SweepOptions options_with(Values values, std::string method = "") {
  SweepOptions options;
  options.values = std::move(values);
  if (!method.empty()) options.simulate.method = {std::move(method)};
  return options;
}

inline SweepResult swept(const SweepOptions& options) {
  auto result = sweep(options);
  if (!result) throw std::runtime_error(in_words(result.error()));
  return *std::move(result);
}

inline std::string refusal(const SweepOptions& options) {
  const auto result = sweep(options);
  return result ? "not refused" : in_words(result.error());
}

inline std::size_t width(const SweepResult& result) { return result.plan.rows.columns.size() - 1; }

inline const Values driven{{"damping", "0.1"}, {"drive-amplitude", "0.5"}, {"drive-frequency", "0.2:3:57"}};

inline Values with(Values values, const Values& more) {
  for (const auto& [name, value] : more) values[name] = value;
  return values;
}

}  // namespace cromer::core
