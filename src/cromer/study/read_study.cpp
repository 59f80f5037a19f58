#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#include <toml++/impl/forward_declarations.h>
// toml++ 3.3 takes it as given that behind "[" stands a key, and that outside quotes no letter between U+00A1
// and U+0499 occurs, such as ±; a compiler may rely on both. A user may write anything.
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT_ASSUME(expr) static_assert(true)
#pragma push_macro("TOML_UNREACHABLE")
#undef TOML_UNREACHABLE
#define TOML_UNREACHABLE return false
#include <toml++/impl/unicode.h>
#pragma pop_macro("TOML_UNREACHABLE")
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <initializer_list>
#include <set>

#include "cromer/base/ascii.h"
#include "cromer/base/nearest.h"
#include "cromer/base/quantity.h"
#include "cromer/study/lab_report.h"
#include "cromer/study/run_study.h"
#include "cromer/study/study_file.h"

namespace cromer::core {
namespace {

/// Reads typed values from a TOML table. It remembers the keys that were asked for; finish() reports all
/// others. Only the first error is kept.
class TomlReader {
 public:
  TomlReader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  std::string text(std::string_view key, std::string otherwise = "");
  /// One of the names; the first if the key is missing.
  std::string choice(std::string_view key, std::initializer_list<std::string_view> names);
  double number(std::string_view key, double otherwise);
  int whole(std::string_view key, int otherwise);
  bool yes(std::string_view key);
  std::vector<int> wholes(std::string_view key);
  /// A value, or a list of them, as texts for options: 0.2, "217.6 g", true.
  std::vector<std::string> values(std::string_view key);
  std::optional<double> maybe_number(std::string_view key);
  /// The tables of an array of tables; empty if the key is missing.
  std::vector<const toml::table*> tables(std::string_view key);
  /// An array of arrays, as texts.
  std::vector<std::vector<std::string>> rows(std::string_view key);

  bool has(std::string_view key);
  std::vector<std::string> keys() const;
  /// A text with the place of its value; empty where the key is missing.
  StudyText study_text(std::string_view key) {
    return {text(key), table_.get(key) ? place_of_key(key) : place()};
  }
  Place place() const { return place_of(table_); }
  Place place_of(const toml::node& node) const;
  /// The place of a value whose key exists.
  Place place_of_key(std::string_view key) const { return place_of(*table_.get(key)); }
  void fail(const toml::node& node, const Notice& what);
  /// The first error, or an Error for a key that was never asked for.
  Result<void> finish() const;

 private:
  const toml::node* find(std::string_view key);

  const toml::table& table_;
  std::string file_;
  std::vector<std::string> asked_;
  std::optional<Error> error_;
};

/// The value as the command line would take it; empty for tables and arrays.
std::optional<std::string> as_option_text(const toml::node& node) {
  if (const auto* text = node.as_string()) return text->get();
  if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
  if (const auto* number = node.as_floating_point()) return shortest(number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  return std::nullopt;
}

const toml::node* TomlReader::find(std::string_view key) {
  asked_.emplace_back(key);
  return table_.get(key);
}

Place TomlReader::place_of(const toml::node& node) const {
  const auto begin = node.source().begin;
  return Place{file_, begin.line, begin.column};
}

void TomlReader::fail(const toml::node& node, const Notice& what) {
  if (!error_) error_ = place_of(node).error(what);
}

bool TomlReader::has(std::string_view key) { return find(key) != nullptr; }

std::vector<std::string> TomlReader::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, node] : table_) names.emplace_back(key.str());
  return names;
}

std::string TomlReader::text(std::string_view key, std::string otherwise) {
  const toml::node* node = find(key);
  if (!node) return otherwise;
  if (const auto* value = node->as_string()) return value->get();
  fail(*node, Notice{"key_takes_text", {{"key", key}}});
  return otherwise;
}

std::string TomlReader::choice(std::string_view key, std::initializer_list<std::string_view> names) {
  const std::string value = text(key, std::string(*names.begin()));
  if (std::find(names.begin(), names.end(), value) != names.end()) return value;
  fail(*table_.get(key),
       Notice{"key_is_one_of",
              {{"key", key}, {"names", std::vector<std::string>(names.begin(), names.end())}}});
  return std::string(*names.begin());
}

double TomlReader::number(std::string_view key, double otherwise) {
  return maybe_number(key).value_or(otherwise);
}

std::optional<double> TomlReader::maybe_number(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return std::nullopt;
  if (const auto value = node->value<double>()) return value;
  fail(*node, Notice{"key_takes_number", {{"key", key}}});
  return std::nullopt;
}

int TomlReader::whole(std::string_view key, int otherwise) {
  const toml::node* node = find(key);
  if (!node) return otherwise;
  if (const auto value = node->value_exact<std::int64_t>();
      value && *value >= -1'000'000 && *value <= 1'000'000)
    return static_cast<int>(*value);
  fail(*node, Notice{"key_takes_whole_number", {{"key", key}}});
  return otherwise;
}

bool TomlReader::yes(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return false;
  if (const auto value = node->value_exact<bool>()) return *value;
  fail(*node, Notice{"key_takes_true_or_false", {{"key", key}}});
  return false;
}

