#include "cromer/documents/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "cromer/base/quantity.h"
#include "cromer/documents/text/words.h"
#include "cromer/documents/words/words.h"
#include "cromer/read/recording.h"

namespace cromer::core {
namespace {

/// "Pos B (mm): position, 356 samples at Time B (s)"; the time only where there are several.
std::string column_text(const Inspection& inspection, std::size_t i, bool several_times) {
  const Recording& recording = inspection.recording;
  const std::string& quantity = recording.table.columns[i].quantity;
  const InspectedColumn& column = inspection.columns[i];
  std::string text = column_heading(recording.table, i) + ": ";
  if (!quantity.empty()) text += quantity + ", ";
  text += fmt::format("{} samples", column.samples);
  if (several_times && !column.time_column.empty()) text += " at " + column.time_column;
  return text;
}

}  // namespace

std::string inspect_text(const Inspection& inspection) {
  const Recording& recording = inspection.recording;
  const auto line = [](std::string_view what, const std::string& value) {
    return fmt::format("{:<13}{}\n", what, value);
  };
  std::string out = recording.file + "\n";
  out += line("dialect", fmt::format("{}, {}, separated by {}, decimal {}", recording.dialect.name,
                                     recording.dialect.encoding, recording.dialect.separator,
                                     recording.dialect.decimal));
  const auto& columns = recording.table.columns;
  const bool several_times =
      std::any_of(inspection.columns.begin(), inspection.columns.end(), [&](const auto& column) {
        return !column.time_column.empty() && column.time_column != inspection.time_column;
      });
  for (std::size_t i = 0; i < columns.size(); ++i)
    out += line("column", column_text(inspection, i, several_times));
  out += line("samples", fmt::format("{}", inspection.samples));
  if (inspection.series.size() > 1)
    for (const Series& series : inspection.series)
      out += line("", fmt::format("run {}: {} samples, {}", series.run, series.t.size(),
                                  format_quantity({series.t.back() - series.t.front(), 0}, "s")));
  if (inspection.rate > 0) out += line("rate", format_quantity({inspection.rate, 0}, "Hz"));
  if (inspection.duration > 0) out += line("duration", format_quantity({inspection.duration, 0}, "s"));
  out += line("time", inspection.time_column.empty() ? "no time column" : inspection.time_column);
  if (inspection.jitter > 1e-6)  // below is the rounding of the times
    out += line("jitter", format_quantity({100 * inspection.jitter, 0}, "% of a step"));
  const bool several = inspection.columns.size() > 2;  // a time and more than one motion
  const auto list = [&](std::string_view what, const std::vector<std::string>& found) {
    constexpr std::size_t shown = 20;
    out += line(what, several ? fmt::format("{} in \"{}\"", found.size(), inspection.column)
                              : fmt::format("{}", found.size()));
    for (std::size_t i = 0; i < std::min(shown, found.size()); ++i) out += line("", found[i]);
    if (found.size() > shown)
      out += line("", in_words(Notice{"list_goes_on", {{"more", found.size() - shown}}}));
  };
  const bool several_runs = runs(recording).size() > 1;
  std::vector<std::string> gaps, outliers;
  for (const Series& series : inspection.series) {
    const std::string run = several_runs ? fmt::format("run {}: ", series.run) : "";
    for (const Gap& gap : series.gaps)
      gaps.push_back(fmt::format("{}{:.6g} s long at {:.6g} s", run, gap.length, gap.t));
    for (const Outlier& outlier : series.outliers)
      outliers.push_back(
          fmt::format("{}{:.6g} at {:.6g} s, line {}", run, outlier.value, outlier.t, outlier.line));
  }
  list("gaps", gaps);
  list("outliers", outliers);
  return out;
}

}  // namespace cromer::core
