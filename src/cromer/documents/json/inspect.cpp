#include "cromer/documents/json/documents.h"
#include "cromer/documents/json/json.h"
#include "cromer/documents/json/notices.h"
#include "cromer/documents/json/recording.h"
#include "cromer/read/columns.h"

namespace cromer::core {

Json inspection_object(const Inspection& inspection, bool with_values, const Voice& voice) {
  const Recording& recording = inspection.recording;
  Json document;
  document["file"] = recording.file;
  document["dialect"] = recording.dialect.name;
  document["encoding"] = recording.dialect.encoding;
  document["separator"] = recording.dialect.separator;
  document["decimal"] = recording.dialect.decimal;
  Json& columns = document["columns"] = Json::array();
  for (std::size_t j = 0; j < recording.table.columns.size(); ++j) {
    const Column& column = recording.table.columns[j];
    const InspectedColumn& seen = inspection.columns[j];
    columns.push_back({{"name", column_title(column)},
                       {"quantity", column.quantity},
                       {"unit", column.unit},
                       {"run", column.run},
                       {"samples", seen.samples},
                       {"time_column", or_null(seen.time_column)}});
    if (with_values) columns.back()["values"] = column.values;
  }
  document["column"] = or_null(inspection.column);
  document["samples"] = inspection.samples;
  document["rate"] = or_null(inspection.rate);
  document["duration"] = or_null(inspection.duration);
  document["time_column"] = or_null(inspection.time_column);
  document["jitter"] = inspection.jitter;
  Json& gaps = document["gaps"] = Json::array();
  Json& outliers = document["outliers"] = Json::array();
  const bool several_runs = runs(recording).size() > 1;
  for (const Series& series : inspection.series) {
    const auto add = [&](Json& list, Json found) {
      if (several_runs) found["run"] = series.run;
      list.push_back(std::move(found));
    };
    for (const auto& gap : series.gaps) add(gaps, {{"t", gap.t}, {"length", gap.length}});
    for (const auto& outlier : series.outliers)
      add(outliers, {{"t", outlier.t}, {"value", outlier.value}, {"line", outlier.line}});
  }
  add_notices(document, inspection.notices, voice);
  return document;
}

std::string to_json(const Inspection& inspection, bool with_values, const Voice& voice) {
  return to_text(inspection_object(inspection, with_values, voice), with_values);
}

}  // namespace cromer::core
