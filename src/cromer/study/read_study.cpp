#include <algorithm>
#include <cctype>
#include <filesystem>
#include <initializer_list>
#include <set>

#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"
#include "cromer/base/quantity.h"
#include "cromer/read/toml_reader.h"
#include "cromer/study/lab_report.h"
#include "cromer/study/run_study.h"
#include "cromer/study/study_file.h"

namespace cromer::core {
namespace {

/// A text with the place of its value; empty where the key is missing.
StudyText study_text(TomlReader& toml, std::string_view key) {
  const std::string text = toml.text(key);
  return {text, toml.has(key) ? toml.place_of_key(key) : toml.place()};
}

TaskSpec read_task(TomlReader& toml) {
  TaskSpec task;
  task.place = toml.place();
  for (const auto command : study_commands())
    if (const std::string key = with_underscores(command); toml.has(key)) {
      task.command = command;
      task.id = toml.text(key);
    }
  task.shows = toml.text("shows");
  task.may_fail = toml.yes("may_fail");
  task.quiet = toml.yes("quiet");
  for (const std::string& key : toml.keys()) {
    if (with_hyphens(key) == task.command || key == "shows" || key == "may_fail" || key == "quiet") continue;
    task.settings.push_back({with_hyphens(key), toml.values(key), toml.place_of_key(key)});
  }
  return task;
}

CurveSpec read_curve(TomlReader& toml) {
  CurveSpec curve;
  curve.place = toml.place();
  curve.of = toml.text("of");
  curve.minus = toml.text("minus");
  curve.x = toml.text("x");
  curve.y = toml.text("y");
  curve.from = toml.maybe_number("from");
  curve.to = toml.maybe_number("to");
  curve.look.role = toml.text("role");
  curve.look.name = toml.text("name");
  curve.look.remark = toml.text("remark");
  curve.look.dashed = toml.yes("dashed");
  const std::string mark = toml.choice("mark", {"line", "dots", "band"});
  curve.look.mark = mark == "dots" ? Mark::dots : mark == "band" ? Mark::band : Mark::line;
  curve.look.label_x = toml.maybe_number("label_x");
  curve.look.label_y = toml.maybe_number("label_y");
  curve.look.text_x = toml.maybe_number("text_x");
  curve.look.text_y = toml.maybe_number("text_y");
  return curve;
}

Axis read_axis(TomlReader& toml, const std::string& which) {
  Axis axis;
  axis.name = toml.text(which + "_name");
  axis.low = toml.number(which + "_low", axis.low);
  axis.high = toml.number(which + "_high", axis.high);
  axis.step = toml.number(which + "_step", axis.step);
  axis.logarithmic = toml.yes(which + "_logarithmic");
  return axis;
}

Note read_note(TomlReader& toml) {
  Note note;
  note.text = toml.text("text");
  note.x = toml.number("x", note.x);
  note.y = toml.number("y", note.y);
  note.text_x = toml.number("text_x", note.text_x);
  note.text_y = toml.number("text_y", note.text_y);
  note.circle = toml.yes("circle");
  note.leader = !toml.yes("no_leader");
  return note;
}

struct StudyReader {
  std::string file;
  std::optional<Error> error{};

  PanelSpec panel(TomlReader& toml) {
    PanelSpec panel;
    panel.place = toml.place();
    panel.look.x = read_axis(toml, "x");
    panel.look.y = read_axis(toml, "y");
    panel.x = toml.text("x");
    panel.y = toml.text("y");
    panel.x_unit = toml.text("x_unit");
    panel.y_unit = toml.text("y_unit");
    panel.from = toml.maybe_number("from");
    panel.to = toml.maybe_number("to");
    panel.look.phase_portrait = toml.yes("phase_portrait");
    panel.look.title = toml.text("panel_title");
    panel.curves = inner_tables<CurveSpec>(toml, file, "curve", read_curve, error);
    panel.look.notes = inner_tables<Note>(toml, file, "note", read_note, error);
    return panel;
  }

  FigureSpec figure(TomlReader& toml) {
    FigureSpec figure;
    figure.place = toml.place();
    figure.look.id = toml.text("id");
    figure.look.title = toml.text("title");
    figure.look.caption = toml.text("caption");
    figure.look.columns = toml.whole("columns", 1);
    figure.width = toml.number("width", 1);
    const std::string size = toml.choice("size", {"single", "wide", "phase", "half", "tall"});
    figure.look.size = size == "wide"    ? FigureSize::wide
                       : size == "phase" ? FigureSize::phase
                       : size == "half"  ? FigureSize::half
                       : size == "tall"  ? FigureSize::tall
                                         : FigureSize::single;
    if (toml.has("panel"))
      figure.panels = inner_tables<PanelSpec>(
          toml, file, "panel", [this](TomlReader& inner) { return panel(inner); }, error);
    else
      figure.panels.push_back(panel(toml));
    if (size == "phase")
      for (PanelSpec& each : figure.panels) each.look.phase_portrait = true;
    return figure;
  }

