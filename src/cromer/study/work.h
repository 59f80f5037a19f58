// A task of a study at work: its settings, and where its results go.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/notice.h"
#include "cromer/read/recording.h"
#include "cromer/result.h"
#include "cromer/study/results.h"
#include "cromer/study/study_file.h"
#include "cromer/tasks/option/option.h"

namespace cromer::core {

/// What a task says besides its results.
struct TaskReport {
  std::vector<Notice> notices;
  Notice failure;  ///< why it did not succeed; empty if it succeeded
};

struct Work {
  const TaskSpec& task;
  const Study& study;
  Results& results;
  const Watch& watch;

  /// `file` is relative to the study file.
  Result<Recording> recording(const std::string& file, const ReadOptions& options) const;

  /// The path of a file that is relative to the study file.
  std::string path_of(const std::string& file) const;

  bool has_setting(std::string_view option) const;

  /// Assigns every setting to its option, with results filled into the texts. Errors name the place in the
  /// study file; of an unknown key the nearest option is suggested.
  Result<void> assign_settings(const std::vector<Option>& options) const;

  Error error(const Error& inner) const { return task.place.error(inner.notice); }
};

/// An option that only studies have.
Option own_option(std::string_view name, Option::Target target, std::string_view unit = "",
                  Range range = Range::any);

}  // namespace cromer::core
