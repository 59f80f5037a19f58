#include <filesystem>

#include "cromer/report/file.h"
#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {

Result<void> load_drive(SimulateOptions& options, const std::string& folder) {
  const bool ground = !options.base_motion.empty();
  const std::string& file = ground ? options.base_motion : options.drive_file;
  if (file.empty()) return {};
  const auto bytes = read_file((std::filesystem::path(folder) / file).string());
  if (!bytes)
    return Error{ground ? "base_motion_not_read" : "drive_file_not_read", {{"what", bytes.error().notice}}};
  const auto recording = read_recording(*bytes, file, options.read);
  if (!recording) return recording.error();
  auto record = drive_record(*recording,
                             {.quantity = ground ? "acceleration" : "force", .column = options.drive_column},
                             options.read);
  if (!record) return record.error();
  options.drive_record = *std::move(record);
  return {};
}

}  // namespace cromer::core