  BlockSpec block(TomlReader& toml) {
    BlockSpec block;
    block.place = toml.place();
    if (toml.has("heading"))
      block.content = BlockSpec::Heading{study_text(toml, "heading")};
    else if (toml.has("figure"))
      block.content = BlockSpec::FigureName{toml.text("figure")};
    else if (toml.has("code"))
      block.content = BlockSpec::Code{study_text(toml, "code"), study_text(toml, "caption")};
    else if (toml.has("table")) {
      TableSpec table;
      table.caption = toml.text("table");
      table.header = toml.values("header");
      table.rows = toml.rows("rows");
      table.each = toml.values("each");
      table.row = toml.values("row");
      if (toml.has("text_columns")) table.text_columns = toml.wholes("text_columns");
      table.answer_column = toml.whole("answer_column", -1);
      block.content = std::move(table);
    } else {
      block.content = BlockSpec::Text{study_text(toml, "text")};
    }
    return block;
  }
};

KeyFigureSpec read_key_figure(TomlReader& toml) {
  return {study_text(toml, "name"), study_text(toml, "value"), study_text(toml, "remark")};
}

bool is_file_name(std::string_view id) {
  return std::all_of(id.begin(), id.end(),
                     [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; });
}

Result<void> check(const Study& study) {
  std::set<std::string> ids;
  for (const TaskSpec& task : study.tasks) {
    if (task.command.empty()) return task.place.error(Notice{"task_without_command"});
    if (task.id.empty() || !ids.insert(task.id).second) return task.place.error(Notice{"task_name_taken"});
  }
  ids.clear();
  for (const FigureSpec& figure : study.figures) {
    if (figure.look.id.empty() || !ids.insert(figure.look.id).second)
      return figure.place.error(Notice{"figure_id_taken"});
    if (!is_file_name(figure.look.id))
      return figure.place.error(Notice{"figure_id_is_file_name", {{"id", figure.look.id}}});
    for (const PanelSpec& panel : figure.panels)
      if (panel.curves.empty()) return panel.place.error(Notice{"figure_without_curves"});
  }
  for (const BlockSpec& block : study.blocks)
    if (const auto* named = std::get_if<BlockSpec::FigureName>(&block.content);
        named && !ids.count(named->id))
      return block.place.error(Notice{"no_such_figure", {{"id", named->id}}});
  if (study.tasks.empty()) return Error{"study_without_task", {{"file", study.file}}};
  return {};
}

}  // namespace

namespace {

Language read_language(TomlReader& toml) {
  return toml.choice("language", {"en", "de"}) == "de" ? Language::german : Language::english;
}

}  // namespace

Result<ReportFront> read_report_front(std::string_view bytes, const std::string& file) {
  const toml::parse_result parsed = toml::parse(bytes, file);
  if (!parsed) return not_toml(parsed, file);
  return read_table(parsed.table(), file, [](TomlReader& toml) {
    ReportFront front;
    front.title = toml.text("title");
    front.author = toml.text("author");
    front.course = toml.text("course");
    front.text = toml.text("text");
    front.aim = toml.text("aim");
    front.apparatus = toml.text("apparatus");
    front.conclusion = toml.text("conclusion");
    front.language = read_language(toml);
    return front;
  });
}

Result<Study> read_study(std::string_view bytes, const std::string& file) {
  const toml::parse_result parsed = toml::parse(bytes, file);
  if (!parsed) return not_toml(parsed, file);
  StudyReader reader{file};
  auto study = read_table(parsed.table(), file, [&](TomlReader& toml) {
    Study read;
    read.file = file;
    read.folder = std::filesystem::path(file).parent_path().string();
    read.language = read_language(toml);
    read.title = study_text(toml, "title");
    read.byline = study_text(toml, "byline");
    read.summary = study_text(toml, "summary");
    read.key_figures = inner_tables<KeyFigureSpec>(toml, file, "key_figure", read_key_figure, reader.error);
    read.tasks = inner_tables<TaskSpec>(toml, file, "task", read_task, reader.error);
    read.figures = inner_tables<FigureSpec>(
        toml, file, "figure", [&](TomlReader& inner) { return reader.figure(inner); }, reader.error);
    read.blocks = inner_tables<BlockSpec>(
        toml, file, "block", [&](TomlReader& inner) { return reader.block(inner); }, reader.error);
    return read;
  });
  if (reader.error) return *reader.error;
  if (!study) return study;
  if (const auto checked = check(*study); !checked) return checked.error();
  return study;
}

}  // namespace cromer::core
