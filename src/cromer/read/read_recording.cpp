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
    // A table of that name may be a table all the same, and says what is wrong with it.
    const bool is_table =
        !is_zip(bytes) && !bytes.empty() && bytes.find('\0') == bytes.npos && !bytes.starts_with("<");
    Notice menu = is_table ? Notice{} : export_menu(file);
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
