// The stages in their order: encoding, lines, layout, header, rows, runs, time.
#include <algorithm>
#include <cmath>

#include "cromer/base/concat.h"
#include "cromer/record/dialects/column_kind.h"
#include "cromer/record/dialects/columns.h"
#include "cromer/record/dialects/dialect_name.h"
#include "cromer/record/dialects/encoding.h"
#include "cromer/record/dialects/header.h"
#include "cromer/record/dialects/layout.h"
#include "cromer/record/dialects/lines.h"
#include "cromer/record/dialects/recording.h"
#include "cromer/record/dialects/rows.h"
#include "cromer/record/dialects/stacked_runs.h"

namespace cromer {

Result<Recording> read_recording(std::string_view bytes, std::string_view file, const ReadOptions& options) {
  using namespace dialects;
  const auto refuse = [&](std::string_view reason) { return Error{concat({file, ": ", reason})}; };
  if (options.rate < 0 || !std::isfinite(options.rate))
    return Error{"--rate is not a number of samples per second above 0"};

  const auto decoded = decode(bytes);
  if (!decoded) return refuse(decoded.error().message);
  if (const auto foreign = foreign_format(decoded->text()); !foreign.empty()) return refuse(foreign);
  const auto lines = split_lines(decoded->text());
  auto layout = find_layout(lines, options);
  if (!layout) return Error{concat({file, no_rows(lines, layout.error().message)})};
  layout = settle_commas(lines, *layout, options);
  if (!layout) return refuse(layout.error().message);

  const std::size_t data = find_data(lines, *layout);
  const Header header = find_header(lines, data, *layout);
  std::vector<std::string> names;
  for (const Column& column : name_columns(header, layout->columns)) names.push_back(column_title(column));
  auto rows = read_rows(lines, data, *layout, names, options.skip_bad_rows);
  if (!rows) return Error{concat({file, rows.error().message})};
  if (rows->lines.empty())
    return refuse(rows->bad_rows == 0 ? std::string("no rows of numbers are left")
                                      : concat({"no rows of numbers are left: ", rows->first_complaint,
                                                ", in line ", std::to_string(rows->first_bad_line)}));

  Recording recording;
  recording.file = file;
  recording.dialect = {std::string(dialect_name(header)), decoded->encoding,
                       std::string(separator_name(layout->separator)),
                       layout->decimal == ',' ? "comma" : "point"};
  recording.table.columns = name_columns(header, layout->columns);
  for (std::size_t j = 0; j < layout->columns; ++j)
    recording.table.columns[j].values = std::move(rows->columns[j]);
  recording.named = !header.headings.empty();
  recording.lines = std::move(rows->lines);
  const bool most_lost = rows->bad_rows > recording.lines.size();
  if (rows->bad_rows > 0)
    recording.warnings.push_back(
        concat({most_lost ? "MOST ROWS ARE LOST: " : "", counted(rows->bad_rows, "bad row"), " left out",
                most_lost ? concat({", ", counted(recording.lines.size(), "row"), " kept"}) : std::string{},
                ", the first in line ", std::to_string(rows->first_bad_line),
                most_lost ? concat({" (", rows->first_complaint, ")"}) : std::string{}}));
  drop_unnamed_empty(recording);
  if (split_stacked_runs(recording))
    recording.dialect.name = "Cromer";
  else
    number_runs(recording, header);
  if (const auto time = mark_time(recording, options, !header.headings.empty()); !time)
    return refuse(time.error().message);
  count_missing(recording);
  return recording;
}

}  // namespace cromer
