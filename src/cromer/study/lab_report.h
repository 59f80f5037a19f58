// The study file of one's own recordings: TOML for `cromer report` (study_file.h), with the figures and the
// sentences that their fits support.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cromer/notice.h"
#include "cromer/result.h"
#include "cromer/study/lab_page.h"
#include "cromer/study/run_study.h"
#include "cromer/tasks/compare/compare.h"

namespace cromer::core {

/// The method that simulates a recording for the comparison with it: its own error is not seen.
inline constexpr const char* report_method = "rk4";

/// A recording, as the study names its file, with its fit. A free motion of a position or an angle is also
/// compared with simulations.
struct ReportedRecording {
  std::string path;
  FittedRecording fitted;
  std::optional<CompareResult> compared{};
};

/// A study that fits the same recordings with the same options, as they were typed. Each sentence and each
/// figure is there only where the fit supports it; the numbers in them are the study's own, so that they
/// follow when an option is changed. Of a fit that did not succeed it says why, and draws the recording.
///
/// Its first line tells whether it was changed since: see is_as_made().
std::string lab_report(std::span<const ReportedRecording> recordings, const std::vector<TypedOption>& options,
                       const ReportFront& front);

/// The results of its fits and comparisons, so that the study need not make them again. `recordings` must
/// outlive them.
KnownResults known_results(std::span<const ReportedRecording> recordings);

/// Reads title, author, course, text and language from TOML. Errors name file, line and column.
Result<ReportFront> read_report_front(std::string_view toml, const std::string& file);

}  // namespace cromer::core
