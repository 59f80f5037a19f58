#include "cromer/study/run_study.h"

namespace cromer::core {

namespace {

bool is_shown(const TaskSpec& task, const std::string& warning) {
  return !task.shows.empty() && warning.find(task.shows) != std::string::npos;
}

}  // namespace

Result<StudyRun> run_study(const Study& study, const Watch& watch, const StudyProgress& progress) {
  StudyRun run;
  for (std::size_t i = 0; i < study.tasks.size(); ++i) {
    const TaskSpec& task = study.tasks[i];
    const std::string what = task.command + " " + task.id;
    if (progress) progress(what, static_cast<double>(i) / static_cast<double>(study.tasks.size()));
    Watch of_task = watch;
    if (watch.warn)
      of_task.warn = [&](const std::vector<std::string>& warnings) {
        std::vector<std::string> named;
        for (const std::string& warning : warnings)
          if (!is_shown(task, warning)) named.push_back(task.id + ": " + warning);
        if (!named.empty()) watch.warn(named);
      };
    auto report = run_task(task, study, run.results, of_task);
    if (!report) return report.error();
    bool shown = task.shows.empty();
    for (const std::string& warning : report->warnings) {
      (is_shown(task, warning) ? run.shown : run.warnings).push_back(task.id + ": " + warning);
      shown = shown || is_shown(task, warning);
    }
    if (!shown)
      run.warnings.push_back(
          task.place.error(what + " is to show \"" + task.shows + "\", and does not").message);
    if (watch.interrupted()) report->failure = "interrupted";
    if (!report->failure.empty()) {
      run.failure = task.place.error(what + ": " + report->failure).message;
      break;
    }
  }
  return run;
}

}  // namespace cromer::core
