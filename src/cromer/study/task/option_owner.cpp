#include "cromer/study/task/option_owner.h"

#include <algorithm>

#include "cromer/study/task/compare.h"
#include "cromer/study/task/fit.h"
#include "cromer/study/task/methods.h"
#include "cromer/study/task/option.h"
#include "cromer/study/task/simulate.h"

namespace cromer::core {
namespace {

template <class Options>
bool has(std::string_view name) {
  Options options;
  const std::vector<Option> table = options_of(options);
  return std::any_of(table.begin(), table.end(), [&](const Option& option) { return option.name == name; });
}

}  // namespace

std::string_view option_owner(std::string_view name) {
  if (has<SimulateOptions>(name)) return "simulate";
  if (has<FitOptions>(name)) return "fit";
  if (has<CompareOptions>(name)) return "compare";
  return has<MethodsOptions>(name) ? "methods" : "";
}

}  // namespace cromer::core
