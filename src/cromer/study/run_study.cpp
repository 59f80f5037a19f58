#include "cromer/study/run_study.h"

#include <algorithm>
#include <span>

#include "cromer/documents/words/words.h"
#include "cromer/read/in_file.h"
#include "cromer/study/collect.h"
#include "cromer/study/network_tasks.h"
#include "cromer/study/static_task.h"
#include "cromer/study/work.h"
#include "cromer/tasks/fit/said_of_runs.h"
#include "cromer/tasks/option/option.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {
namespace {

Result<TaskReport> run_simulate(const Work& work) {
  if (work.has_setting("network")) return simulate_network_task(work);
  SimulateOptions options;
  if (const auto done = work.assign_settings(options_of(options)); !done) return done.error();
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
Notice why_not(const FittedRecording& fitted, const std::string& file) {
  const Notice& message = fitted.fit.message;
  return in_file(file, fitted.one_of_several ? in_run(fitted.series.run, message) : message);
}
const ReadOptions& read_of(const FitOptions& options) { return options.read; }
const ReadOptions& read_of(const CompareOptions& options) { return options.fit.read; }

/// fit and compare: one result for each run of a recording.
template <class Options, class Task>
Result<TaskReport> run_on_recording(const Work& work, const Task& task) {
  Options options;
  std::string file;
  auto table = options_of(options);
  table.push_back(own_option("file", &file));
  if (const auto done = work.assign_settings(table); !done) return done.error();
  const auto recording = work.recording(file, read_of(options));
  if (!recording) return recording.error();
  const auto found = task(*recording, options, work.watch);
  if (!found) return work.error(found.error());
  TaskReport report;
  for (std::size_t i = 0; i < found->size(); ++i) {
    const auto& each = (*found)[i];
    const bool failed = fit_of(each).status != FitStatus::converged;
    if (failed && !work.task.may_fail)
      return TaskReport{said_of_runs(std::span(&each, 1)), why_not(fit_of_run(each), file)};
    collect(found->size() == 1 ? work.task.id : work.task.id + "." + std::to_string(i + 1), each,
            work.results);
  }
  report.notices = said_of_runs(*found);
  return report;
}

Result<TaskReport> run_fit(const Work& work) {
  if (work.has_setting("network")) return fit_network_task(work);
  if (work.has_setting("static")) return fit_static_task(work);
  return run_on_recording<FitOptions>(work, fit);
}

Result<TaskReport> run_compare(const Work& work) { return run_on_recording<CompareOptions>(work, compare); }

/// Tasks that compute curves. Their options are those of `simulate` and some of their `own`.
template <class Options, class Task>
Result<TaskReport> run_curves(const Work& work, Options& options, const std::vector<Option>& own, Task task) {
  auto table = options_of(options.simulate);
  table.insert(table.end(), own.begin(), own.end());
  if (const auto done = work.assign_settings(table); !done) return done.error();
  const auto result = task();
  if (!result) return work.error(result.error());
  collect(work.task.id, *result, work.results);
  TaskReport report;
  if constexpr (requires { result->notices; }) report.notices = result->notices;
  return report;
}

Option positive(std::string_view name, Option::Target target, std::string_view unit = "") {
  return own_option(name, target, unit, Range::positive);
}

Result<TaskReport> run_resonance(const Work& work) {
  ResonanceOptions options;
  return run_curves(work, options,
                    {positive("frequency-from", &options.frequency_from, "rad/s"),
                     positive("frequency-to", &options.frequency_to, "rad/s"),
                     positive("points", &options.points), positive("damping-ratios", &options.damping_ratio)},
                    [&] { return resonance(options, work.watch); });
}

Result<TaskReport> run_local_error(const Work& work) {
  LocalErrorOptions options;
  return run_curves(work, options, {}, [&] { return local_errors(options); });
}

Result<TaskReport> run_method_map(const Work& work) {
  MethodMapOptions options;
  return run_curves(
      work, options,
      {positive("from", &options.from), positive("to", &options.to), positive("points", &options.points)},
      [&] { return method_map(options); });
}

Result<TaskReport> run_work_precision(const Work& work) {
  WorkPrecisionOptions options;
  return run_curves(work, options,
                    {positive("longest", &options.longest), positive("halvings", &options.halvings)},
                    [&] { return work_precision(options, work.watch); });
}

Result<TaskReport> run_spectrum(const Work& work) {
  SpectrumOptions options;
  std::vector<std::string> names;
  auto table = options_of(options);
  table.push_back(own_option("file", &names));
  if (const auto done = work.assign_settings(table); !done) return done.error();
  if (names.empty()) names.emplace_back();
  std::vector<Recording> recordings;
  for (const auto& name : names) {
    auto recording = work.recording(name, options.read);
    if (!recording) return recording.error();
    recordings.push_back(*std::move(recording));
  }
  const auto result = response_spectrum(recordings, options, work.watch);
  if (!result) return work.error(result.error());
  if (result->interrupted) return TaskReport{result->notices, Notice{"task_interrupted"}};
  collect(work.task.id, *result, work.results);
  return TaskReport{result->notices, {}};
}

/// Joins the lists of options that take a grid: [0.02, 0.05] becomes "0.02,0.05".
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
  constexpr double memory_for_rows = 1e9;  // [bytes]
  SweepOptions options;
  options.memory = memory_for_rows;
  const auto table = options_of(options);
  const TaskSpec joined = with_joined_grids(work.task, table);
  if (const auto done = Work{joined, work.study, work.results, work.watch}.assign_settings(table); !done)
    return done.error();
  const auto result = sweep(options, work.watch);
  if (!result) return work.error(result.error());
  TaskReport report{result->plan.notices, {}};
  for (const Notice& each : failure_notices(*result)) report.notices.push_back(each);
  if (result->interrupted) return TaskReport{report.notices, Notice{"task_interrupted"}};
  if (result->counts.not_settled == result->plan.rows.rows)
    return TaskReport{report.notices, Notice{"no_point_settled"}};
  collect(work.task.id, *result, work.results);
  return report;
}

/// The largest distance between the positions of two results, row by row.
Result<TaskReport> run_difference(const Work& work) {
  std::string of, minus;
  if (const auto done = work.assign_settings({own_option("of", &of), own_option("minus", &minus)}); !done)
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

constexpr Command commands[] = {{"simulate", run_simulate},
                                {"fit", run_fit},
                                {"compare", run_compare},
                                {"resonance", run_resonance},
                                {"local-error", run_local_error},
                                {"difference", run_difference},
                                {"method-map", run_method_map},
                                {"work-precision", run_work_precision},
                                {"spectrum", run_spectrum},
                                {"sweep", run_sweep},
                                {"modes", modes_task}};

/// Runs one task and adds its results under its id.
Result<TaskReport> run_task(const TaskSpec& task, const Study& study, Results& results, const Watch& watch) {
  for (const Command& command : commands)
    if (command.name == task.command) return command.run(Work{task, study, results, watch});
  return task.place.error(Notice{"no_command_of_study", {{"command", task.command}}});
}

bool is_shown(const TaskSpec& task, const Notice& notice) {
  return !task.shows.empty() && in_words(notice).find(task.shows) != std::string::npos;
}

Notice of_task(const TaskSpec& task, const Notice& notice) {
  return Notice{"of_task", {{"task", task.id}, {"what", notice}}};
}

}  // namespace

std::vector<std::string_view> study_commands() {
  std::vector<std::string_view> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

Result<StudyRun> run_study(const Study& study, const Watch& watch, const StudyProgress& progress,
                           const KnownResults& known) {
  StudyRun run{Results(study.language), {}, {}, {}};
  for (std::size_t i = 0; i < study.tasks.size(); ++i) {
    const TaskSpec& task = study.tasks[i];
    if (progress)
      progress(task.command + " " + task.id,
               static_cast<double>(i) / static_cast<double>(study.tasks.size()));
    if (const auto found = known.find(task.id); found != known.end()) {
      found->second(run.results);
      continue;
    }
    auto report = run_task(task, study, run.results, watch);
    if (!report) return report.error();
    bool shown = task.shows.empty();
    for (const Notice& notice : report->notices) {
      const bool meant = is_shown(task, notice);
      if (meant || !task.quiet) (meant ? run.shown : run.notices).push_back(of_task(task, notice));
      shown = shown || meant;
    }
    if (!shown)
      run.notices.push_back(
          task.place
              .error(Notice{"task_does_not_show",
                            {{"command", task.command}, {"task", task.id}, {"shows", task.shows}}})
              .notice);
    if (watch.interrupted()) report->failure = Notice{"task_interrupted"};
    if (!report->failure.empty()) {
      run.failure =
          task.place
              .error(Notice{"task_failed",
                            {{"command", task.command}, {"task", task.id}, {"what", report->failure}}})
              .notice;
      break;
    }
  }
  return run;
}

}  // namespace cromer::core
