#include "cromer/tasks/open_recording.h"

#include "cromer/report/file.h"

namespace cromer::core {

Result<Recording> open_recording(const std::string& path, const ReadOptions& options,
                                 const std::string& name) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  return read_recording(*bytes, name.empty() ? path : name, options);
}

Result<std::vector<Recording>> open_recordings(const std::vector<std::string>& paths,
                                               const ReadOptions& options) {
  std::vector<Recording> recordings;
  for (const std::string& path : paths) {
    auto recording = open_recording(path, options);
    if (!recording) return recording.error();
    recordings.push_back(*std::move(recording));
  }
  return recordings;
}

}  // namespace cromer::core
