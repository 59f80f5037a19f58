#include "cromer/study/run_study.h"

namespace cromer {

Result<StudyRun> run_study(const Study& study, const Watch& watch, const StudyProgress& progress) {
  StudyRun run;
  for (std::size_t i = 0; i < study.tasks.size(); ++i) {
    const TaskSpec& task = study.tasks[i];
    const std::string what = task.command + " " + task.id;
    if (progress) progress(what, static_cast<double>(i) / static_cast<double>(study.tasks.size()));
    auto report = run_task(task, study, run.results, watch);
    if (!report) return report.error();
    for (const std::string& warning : report->warnings) run.warnings.push_back(task.id + ": " + warning);
    if (watch.interrupted()) report->failure = "interrupted";
    if (!report->failure.empty()) {
      run.failure = task.place.error(what + ": " + report->failure).message;
      break;
    }
  }
  return run;
}

}  // namespace cromer
