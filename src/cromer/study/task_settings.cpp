#include "cromer/study/task_settings.h"

#include <algorithm>

#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"
#include "cromer/study/text.h"
#include "cromer/tasks/option_owner.h"
#include "cromer/tasks/sweep/sweep.h"

namespace cromer::core {
namespace {

Error unknown(const Setting& setting, const TaskSpec& task, const std::vector<Option>& options) {
  std::vector<std::string_view> names;
  for (const Option& option : options) names.push_back(option.name);
  const std::string near = nearest(setting.option, names);
  if (task.command == "sweep")
    if (const Notice why = sweep_refusal(setting.option, ""); !why.empty()) return setting.place.error(why);
  Notice more;
  if (const std::string_view owner = option_owner(setting.option); !owner.empty())
    more = Notice{"option_of_other", {{"owner", owner}}};
  else if (!near.empty())
    more = Notice{"perhaps_quoted", {{"near", with_underscores(near)}}};
  return setting.place.error(
      Notice{"no_option_of_task",
             {{"key", with_underscores(setting.option)}, {"task", task.command}, {"more", more}}});
}

}  // namespace

Result<void> assign_settings(const TaskSpec& task, const std::vector<Option>& options,
                             const Results& results) {
  for (const Setting& setting : task.settings) {
    const auto option = std::find_if(options.begin(), options.end(),
                                     [&](const Option& each) { return each.name == setting.option; });
    if (option == options.end()) return unknown(setting, task, options);
    if (setting.values.size() != 1 && !option->is_list())
      return setting.place.error(Notice{"key_takes_one_value", {{"key", with_underscores(setting.option)}}});
    for (const std::string& value : setting.values) {
      const auto text = fill(value, results);
      if (!text) return setting.place.error(text.error().notice);
      if (const auto assigned = assign(*option, *text); !assigned)
        return setting.place.error(assigned.error().notice);
    }
  }
  return {};
}

}  // namespace cromer::core
