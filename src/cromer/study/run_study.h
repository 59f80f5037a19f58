// Runs the tasks of a study in the order of its file.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/result.h"
#include "cromer/study/results.h"
#include "cromer/study/study_file.h"

namespace cromer::core {

/// The results of the tasks, and their notices, each with the name of its task.
struct StudyRun {
  Results results;
  std::vector<Notice> notices;
  std::vector<Notice> shown;  ///< notices that their task is meant to show
  Notice failure;  ///< the task that did not succeed (diverged, no oscillation, interrupted), and why; the
                   ///< study ended there
};

/// What a task may be: simulate, fit, local-error, ...
std::vector<std::string_view> study_commands();

/// Called before each task with its command and name ("fit two") and the fraction of tasks done.
using StudyProgress = std::function<void(const std::string& what, double fraction)>;

/// Results of tasks that are known already, by the names of the tasks: what puts them among the others.
using KnownResults = std::map<std::string, std::function<void(Results&)>>;

/// Bad input is an Error that names the place in the study file. A task whose results are `known` is not run.
Result<StudyRun> run_study(const Study& study, const Watch& watch = {}, const StudyProgress& progress = {},
                           const KnownResults& known = {});

}  // namespace cromer::core
