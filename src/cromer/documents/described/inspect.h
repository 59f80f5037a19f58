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
          "title of the column, \"Time (s)\", as the option `column` takes it"),
      field(
          "quantity", [](const ColumnOfFile& c) { return c.column.quantity; }, "",
          "the recorded quantity: time, position, ..."),
      field(
          "unit", [](const ColumnOfFile& c) { return c.column.unit; }, "", "unit, as in the file"),
      field(
          "run", [](const ColumnOfFile& c) { return c.column.run; }, "", "number of the run, from 1"),
      field(
          "samples", [](const ColumnOfFile& c) { return c.seen.samples; }, "",
          "number of values that are not missing"),
      field(
          "time_column", [](const ColumnOfFile& c) { return unless_empty(c.seen.time_column); }, "",
          "the column of its times; null if there is none or if it is a time itself"),
      field(
          "values",
          [](const ColumnOfFile& c) { return c.with_values ? std::optional(c.column.values) : std::nullopt; },
          "as the file has it", "its numbers; only in a file written as JSON")
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
                  "t", [](const GapOfRun& g) { return g.gap.t; }, "s", "beginning of the gap")
                  .known(),
              field(
                  "length", [](const GapOfRun& g) { return g.gap.length; }, "s", "length of the gap")
                  .known(),
              field("run", &GapOfRun::run, "", "number of the run; only if there are several").left_out());
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
          "t", [](const OutlierOfRun& o) { return o.outlier.t; }, "s", "time of the sample")
          .known(),
      field(
          "value", [](const OutlierOfRun& o) { return o.outlier.value; }, "SI", "its value"),
      field(
          "line", [](const OutlierOfRun& o) { return o.outlier.line; }, "", "its line in the file, from 1"),
      field("run", &OutlierOfRun::run, "", "number of the run; only if there are several").left_out());
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
          "file", [](const File& f) { return f.seen.recording.file; }, "", "name of the file"),
      field(
          "dialect", [](const File& f) { return f.dialect().name; }, "", "the logger that wrote it"),
      field(
          "encoding", [](const File& f) { return f.dialect().encoding; }, "", "encoding of its text"),
      field(
          "separator", [](const File& f) { return f.dialect().separator; }, "", "separator of its columns"),
      field(
          "decimal", [](const File& f) { return f.dialect().decimal; }, "", "decimal mark of its numbers"),
      field("columns", &File::columns, "", "all columns"),
      field(
          "column", [](const File& f) { return unless_empty(f.seen.column); }, "",
          "the column that the rest describes: the one asked for, else the one that a fit takes, or the "
          "first of several alike"),
      field(
          "samples", [](const File& f) { return f.seen.samples; }, "", "number of rows of the longest run"),
      field(
          "rate", [](const File& f) { return unless_zero(f.seen.rate); }, "1/s",
          "samples per second; null if not known"),
      field(
          "duration", [](const File& f) { return unless_zero(f.seen.duration); }, "s",
          "duration of the recording; null if not known"),
      field(
          "time_column", [](const File& f) { return unless_empty(f.seen.time_column); }, "",
          "the column of its times; null if there is none"),
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
