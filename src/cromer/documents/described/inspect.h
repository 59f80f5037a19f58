// What the document of `inspect` consists of.
#pragma once

#include "cromer/documents/described/describe.h"
#include "cromer/read/columns.h"
#include "cromer/tasks/inspect/inspect.h"

namespace cromer::core {

/// A column of the file, and what was found out about it.
struct ColumnOfFile {
  const Column& column;
  const InspectedColumn& seen;
  bool with_values;
};

template <>
struct Described<ColumnOfFile> {
  static constexpr std::string_view name = "Column";
  static constexpr auto entries = members(
      field(
          "name", [](const ColumnOfFile& c) { return column_title(c.column); }, "",
          "its title, \"Time (s)\", as the option `column` takes it"),
      field(
          "quantity", [](const ColumnOfFile& c) { return c.column.quantity; }, "", "time, position, ..."),
      field(
          "unit", [](const ColumnOfFile& c) { return c.column.unit; }, "", "as the file has it"),
      field(
          "run", [](const ColumnOfFile& c) { return c.column.run; }, "", "from 1"),
      field(
          "samples", [](const ColumnOfFile& c) { return c.seen.samples; }, "", "values that are not missing"),
      field(
          "time_column", [](const ColumnOfFile& c) { return unless_empty(c.seen.time_column); }, "",
          "the time it is taken with; null of a time, and where there is none"),
      field(
          "values",
          [](const ColumnOfFile& c) { return c.with_values ? std::optional(c.column.values) : std::nullopt; },
          "as the file has it", "only in a file written as JSON")
          .left_out());
};

/// A gap, with its run if there are several.
struct GapOfRun {
  Gap gap;
  std::optional<int> run;
};

template <>
struct Described<GapOfRun> {
  static constexpr std::string_view name = "Gap";
  static constexpr auto entries =
      members(field(
                  "t", [](const GapOfRun& g) { return g.gap.t; }, "s", "where samples begin to be missing")
                  .known(),
              field(
                  "length", [](const GapOfRun& g) { return g.gap.length; }, "s", "how long")
                  .known(),
              field("run", &GapOfRun::run, "", "only where there are several").left_out());
};

/// An outlier, with its run if there are several.
struct OutlierOfRun {
  Outlier outlier;
  std::optional<int> run;
};

template <>
struct Described<OutlierOfRun> {
  static constexpr std::string_view name = "Outlier";
  static constexpr auto entries = members(
      field(
          "t", [](const OutlierOfRun& o) { return o.outlier.t; }, "s", "of a sample far from its neighbours")
          .known(),
      field(
          "value", [](const OutlierOfRun& o) { return o.outlier.value; }, "SI", "what it says"),
      field(
          "line", [](const OutlierOfRun& o) { return o.outlier.line; }, "", "of the file, from 1"),
      field("run", &OutlierOfRun::run, "", "only where there are several").left_out());
};

/// A file that was inspected, with or without its numbers.
struct InspectedFile {
  const Inspection& seen;
  bool with_values;

  const Dialect& dialect() const { return seen.recording.dialect; }
  std::vector<ColumnOfFile> columns() const {
    std::vector<ColumnOfFile> all;
    const auto& table = seen.recording.table.columns;
    for (std::size_t j = 0; j < table.size(); ++j) all.push_back({table[j], seen.columns[j], with_values});
    return all;
  }
  /// The gaps or outliers of all series, each with its run if there are several.
  template <class OfRun, class Found>
  std::vector<OfRun> of_runs(std::vector<Found> Series::*found) const {
    const bool several = runs(seen.recording).size() > 1;
    std::vector<OfRun> all;
    for (const Series& series : seen.series)
      for (const Found& each : series.*found)
        all.push_back({each, several ? std::optional(series.run) : std::nullopt});
    return all;
  }
};

template <>
struct Described<InspectedFile> {
  using File = InspectedFile;
  static constexpr std::string_view name = "InspectedFile";
  static constexpr auto entries = members(
      field(
          "file", [](const File& f) { return f.seen.recording.file; }, "", "its name"),
      field(
          "dialect", [](const File& f) { return f.dialect().name; }, "", "the logger that wrote it"),
      field(
          "encoding", [](const File& f) { return f.dialect().encoding; }, "", "of its text"),
      field(
          "separator", [](const File& f) { return f.dialect().separator; }, "", "between its columns"),
      field(
          "decimal", [](const File& f) { return f.dialect().decimal; }, "", "of its numbers"),
      field("columns", &File::columns, "", "all of them"),
      field(
          "column", [](const File& f) { return unless_empty(f.seen.column); }, "",
          "the one that the rest describes: that asked for, else what a fit would take, or the first of "
          "several alike"),
      field(
          "samples", [](const File& f) { return f.seen.samples; }, "", "rows of the longest run"),
      field(
          "rate", [](const File& f) { return unless_zero(f.seen.rate); }, "1/s", "null where not known"),
      field(
          "duration", [](const File& f) { return unless_zero(f.seen.duration); }, "s",
          "null where not known"),
      field(
          "time_column", [](const File& f) { return unless_empty(f.seen.time_column); }, "",
          "the time of that column; null without"),
      field(
          "jitter", [](const File& f) { return f.seen.jitter; }, "",
          "standard deviation of the time steps over their median"),
      field(
          "gaps", [](const File& f) { return f.of_runs<GapOfRun>(&Series::gaps); }, "",
          "where samples are missing"),
      field(
          "outliers", [](const File& f) { return f.of_runs<OutlierOfRun>(&Series::outliers); }, "",
          "samples far from their neighbours"),
      notices([](const File& f) -> const std::vector<Notice>& { return f.seen.notices; }));
};

}  // namespace cromer::core
