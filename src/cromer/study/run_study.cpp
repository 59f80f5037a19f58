#include "cromer/study/run_study.h"

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace {

bool is_shown(const TaskSpec& task, const Notice& notice) {
  return !task.shows.empty() && in_words(notice).find(task.shows) != std::string::npos;
}

Notice of_task(const TaskSpec& task, const Notice& notice) {
  return Notice{"of_task", {{"task", task.id}, {"what", notice}}};
}

}  // namespace

Result<StudyRun> run_study(const Study& study, const Watch& watch, const StudyProgress& progress) {
  StudyRun run;
  for (std::size_t i = 0; i < study.tasks.size(); ++i) {
    const TaskSpec& task = study.tasks[i];
    if (progress)
      progress(task.command + " " + task.id,
               static_cast<double>(i) / static_cast<double>(study.tasks.size()));
    auto report = run_task(task, study, run.results, watch);
    if (!report) return report.error();
    bool shown = task.shows.empty();
    for (const Notice& notice : report->notices) {
      (is_shown(task, notice) ? run.shown : run.notices).push_back(of_task(task, notice));
      shown = shown || is_shown(task, notice);
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
