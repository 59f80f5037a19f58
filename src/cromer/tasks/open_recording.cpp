#include "cromer/tasks/open_recording.h"

#include "cromer/report/file.h"

namespace cromer::core {

Result<Recording> open_recording(const std::string& path, const ReadOptions& options,
                                 const std::string& name) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  return read_recording(*bytes, name.empty() ? path : name, options);
}

}  // namespace cromer::core
