#include "cromer/study/work.h"

#include <algorithm>
#include <filesystem>

#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"
#include "cromer/tasks/open_recording.h"
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

Result<Recording> Work::recording(const std::string& file, const ReadOptions& options) const {
  if (file.empty()) return task.place.error(Notice{"task_needs_file", {{"command", task.command}}});
  auto recording = open_recording(path_of(file), options, file);
  if (!recording) return error(recording.error());
  return recording;
}

std::string Work::path_of(const std::string& file) const {
  return (std::filesystem::path(study.folder) / file).string();
}

bool Work::has_setting(std::string_view option) const {
  return std::any_of(task.settings.begin(), task.settings.end(),
                     [&](const Setting& setting) { return setting.option == option; });
}

Result<void> Work::assign_settings(const std::vector<Option>& options) const {
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

Option own_option(std::string_view name, Option::Target target, std::string_view unit, Range range) {
  return {.name = name,
          .target = target,
          .unit = unit,
          .range = range,
          .help = "",
          .default_text = "",
          .group = ""};
}

}  // namespace cromer::core
