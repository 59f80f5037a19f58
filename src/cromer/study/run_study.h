// Runs the tasks of a study in the order of its file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/base/result.h"
#include "cromer/study/results.h"
#include "cromer/study/study_file.h"

namespace cromer {

/// What the tasks found, and what they warned of ("name: warning").
struct StudyRun {
  Results results;
  std::vector<std::string> warnings;
};

/// Called before each task with what it is ("fit two") and the share done.
using StudyProgress = std::function<void(const std::string& what, double fraction)>;

/// An Error names the place in the study file; a task that does not succeed (diverged, no oscillation) is one too.
Result<StudyRun> run_study(const Study& study, const Watch& watch = {}, const StudyProgress& progress = {});

/// Runs one task and adds what it found under its id; returns its warnings.
Result<std::vector<std::string>> run_task(const TaskSpec& task, const Study& study, Results& results, const Watch& watch);

}  // namespace cromer
