#include "cromer/read.h"

#include <memory>
#include <utility>

#include "cromer/door/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"
#include "cromer/tasks/open_recording.h"
#include "cromer/tasks/option/option.h"

namespace cromer {

const Column* Recording::find(std::string_view wanted, int run) const {
  if (!detail) return nullptr;
  const auto place = core::find_column(detail->table, wanted, run);
  return place ? &columns[*place] : nullptr;
}

namespace {

/// What the file holds, as callers get it; `known` is how it was read, or why not.
Result<Recording> recording_of(Result<core::Recording> known, const ReadOptions& options) {
  if (!known) return core::in_arguments(known.error());
  const auto detail = std::make_shared<const core::Recording>(*std::move(known));
  Recording recording;
  recording.file = detail->file;
  recording.dialect = detail->dialect.name;
  for (const core::Column& each : detail->table.columns)
    recording.columns.push_back({each.name, each.quantity, each.unit, each.run, each.values});
  recording.notices = detail->notices;
  recording.options = options;
  recording.detail = detail;
  return recording;
}

Result<void> check(const ReadOptions& options) {
  ReadOptions asked = options;
  for (const core::Option& option : core::options_of(asked))
    if (auto good = core::check(option); !good) return core::in_arguments(good.error());
  return {};
}

}  // namespace

Result<Recording> read(std::span<const std::byte> bytes, std::string_view file, const ReadOptions& options) {
  if (auto good = check(options); !good) return good.error();
  return recording_of(
      core::read_recording({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file, options),
      options);
}

Result<Recording> read_file(const std::string& path, const ReadOptions& options) {
  if (auto good = check(options); !good) return good.error();
  return recording_of(core::open_recording(path, options), options);
}

}  // namespace cromer
