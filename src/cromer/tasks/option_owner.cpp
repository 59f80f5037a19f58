#include "cromer/tasks/option_owner.h"

#include <algorithm>

#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/modes/modes.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/recognise/recognise.h"
#include "cromer/tasks/simulate/simulate.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

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
  if (has<FitOptions>(name)) return "fit";
  if (has<SimulateOptions>(name)) return "simulate";
  if (has<CompareOptions>(name)) return "compare";
  if (has<SpectrumOptions>(name)) return "spectrum";
  if (has<ModesOptions>(name)) return "modes";
  return has<RecogniseOptions>(name) ? "methods" : "";
}

}  // namespace cromer::core
