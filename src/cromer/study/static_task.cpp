#include "cromer/study/static_task.h"

#include "cromer/study/collect.h"
#include "cromer/tasks/fit/spring_options.h"

namespace cromer::core {

Result<TaskReport> fit_static_task(const Work& work) {
  FitOptions fit;
  SpringOptions spring;
  std::vector<std::string> files;
  auto table = options_of(fit);
  for (const Option& option : options_of(spring))
    if (option.name != "mass-line") table.push_back(option);
  table.push_back(own_option("file", &files));
  if (const auto done = work.assign_settings(table); !done) return done.error();
  if (const auto checked = check_spring_options(spring, true); !checked) return work.error(checked.error());
  if (files.empty()) files.emplace_back();
  std::vector<Recording> recordings;
  for (const std::string& file : files) {
    auto recording = work.recording(file, fit.read);
    if (!recording) return recording.error();
    recordings.push_back(*std::move(recording));
  }
  const auto found = fit_static(recordings, static_options(fit, spring));
  if (!found) return work.error(found.error());
  collect(work.task.id, *found, work.results);
  return TaskReport{found->notices, {}};
}

}  // namespace cromer::core
