// What there is to say of the fits of a file, or of what was made of them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cromer/read/in_file.h"
#include "cromer/tasks/fit/fit.h"

namespace cromer::core {

inline const FittedRecording& fit_of_run(const FittedRecording& fitted) { return fitted; }

/// The notices of results of one file. Where it has several runs, each names the run that it is about, unless
/// it is about the whole file.
template <class Found>
std::vector<Notice> said_of_runs(std::span<const Found> results) {
  std::vector<Notice> said;
  OfRuns runs;
  for (const Found& result : results) {
    const FittedRecording& fitted = fit_of_run(result);
    for (std::size_t i = 0; i < result.notices.size(); ++i)
      if (fitted.one_of_several && i >= fitted.of_file)
        runs.say(fitted.series.run, result.notices[i]);
      else
        said.push_back(result.notices[i]);
  }
  for (Notice& notice : runs.said()) said.push_back(std::move(notice));
  return said;
}

template <class Found>
std::vector<Notice> said_of_runs(const std::vector<Found>& results) {
  return said_of_runs(std::span<const Found>(results));
}

}  // namespace cromer::core
