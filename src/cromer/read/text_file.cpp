#include "cromer/read/text_file.h"

#include "cromer/read/cells.h"
#include "cromer/read/columns.h"
#include "cromer/read/encoding.h"
#include "cromer/read/formats/own_structures.h"
#include "cromer/read/formats/plain.h"
#include "cromer/read/formats/uff.h"
#include "cromer/read/in_file.h"
#include "cromer/read/layout.h"
#include "cromer/read/sets.h"

namespace cromer::core::dialects {
namespace {

/// What a table needs, whatever its format: names, no empty columns at its end, and a limit to its width.
Result<void> tidy(Set& set) {
  number_unnamed(set.columns);
  drop_unnamed_empty(set.columns);
  if (set.columns.size() <= most_columns) return {};
  return set.names_line > 0 ? in_line(set.names_line, too_many_columns()) : too_many_columns();
}

Result<Recording> recording_of(Result<Sets> sets) {
  if (!sets) return sets.error();
  if (sets->sets.empty()) return Error{"no_set_of_rows"};
  for (Set& set : sets->sets)
    if (const auto tidied = tidy(set); !tidied) return tidied.error();
  Recording recording;
  recording.dialect.name = std::move(sets->dialect);
  recording.dialect.separator = separator_name(sets->separator);
  recording.dialect.decimal = sets->decimal == ',' ? "comma" : "point";
  recording.named = true;
  recording.notices = std::move(sets->notices);
  recording.motion = std::move(sets->motion);
  if (const auto laid = lay_side_by_side(std::move(sets->sets), recording); !laid) return laid.error();
  return recording;
}

}  // namespace

Result<Recording> read_text_file(std::string_view bytes, std::string_view file, const ReadOptions& options) {
  const auto decoded = decode(bytes);
  if (is_uff(bytes)) {
    auto recording = recording_of(read_uff(bytes));
    if (recording) recording->dialect.encoding = decoded ? decoded->encoding : "binary";
    return recording;
  }
  if (!decoded) return decoded.error();
  const auto lines = split_lines(decoded->text());
  const Source source{decoded->text(), lines, file, options};
  const auto read = [&]() -> Result<Recording> {
    for (const OwnStructure* own : own_structures)
      if (own->recognised(source)) return recording_of(own->read(source));
    const auto starts = find_tables(lines);
    if (starts.size() == 1) return read_plain(lines, options);
    auto tables = read_tables(lines, starts, options);
    if (tables) return tables;
    // A title may look like a row (a date, a count): then there is only one table.
    auto plain = read_plain(lines, options);
    return plain ? std::move(plain) : std::move(tables);
  };
  auto recording = read();
  if (recording) recording->dialect.encoding = decoded->encoding;
  return recording;
}

}  // namespace cromer::core::dialects
