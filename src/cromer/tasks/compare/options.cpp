#include <algorithm>
#include <array>
#include <iterator>

#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {

std::vector<Option> options_of(CompareOptions& o) {
  constexpr std::string_view integration = "Integration";
  const Option own[] = {
      {"method", &o.method, "", Range::any,
       "a name from `cromer methods`, which simulates the law; may be given several times", "euler-cromer",
       integration},
      {"step", &o.step, "s", Range::positive, "time step",
       "the sample spacing, divided to have 200 steps in a period", integration},
  };
  // A driven motion shows no decay to compare.
  constexpr std::array<std::string_view, 5> of_driven{"force-column", "between-samples", "drive-frequency",
                                                      "hold-out", "no-spring"};
  std::vector<Option> options = options_of(o.fit);
  const auto is_of_driven = [&](const Option& option) {
    return std::find(of_driven.begin(), of_driven.end(), option.name) != of_driven.end();
  };
  std::erase_if(options, is_of_driven);
  for (Option& option : options)
    if (option.name == "column") {
      option.help = "column to compare";
      option.default_text = "a position, else an angle";
    }
  options.insert(options.end(), std::begin(own), std::end(own));
  return options;
}

}  // namespace cromer::core