std::vector<std::string> TomlReader::values(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return {};
  if (const auto single = as_option_text(*node)) return {*single};
  std::vector<std::string> texts;
  if (const auto* array = node->as_array()) {
    for (const toml::node& element : *array) {
      const auto text = as_option_text(element);
      if (!text)
        fail(element, Notice{"key_takes_numbers_or_texts", {{"key", key}}});
      else
        texts.push_back(*text);
    }
  } else {
    fail(*node, Notice{"key_takes_one_or_several", {{"key", key}}});
  }
  return texts;
}

std::vector<int> TomlReader::wholes(std::string_view key) {
  std::vector<int> numbers;
  const toml::node* node = find(key);
  if (!node) return numbers;
  if (const auto* array = node->as_array()) {
    for (const toml::node& element : *array) {
      const auto value = element.value_exact<std::int64_t>();
      if (!value || *value < 0 || *value > 1000)
        fail(element, Notice{"key_takes_counts", {{"key", key}}});
      else
        numbers.push_back(static_cast<int>(*value));
    }
  } else {
    fail(*node, Notice{"key_takes_whole_numbers", {{"key", key}}});
  }
  return numbers;
}

std::vector<const toml::table*> TomlReader::tables(std::string_view key) {
  std::vector<const toml::table*> found;
  const toml::node* node = find(key);
  if (!node) return found;
  const auto* array = node->as_array();
  if (!array) {
    fail(*node, Notice{"key_is_list_of_tables_so", {{"key", key}}});
    return found;
  }
  for (const toml::node& element : *array) {
    if (const auto* table = element.as_table())
      found.push_back(table);
    else
      fail(element, Notice{"key_is_list_of_tables", {{"key", key}}});
  }
  return found;
}

std::vector<std::vector<std::string>> TomlReader::rows(std::string_view key) {
  std::vector<std::vector<std::string>> all;
  const toml::node* node = find(key);
  if (!node) return all;
  const auto* array = node->as_array();
  if (!array) {
    fail(*node, Notice{"key_takes_rows", {{"key", key}}});
    return all;
  }
  for (const toml::node& element : *array) {
    const auto* row = element.as_array();
    if (!row) {
      fail(element, Notice{"row_is_list"});
      continue;
    }
    auto& cells = all.emplace_back();
    for (const toml::node& cell : *row) {
      const auto text = as_option_text(cell);
      if (!text)
        fail(cell, Notice{"cell_is_text_or_number"});
      else
        cells.push_back(*text);
    }
  }
  return all;
}

Result<void> TomlReader::finish() const {
  if (error_) return *error_;
  for (const auto& [key, node] : table_) {
    if (std::find(asked_.begin(), asked_.end(), key.str()) != asked_.end()) continue;
    const std::vector<std::string_view> known(asked_.begin(), asked_.end());
    const std::string near = nearest(key.str(), known);
    return place_of(node).error(
        Notice{"key_not_known",
               {{"key", key.str()},
                {"near", near.empty() ? Notice{} : Notice{"perhaps_quoted", {{"near", near}}}}}});
  }
  return {};
}

/// Reads one table by a function of a TomlReader.
template <class Read>
auto read_table(const toml::table& table, const std::string& file, Read read)
    -> Result<decltype(read(std::declval<TomlReader&>()))> {
  TomlReader reader(table, file);
  auto value = read(reader);
  if (const auto finished = reader.finish(); !finished) return finished.error();
  return value;
}

/// Reads all tables of a list, up to the first Error.
template <class Spec, class Read>
Result<std::vector<Spec>> read_tables(const std::vector<const toml::table*>& tables, const std::string& file,
                                      Read read) {
  std::vector<Spec> specs;
  for (const toml::table* table : tables) {
    auto spec = read_table(*table, file, read);
    if (!spec) return spec.error();
    specs.push_back(std::move(*spec));
  }
  return specs;
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
  for (const std::string& key : toml.keys()) {
    if (with_hyphens(key) == task.command || key == "shows" || key == "may_fail") continue;
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

/// Reads the tables within a table; `error` keeps their first Error.
template <class Spec, class Read>
std::vector<Spec> inner_tables(TomlReader& toml, const std::string& file, std::string_view key, Read read,
                               std::optional<Error>& error) {
  auto specs = read_tables<Spec>(toml.tables(key), file, read);
  if (specs) return std::move(*specs);
  if (!error) error = specs.error();
  return {};
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
      block.content = BlockSpec::Heading{toml.study_text("heading")};
    else if (toml.has("figure"))
      block.content = BlockSpec::FigureName{toml.text("figure")};
    else if (toml.has("code"))
      block.content = BlockSpec::Code{toml.study_text("code"), toml.study_text("caption")};
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
      block.content = BlockSpec::Text{toml.study_text("text")};
    }
    return block;
  }
};

KeyFigureSpec read_key_figure(TomlReader& toml) {
  return {toml.study_text("name"), toml.study_text("value"), toml.study_text("remark")};
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

Error not_toml(const toml::parse_result& parsed, const std::string& file) {
  const auto begin = parsed.error().source().begin;
  return Place{file, begin.line, begin.column}.error(
      Notice{"not_toml", {{"why", parsed.error().description()}}});
}

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
    read.title = toml.study_text("title");
    read.byline = toml.study_text("byline");
    read.summary = toml.study_text("summary");
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
