#include "fit_files.h"

#include <iterator>
#include <new>
#include <utility>

#include "cromer/tasks/fit/one_mass.h"
#include "cromer/tasks/open_recording.h"

namespace cromer::core::cli {
namespace {

std::vector<FittedRecording> fit_file(const std::string& file, const FitOptions& options,
                                      const Watch& watch) {
  try {
    const auto recording = open_recording(file, options.read);
    if (!recording) return {not_fitted(file, options.run.value_or(1), recording.error().notice)};
    auto fits = fit(*recording, options, watch);
    if (!fits) return {not_fitted(file, options.run.value_or(1), fits.error().notice)};
    return *std::move(fits);
  } catch (const std::bad_alloc&) {
    return {not_fitted(file, 1, Notice{"no_memory_for_file"})};
  }
}

std::vector<FittedRecording> fit_files(const std::vector<std::string>& files, const FitOptions& options,
                                       const Watch& watch) {
  std::vector<std::vector<FittedRecording>> of_file(files.size());
  for_each_file(files.size(), watch, [&](std::size_t i, const Watch& of_one) {
    FitOptions own = options;
    if (own.mass.size() > 1) own.mass = {options.mass[i]};
    of_file[i] = fit_file(files[i], own, of_one);
  });
  std::vector<FittedRecording> fits;
  for (auto& each : of_file) std::move(each.begin(), each.end(), std::back_inserter(fits));
  if (options.mass.size() == 1) doubt_one_mass_for_files(fits);
  return fits;
}

}  // namespace

Result<std::vector<FittedRecording>> fit_all(const RecordingFiles& found, const FitOptions& options,
                                             const Watch& watch) {
  const std::size_t masses = options.mass.size();
  if (found.many && masses > 1 && masses != found.files.size())
    return Error{"masses_unlike_files", {{"masses", masses}, {"files", found.files.size()}}};
  if (found.many) return fit_files(found.files, options, watch);
  const auto recording = open_recording(found.files.front(), options.read);
  return recording ? fit(*recording, options, watch) : recording.error();
}

}  // namespace cromer::core::cli
