// The stages in their order: container, encoding, lines, dialect, layout, header, rows, runs, time.
#include <cmath>
#include <utility>

#include "cromer/read/columns.h"
#include "cromer/read/formats/archive.h"
#include "cromer/read/formats/program_file.h"
#include "cromer/read/in_file.h"
#include "cromer/read/recording.h"
#include "cromer/read/sets.h"
#include "cromer/read/text_file.h"

namespace cromer::core {

Result<Recording> read_recording(std::string_view bytes, std::string_view file, const ReadOptions& options) {
  using namespace dialects;
  if (options.rate < 0 || !std::isfinite(options.rate)) return Error{"rate_no_number"};
  auto recording = is_zip(bytes) ? read_archive(bytes, options) : read_text_file(bytes, file, options);
  if (!recording) {
    Notice menu = export_menu(file);
    return in_file(file, menu.empty() ? recording.error() : Error{std::move(menu)});
  }
  recording->file = file;
  if (const auto time = mark_time(*recording, options, recording->named); !time)
    return in_file(file, time.error());
  split_at_restarts(*recording);
  count_missing(*recording);
  return recording;
}

}  // namespace cromer::core
