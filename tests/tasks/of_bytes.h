// The tasks on recordings that a test has as bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cromer/tasks/compare/compare.h"
#include "cromer/tasks/fit/fit.h"
#include "cromer/tasks/inspect/inspect.h"
#include "cromer/tasks/simulate/drive_record.h"
#include "cromer/tasks/spectrum/response_spectrum.h"

namespace cromer::core {

inline Result<std::vector<FittedRecording>> fit(std::string_view bytes, std::string_view file,
                                                const FitOptions& options, const Watch& watch = {}) {
  const auto recording = read_recording(bytes, file, options.read);
  return recording ? fit(*recording, options, watch) : recording.error();
}

inline Result<std::vector<CompareResult>> compare(std::string_view bytes, std::string_view file,
                                                  const CompareOptions& options, const Watch& watch = {}) {
  const auto recording = read_recording(bytes, file, options.fit.read);
  return recording ? compare(*recording, options, watch) : recording.error();
}

inline Result<Inspection> inspect(std::string_view bytes, std::string_view file, const ReadOptions& options,
                                  std::string_view column = "") {
  auto recording = read_recording(bytes, file, options);
  return recording ? inspect(*std::move(recording), options, column) : recording.error();
}

inline Result<DriveRecord> drive_record(std::string_view bytes, std::string_view file,
                                        const DriveRequest& request, const ReadOptions& options) {
  const auto recording = read_recording(bytes, file, options);
  return recording ? drive_record(*recording, request, options) : recording.error();
}

/// A file of a recorded acceleration.
struct SpectrumFile {
  std::string name, bytes;
};

inline Result<std::vector<Recording>> recordings_of(std::span<const SpectrumFile> files,
                                                    const SpectrumOptions& options) {
  std::vector<Recording> all;
  for (const SpectrumFile& file : files) {
    auto recording = read_recording(file.bytes, file.name, options.read);
    if (!recording) return recording.error();
    all.push_back(*std::move(recording));
  }
  return all;
}

inline Result<SpectrumResult> response_spectrum(std::span<const SpectrumFile> files,
                                                const SpectrumOptions& options, const Watch& watch = {}) {
  const auto recordings = recordings_of(files, options);
  return recordings ? response_spectrum(*recordings, options, watch) : recordings.error();
}

}  // namespace cromer::core
