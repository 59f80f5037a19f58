#include <algorithm>

#include "cromer/tasks/option/option.h"
#include "cromer/tasks/recognise/recognise.h"

namespace cromer::core {

std::vector<Option> options_of(RecogniseOptions& o) {
  constexpr std::string_view group = "Which method made a run";
  std::vector<Option> options = options_of(o.methods);
  const std::vector<Option> own{
      {"recognise", &o.recognise, "", Range::any,
       "file of any simulator with time, position and velocity: which method made it, with which step, under "
       "the law below",
       "none", group},
      {"column", &o.column, "", Range::any, "its column of the position", "found", group},
      {"velocity-column", &o.velocity_column, "", Range::any, "its column of the velocity", "found", group},
      {"run", &o.run, "", Range::positive, "which of several runs in the file", "the only one", group},
  };
  const auto after =
      std::find_if(options.begin(), options.end(), [](const Option& each) { return each.group == "Output"; });
  std::vector<Option> law = options_of(o.simulate);
  // The law alone; what the methods have an option for is theirs.
  const std::string_view heading = law.front().group;
  std::erase_if(law, [&](const Option& option) {
    return option.group != heading || std::any_of(options.begin(), options.end(), [&](const Option& each) {
             return each.name == option.name;
           });
  });
  for (Option& each : law)
    if (each.name == "stiffness") each.default_text = "fitted, with the damping, where no law is given";
  std::vector<Option> between = own;
  between.insert(between.end(), law.begin(), law.end());
  const std::vector<Option> reading = options_of(o.read);
  between.insert(between.end(), reading.begin(), reading.end());
  for (Option& each : between)
    if (each.name != "recognise") each.asked = &o.about_a_run;
  options.insert(after, between.begin(), between.end());
  return options;
}

Result<void> only_with_file(const RecogniseOptions& options) {
  if (options.about_a_run) return Error{"options_need_recognise"};
  return {};
}

}  // namespace cromer::core
