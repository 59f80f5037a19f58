// Runs the tasks of a study in the order of its file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/result.h"
#include "cromer/study/results.h"
#include "cromer/study/study_file.h"

namespace cromer::core {

/// What the tasks found, and what else there is to know, each with its task's name.
struct StudyRun {
  Results results;
  std::vector<Notice> notices;
  std::vector<Notice> shown;  ///< what their task is to show
  Notice failure;  ///< the task that did not succeed (diverged, no oscillation, interrupted), and why;
                   ///< the study ended there
};

/// Called before each task with what it is ("fit two") and the share done.
using StudyProgress = std::function<void(const std::string& what, double fraction)>;

/// Bad input is an Error that names the place in the study file.
Result<StudyRun> run_study(const Study& study, const Watch& watch = {}, const StudyProgress& progress = {});

}  // namespace cromer::core
