#include <algorithm>
#include <filesystem>

#include "cromer/report/file.h"
#include "cromer/study/collect.h"
#include "cromer/study/run_study.h"
#include "cromer/study/task_settings.h"
#include "cromer/tasks/simulate/load_drive.h"

namespace cromer::core {
namespace {

/// A task at work: what it was asked, in which study, and where its results go.
struct Work {
  const TaskSpec& task;
  const Study& study;
  Results& results;
  const Watch& watch;

  /// The bytes of the task's recording, its path relative to the study file.
  Result<std::string> recording(const std::string& file) const {
    if (file.empty()) return task.place.error(Notice{"task_needs_file", {{"command", task.command}}});
    auto bytes = read_file((std::filesystem::path(study.folder) / file).string());
    if (!bytes) return task.place.error(bytes.error().notice);
    return bytes;
  }

  Error error(const Error& inner) const { return task.place.error(inner.notice); }
};

Option text_option(std::string_view name, std::string& target) {
  return {.name = name, .target = &target, .unit = "", .help = "", .default_text = "", .group = ""};
}

Result<TaskReport> run_simulate(const Work& work) {
  SimulateOptions options;
  if (const auto done = assign_settings(work.task, options_of(options), work.results); !done)
    return done.error();
  if (const auto done = load_drive(options, work.study.folder); !done) return work.error(done.error());
  const auto result = simulate(options, work.watch);
  if (!result) return work.error(result.error());
  for (const SimulatedRun& run : result->runs)
    if (!run.done())
      return TaskReport{result->notices,
                        Notice{"run_ended_early", {{"run", run.label}, {"what", run.message}}}};
  collect(work.task.id, *result, work.results);
  return TaskReport{result->notices, {}};
}

const LawFit& fit_of(const FittedRecording& fitted) { return fitted.fit; }
const LawFit& fit_of(const CompareResult& compared) { return compared.recording.fit; }

/// fit and compare: a recording's file in, one result for each of its runs out.
template <class Options, class Task>
Result<TaskReport> run_on_recording(const Work& work, const Task& task) {
  Options options;
  std::string file;
  auto table = options_of(options);
  table.push_back(text_option("file", file));
  if (const auto done = assign_settings(work.task, table, work.results); !done) return done.error();
  const auto bytes = work.recording(file);
  if (!bytes) return bytes.error();
  const auto found = task(*bytes, file, options, work.watch);
  if (!found) return work.error(found.error());
  TaskReport report;
  for (std::size_t i = 0; i < found->size(); ++i) {
    const auto& each = (*found)[i];
    if (fit_of(each).status != FitStatus::converged)
      return TaskReport{each.notices, Notice{"in_file", {{"file", file}, {"what", fit_of(each).message}}}};
    collect(found->size() == 1 ? work.task.id : work.task.id + "." + std::to_string(i + 1), each,
            work.results);
    report.notices.insert(report.notices.end(), each.notices.begin(), each.notices.end());
  }
  return report;
}

Result<TaskReport> run_fit(const Work& work) { return run_on_recording<FitOptions>(work, fit); }

Result<TaskReport> run_compare(const Work& work) { return run_on_recording<CompareOptions>(work, compare); }

Option plain_option(std::string_view name, Option::Target target) {
  return {.name = name,
          .target = target,
          .unit = "",
          .range = Range::positive,
          .help = "",
          .default_text = "",
          .group = ""};
}

Result<TaskReport> run_resonance(const Work& work) {
  ResonanceOptions options;
  auto table = options_of(options.simulate);
  const std::vector<Option> own = {{.name = "frequency-from",
                                    .target = &options.frequency_from,
                                    .unit = "rad/s",
                                    .range = Range::positive,
                                    .help = "",
                                    .default_text = "",
                                    .group = ""},
                                   {.name = "frequency-to",
                                    .target = &options.frequency_to,
                                    .unit = "rad/s",
                                    .range = Range::positive,
                                    .help = "",
                                    .default_text = "",
                                    .group = ""},
                                   plain_option("points", &options.points),
                                   plain_option("damping-ratios", &options.damping_ratio)};
  table.insert(table.end(), own.begin(), own.end());
  if (const auto done = assign_settings(work.task, table, work.results); !done) return done.error();
  const auto result = resonance(options, work.watch);
  if (!result) return work.error(result.error());
  collect(work.task.id, *result, work.results);
  return TaskReport{result->notices, {}};
}

Result<TaskReport> run_local_error(const Work& work) {
  LocalErrorOptions options;
  if (const auto done = assign_settings(work.task, options_of(options.simulate), work.results); !done)
    return done.error();
  const auto result = local_errors(options);
  if (!result) return work.error(result.error());
  collect(work.task.id, *result, work.results);
  return TaskReport{};
}

Result<TaskReport> run_method_map(const Work& work) {
  MethodMapOptions options;
  auto table = options_of(options.simulate);
  table.push_back(plain_option("from", &options.from));
  table.push_back(plain_option("to", &options.to));
  table.push_back(plain_option("points", &options.points));
  if (const auto done = assign_settings(work.task, table, work.results); !done) return done.error();
  const auto result = method_map(options);
  if (!result) return work.error(result.error());
  collect(work.task.id, *result, work.results);
  return TaskReport{};
}

Result<TaskReport> run_work_precision(const Work& work) {
  WorkPrecisionOptions options;
  auto table = options_of(options.simulate);
  table.push_back(plain_option("longest", &options.longest));
  table.push_back(plain_option("halvings", &options.halvings));
  if (const auto done = assign_settings(work.task, table, work.results); !done) return done.error();
  const auto result = work_precision(options, work.watch);
  if (!result) return work.error(result.error());
  collect(work.task.id, *result, work.results);
  return TaskReport{};
}

Result<TaskReport> run_spectrum(const Work& work) {
  SpectrumOptions options;
  std::vector<std::string> names;
  auto table = options_of(options);
  table.push_back(
      {.name = "file", .target = &names, .unit = "", .help = "", .default_text = "", .group = ""});
  if (const auto done = assign_settings(work.task, table, work.results); !done) return done.error();
  if (names.empty()) names.emplace_back();
  std::vector<SpectrumFile> files;
  for (const auto& name : names) {
    auto bytes = work.recording(name);
    if (!bytes) return bytes.error();
    files.push_back({name, *std::move(bytes)});
  }
  const auto result = response_spectrum(files, options, work.watch);
  if (!result) return work.error(result.error());
  if (result->interrupted) return TaskReport{result->notices, Notice{"task_interrupted"}};
  collect(work.task.id, *result, work.results);
  return TaskReport{result->notices, {}};
}

/// TOML lists are grids as well: [0.02, 0.05] for "0.02,0.05".
TaskSpec with_joined_grids(TaskSpec task, const std::vector<Option>& table) {
  for (Setting& setting : task.settings) {
    const auto option =
        std::find_if(table.begin(), table.end(), [&](const Option& o) { return o.name == setting.option; });
    if (setting.values.size() < 2 || option == table.end() || option->is_list() || !option->is_text())
      continue;
    std::string joined;
    for (const std::string& value : setting.values) joined += (joined.empty() ? "" : ",") + value;
    setting.values = {std::move(joined)};
  }
  return task;
}

Result<TaskReport> run_sweep(const Work& work) {
  constexpr double memory_for_rows = 1e9;  // [bytes] a page shows curves, not archives
  SweepOptions options;
  options.memory = memory_for_rows;
  const auto table = options_of(options);
  if (const auto done = assign_settings(with_joined_grids(work.task, table), table, work.results); !done)
    return done.error();
  const auto result = sweep(options, work.watch);
  if (!result) return work.error(result.error());
  TaskReport report{result->plan.notices, {}};
  for (const Notice& each : trouble_of(*result)) report.notices.push_back(each);
  if (result->interrupted) return TaskReport{report.notices, Notice{"task_interrupted"}};
  if (result->counts.not_settled == result->plan.rows.rows)
    return TaskReport{report.notices, Notice{"no_point_settled"}};
  collect(work.task.id, *result, work.results);
  return report;
}

/// The largest distance between the positions of two results, row by row.
Result<TaskReport> run_difference(const Work& work) {
  std::string of, minus;
  if (const auto done =
          assign_settings(work.task, {text_option("of", of), text_option("minus", minus)}, work.results);
      !done)
    return done.error();
  const auto a = work.results.column(of + ".x"), b = work.results.column(minus + ".x");
  if (!a) return work.error(a.error());
  if (!b) return work.error(b.error());
  const auto& x = (*a)->values;
  const auto& y = (*b)->values;
  if (x.size() != y.size())
    return work.task.place.error(Notice{"rows_not_alike", {{"of", of}, {"minus", minus}}});
  double peak = 0;
  for (std::size_t i = 0; i < x.size(); ++i) peak = std::max(peak, std::abs(x[i] - y[i]));
  work.results.set(work.task.id + ".peak", peak, (*a)->unit);
  return TaskReport{};
}

struct Command {
  std::string_view name;
  Result<TaskReport> (*run)(const Work&);
};

constexpr Command commands[] = {{"simulate", run_simulate},       {"fit", run_fit},
                                {"compare", run_compare},         {"resonance", run_resonance},
                                {"local-error", run_local_error}, {"difference", run_difference},
                                {"method-map", run_method_map},   {"work-precision", run_work_precision},
                                {"spectrum", run_spectrum},       {"sweep", run_sweep}};

}  // namespace

Result<TaskReport> run_task(const TaskSpec& task, const Study& study, Results& results, const Watch& watch) {
  for (const Command& command : commands)
    if (command.name == task.command) return command.run(Work{task, study, results, watch});
  return task.place.error(Notice{"no_command_of_study", {{"command", task.command}}});
}

}  // namespace cromer::core
