// A study becomes a folder: index.html, its figures as SVG files, and what was found as JSON.
#pragma once

#include <string>
#include <vector>

#include "cromer/base/interrupt.h"
#include "cromer/result.h"
#include "cromer/study/run_study.h"

namespace cromer::core {

struct WrittenReport {
  std::string index;                 ///< path of index.html; empty if a task failed
  std::vector<std::string> figures;  ///< paths
  std::vector<Notice> notices;
  std::vector<Notice> shown;  ///< what the study is to show
  Notice failure;  ///< which task did not succeed, where in the study, and why; then nothing was written
};

/// Reads the study, runs it, draws its figures and only then writes; each file whole or not at all. `date` is
/// shown under the title ("21 November 2026"), and with it
/// `program` ("cromer 0.1.0"), which at the foot is followed by the versions of what drew and compiled.
Result<WrittenReport> write_report(const std::string& study_path, const std::string& folder,
                                   const std::string& date, const std::string& program,
                                   const Watch& watch = {}, const StudyProgress& progress = {});

}  // namespace cromer::core
