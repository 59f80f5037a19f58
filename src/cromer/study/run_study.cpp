#include "cromer/study/run_study.h"

namespace cromer {

Result<StudyRun> run_study(const Study& study, const Watch& watch, const StudyProgress& progress) {
  StudyRun run;
  for (std::size_t i = 0; i < study.tasks.size(); ++i) {
    const TaskSpec& task = study.tasks[i];
    if (watch.interrupted()) return task.place.error("interrupted before " + task.command + " " + task.id);
    if (progress) progress(task.command + " " + task.id, static_cast<double>(i) / static_cast<double>(study.tasks.size()));
    auto warnings = run_task(task, study, run.results, watch);
    if (!warnings) return warnings.error();
    for (const std::string& warning : *warnings) run.warnings.push_back(task.id + ": " + warning);
  }
  return run;
}

}  // namespace cromer
