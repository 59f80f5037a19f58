#include "cromer/read.h"

#include <memory>
#include <utility>

#include "cromer/door/words.h"
#include "cromer/read/columns.h"
#include "cromer/read/recording.h"
#include "cromer/report/file.h"
#include "cromer/tasks/option/option.h"

namespace cromer {

const Column* Recording::find(std::string_view wanted, int run) const {
  if (!detail) return nullptr;
  const auto place = core::find_column(detail->table, wanted, run);
  return place ? &columns[*place] : nullptr;
}

Result<Recording> read(std::span<const std::byte> bytes, std::string_view file, const ReadOptions& options) {
  ReadOptions asked = options;
  for (const core::Option& option : core::options_of(asked))
    if (auto good = core::check(option); !good) return core::in_arguments(good.error());
  auto known =
      core::read_recording({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file, options);
  if (!known) return core::in_arguments(known.error());
  const auto detail = std::make_shared<const core::Recording>(*std::move(known));
  Recording recording;
  recording.file = file;
  recording.dialect = detail->dialect.name;
  for (const core::Column& each : detail->table.columns)
    recording.columns.push_back({each.name, each.quantity, each.unit, each.run, each.values});
  recording.notices = detail->notices;
  recording.options = options;
  recording.detail = detail;
  return recording;
}

Result<Recording> read_file(const std::string& path, const ReadOptions& options) {
  const auto bytes = core::read_file(path);
  if (!bytes) return bytes.error();
  return read(std::as_bytes(std::span(bytes->data(), bytes->size())), path, options);
}

}  // namespace cromer
