#include "cromer/study/network_tasks.h"

#include <optional>

#include "cromer/read/in_file.h"
#include "cromer/study/collect.h"
#include "cromer/tasks/modes_of_file.h"
#include "cromer/tasks/network/network_file.h"
#include "cromer/tasks/network_fit/network_fit.h"
#include "cromer/tasks/network_run/network_run.h"

namespace cromer::core {

Result<TaskReport> simulate_network_task(const Work& work) {
  constexpr double memory_for_states = 1e9;  // [bytes]
  SimulateOptions options;
  options.memory = memory_for_states;
  std::string file;
  std::vector<Option> table;
  for (const Option& option : options_of(options))
    if (is_option_of_networks(option.name)) table.push_back(option);
  table.push_back(own_option("network", &file));
  if (const auto done = work.assign_settings(table); !done) return done.error();
  const auto network = open_network(work.path_of(file));
  if (!network) return work.error(network.error());
  const auto runs = run_network_by_each(*network, file, options, work.watch);
  if (!runs) return work.error(runs.error());
  TaskReport report;
  for (const NetworkRun& run : *runs) {
    report.notices.insert(report.notices.end(), run.notices.begin(), run.notices.end());
    if (!run.ok())
      return TaskReport{report.notices,
                        Notice{"run_ended_early", {{"run", run.method}, {"what", run.message}}}};
  }
  if (work.watch.interrupted()) return report;
  collect(work.task.id, *runs, work.results);
  return report;
}

Result<TaskReport> fit_network_task(const Work& work) {
  FitOptions options;
  std::string file, network_file;
  std::vector<Option> table;
  for (const Option& option : options_of(options))
    if (is_fit_option_of_networks(option.name)) table.push_back(option);
  table.push_back(own_option("network", &network_file));
  table.push_back(own_option("file", &file));
  if (const auto done = work.assign_settings(table); !done) return done.error();
  const auto recording = work.recording(file, options.read);
  if (!recording) return recording.error();
  const auto network = open_network_file(work.path_of(network_file));
  if (!network) return work.error(network.error());
  const auto fitted = fit_network(*recording, *network, network_file, options, work.watch);
  if (!fitted) return work.error(fitted.error());
  if (!fitted->succeeded() && !work.task.may_fail)
    return TaskReport{fitted->notices, in_file(file, fitted->message)};
  collect(work.task.id, *fitted, work.results);
  return TaskReport{fitted->notices, {}};
}

Result<TaskReport> modes_task(const Work& work) {
  ModesOptions options;
  std::string file, network_file;
  auto table = options_of(options);
  table.push_back(own_option("file", &file));
  table.push_back(own_option("network", &network_file));
  if (const auto done = work.assign_settings(table); !done) return done.error();
  if (file.empty()) return work.task.place.error(Notice{"task_needs_file", {{"command", work.task.command}}});
  if (!network_file.empty()) {
    auto network = open_network(work.path_of(network_file));
    if (!network) return work.error(network.error());
    options.network = *std::move(network);
  }
  const auto found = modes_of_file(work.path_of(file), options);
  if (!found) return work.error(found.error());
  if (!found->ok()) return TaskReport{found->notices, found->message};
  collect(work.task.id, *found, work.results);
  return TaskReport{found->notices, {}};
}

}  // namespace cromer::core
