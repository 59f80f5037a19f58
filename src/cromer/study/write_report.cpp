#include "cromer/study/write_report.h"

#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <vector>

#include "cromer/base/at_once.h"
#include "cromer/documents/json/json.h"
#include "cromer/documents/words/words.h"
#include "cromer/report/file.h"
#include "cromer/report/paper.h"

namespace cromer::core {
namespace {

/// A column in the unit it is drawn in.
struct DrawnColumn {
  std::vector<double> values;
  std::string axis;  ///< "position x (cm)"
};

Result<double> conversion(const std::string& from, const std::string& to) {
  if (to.empty() || to == from) return 1.0;
  const auto source = parse_unit(from);
  const auto target = parse_unit(to);
  if (!source) return source.error();
  if (!target) return target.error();
  if (!(source->dimension == target->dimension))
    return Error{"column_not_drawn_in", {{"from", from}, {"to", to}}};
  return source->factor / target->factor;
}

Result<DrawnColumn> drawn(const Results& results, const std::string& name, const std::string& unit) {
  const auto column = results.column(name);
  if (!column) return column.error();
  const auto factor = conversion((*column)->unit, unit);
  if (!factor) return factor.error();
  DrawnColumn out{(*column)->values, (*column)->name};
  for (double& value : out.values) value *= *factor;
  const std::string& shown = unit.empty() ? (*column)->unit : unit;
  if (!shown.empty()) out.axis += " (" + shown + ")";
  return out;
}

std::string column_name(const std::string& of, const std::string& column) {
  return of.empty() ? column : of + "." + column;
}

Result<void> fill_in(std::string& text, const Results& results, bool enhanced) {
  auto filled = fill(text, results);
  if (!filled) return filled.error();
  text = enhanced ? to_enhanced(*filled) : *filled;
  return {};
}

/// Leaves out the rows whose time is outside [from, to].
Result<void> keep_range(Curve& curve, const CurveSpec& spec, const PanelSpec& panel, const Results& results) {
  const auto from = spec.from ? spec.from : panel.from;
  const auto to = spec.to ? spec.to : panel.to;
  if (!from && !to) return {};
  const auto time = results.column(column_name(spec.of, "t"));
  if (!time) return time.error();
  const std::vector<double>& t = (*time)->values;
  if (t.size() != curve.x.size()) return Error{"range_needs_times", {{"result", spec.of}}};
  std::vector<double> x, y;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if ((from && t[i] < *from) || (to && t[i] > *to)) continue;
    x.push_back(curve.x[i]);
    y.push_back(curve.y[i]);
  }
  curve.x = std::move(x);
  curve.y = std::move(y);
  return {};
}

Result<void> subtract(DrawnColumn& y, const Results& results, const CurveSpec& spec,
                      const std::string& column, const std::string& unit) {
  const auto other = drawn(results, column_name(spec.minus, column), unit);
  if (!other) return other.error();
  if (other->values.size() != y.values.size())
    return Error{"rows_not_subtracted",
                 {{"minus", spec.minus},
                  {"minus_rows", other->values.size()},
                  {"of", spec.of},
                  {"of_rows", y.values.size()}}};
  for (std::size_t i = 0; i < y.values.size(); ++i) y.values[i] -= other->values[i];
  return {};
}

Result<Curve> make_curve(const CurveSpec& spec, const PanelSpec& panel, Panel& made, const Results& results) {
  const std::string& x_column = spec.x.empty() ? panel.x : spec.x;
  const std::string& y_column = spec.y.empty() ? panel.y : spec.y;
  auto x = drawn(results, column_name(spec.of, x_column), panel.x_unit);
  if (!x) return x.error();
  auto y = drawn(results, column_name(spec.of, y_column), panel.y_unit);
  if (!y) return y.error();
  if (!spec.minus.empty())
    if (const auto done = subtract(*y, results, spec, y_column, panel.y_unit); !done) return done.error();

  Curve curve = spec.look;
  curve.x = std::move(x->values);
  curve.y = std::move(y->values);
  if (const auto done = keep_range(curve, spec, panel, results); !done) return done.error();
  if (made.x.name.empty()) made.x.name = to_enhanced(x->axis);
  if (made.y.name.empty()) made.y.name = to_enhanced(y->axis);
  for (std::string* text : {&curve.name, &curve.remark})
    if (const auto done = fill_in(*text, results, true); !done) return done.error();
  return curve;
}

}  // namespace

std::string to_enhanced(const std::string& markup) {
  std::string out;
  bool italic = false;
  for (std::size_t i = 0; i < markup.size(); ++i) {
    if (markup[i] == '*') {
      out += italic ? "}" : "{/:Italic ";
      italic = !italic;
    } else {
      out += markup[i];
    }
  }
  return italic ? markup : out;
}

Result<Figure> make_figure(const FigureSpec& spec, const Results& results) {
  Figure figure = spec.look;
  for (std::string* text : {&figure.title, &figure.caption})
    if (const auto done = fill_in(*text, results, false); !done) return spec.place.error(done.error().notice);
  for (const PanelSpec& panel_spec : spec.panels) {
    Panel panel = panel_spec.look;
    panel.x.decimal_comma = panel.y.decimal_comma = results.language() == Language::german;
    for (std::string* text : {&panel.title, &panel.x.name, &panel.y.name})
      if (const auto done = fill_in(*text, results, true); !done)
        return panel_spec.place.error(done.error().notice);
    for (const CurveSpec& curve_spec : panel_spec.curves) {
      auto curve = make_curve(curve_spec, panel_spec, panel, results);
      if (!curve) return curve_spec.place.error(curve.error().notice);
      panel.curves.push_back(std::move(*curve));
    }
    for (Note& note : panel.notes)
      if (const auto done = fill_in(note.text, results, true); !done)
        return panel_spec.place.error(done.error().notice);
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

namespace {

/// Fills results into texts, and keeps the first Error.
struct Filler {
  const Results& results;
  std::optional<Error> error{};

  std::string operator()(const StudyText& placed, std::string_view scope = "") {
    auto filled = fill(placed.text, results, scope);
    if (filled) return std::move(*filled);
    if (!error) error = placed.place.error(filled.error().notice);
    return placed.text;
  }
};

/// The runs of a task are "id.1", "id.2", ...; each has a label.
std::vector<std::string> runs_of(const Results& results, const std::string& id) {
  std::vector<std::string> names;
  for (int i = 1; results.fact(id + "." + std::to_string(i) + ".label"); ++i)
    names.push_back(id + "." + std::to_string(i));
  return names;
}

/// `place`: of the block, where every text of it is said to stand.
TableBlock make_table(const TableSpec& spec, const Place& place, Filler& fill_in) {
  const auto text = [&](const std::string& words, std::string_view scope = "") {
    return fill_in({words, place}, scope);
  };
  TableBlock table;
  table.caption = text(spec.caption);
  table.text_columns = spec.text_columns;
  table.answer_column = spec.answer_column;
  for (const auto& cell : spec.header) table.header.push_back(text(cell));
  for (const auto& row : spec.rows) {
    auto& cells = table.rows.emplace_back();
    for (const auto& cell : row) cells.push_back(text(cell));
  }
  for (const auto& id : spec.each) {
    const auto runs = runs_of(fill_in.results, id);
    if (runs.empty() && !fill_in.error)
      fill_in.error = place.error(Notice{"no_runs_to_list", {{"task", id}}});
    for (const auto& run : runs) {
      auto& cells = table.rows.emplace_back();
      for (const auto& cell : spec.row) cells.push_back(text(cell, run));
    }
  }
  return table;
}

}  // namespace

Result<Page> make_page(const Study& study, const Results& results,
                       const std::map<std::string, DrawnFigure>& figures, const std::string& footer) {
  Filler text{results};
  Page page;
  page.title = text(study.title);
  page.byline = text(study.byline);
  page.summary = text(study.summary);
  page.footer = footer;
  const Voice voice{results.language()};
  if (voice.language == Language::german) page.language = "de";
  page.skip = in_words(Notice{"page_skip"}, voice);
  for (const auto& key : study.key_figures)
    page.key_figures.push_back({text(key.name), text(key.value), text(key.remark)});
  if (text.error) return *text.error;

  std::map<std::string, int> numbers;
  for (std::size_t i = 0; i < study.figures.size(); ++i)
    numbers[study.figures[i].look.id] = static_cast<int>(i) + 1;
  int tables = 0;
  for (const BlockSpec& block : study.blocks) {
    if (const auto* heading = std::get_if<BlockSpec::Heading>(&block.content)) {
      page.blocks.push_back(Heading{text(heading->text)});
    } else if (const auto* paragraph = std::get_if<BlockSpec::Text>(&block.content)) {
      page.blocks.push_back(Paragraph{text(paragraph->text)});
    } else if (const auto* code = std::get_if<BlockSpec::Code>(&block.content)) {
      page.blocks.push_back(Code{text(code->text), text(code->caption)});
    } else if (const auto* table = std::get_if<TableSpec>(&block.content)) {
      TableBlock made = make_table(*table, block.place, text);
      made.label = in_words(Notice{"page_table", {{"number", ++tables}}}, voice);
      page.blocks.push_back(std::move(made));
    } else {
      const std::string& id = std::get<BlockSpec::FigureName>(block.content).id;
      const DrawnFigure& figure = figures.at(id);
      page.blocks.push_back(FigureBlock{id, figure.svg, figure.title,
                                        in_words(Notice{"page_figure", {{"number", numbers.at(id)}}}, voice),
                                        figure.caption, figure.width});
    }
    if (text.error) return *text.error;
  }
  return page;
}

namespace {

Result<DrawnFigure> draw_figure(const FigureSpec& spec, const Results& results, const Watch& watch) {
  if (watch.interrupted()) return spec.place.error(Notice{"interrupted_before", {{"figure", spec.look.id}}});
  auto figure = make_figure(spec, results);
  if (!figure) return figure.error();
  auto svg = draw(*figure, FigureFormat::svg);
  if (!svg) return spec.place.error(svg.error().notice);
  return DrawnFigure{std::move(*svg), figure->title, figure->caption, spec.width};
}

Result<std::map<std::string, DrawnFigure>> draw_figures(const Study& study, const Results& results,
                                                        const Watch& watch) {
  std::vector<std::optional<Result<DrawnFigure>>> each(study.figures.size());
  at_once(each.size(), [&](std::size_t i) { each[i] = draw_figure(study.figures[i], results, watch); });
  std::map<std::string, DrawnFigure> drawn;
  for (std::size_t i = 0; i < each.size(); ++i) {
    if (!*each[i]) return each[i]->error();
    drawn[study.figures[i].look.id] = std::move(**each[i]);
  }
  return drawn;
}

std::string versions(const std::string& program) {
#if defined(__clang__)
  return program + " · clang " __clang_version__;
#else
  return program + " · g++ " __VERSION__;
#endif
}

/// Removes the folder again if it was made for a report that was then not written.
class FolderInWaiting {
 public:
  explicit FolderInWaiting(const std::string& folder)
      : folder_(folder), was_there_(std::filesystem::exists(folder)) {}
  ~FolderInWaiting() {
    std::error_code none;
    if (!was_there_ && std::filesystem::is_empty(folder_, none)) std::filesystem::remove(folder_, none);
  }
  FolderInWaiting(const FolderInWaiting&) = delete;
  FolderInWaiting& operator=(const FolderInWaiting&) = delete;

 private:
  std::string folder_;
  bool was_there_;
};

}  // namespace

Result<void> make_folder(const std::string& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  for (std::filesystem::path part = folder; failed && part.has_relative_path(); part = part.parent_path())
    if (std::error_code none; std::filesystem::is_regular_file(part, none))
      return Error{"file_is_no_folder", {{"file", part.string()}}};
  if (failed) return Error{"folder_not_made", {{"folder", folder}, {"why", failed.message()}}};
  const std::string index = folder + "/index.html";
  if (const auto there = read_file(index); there && there->find(mark_of_pages) == there->npos)
    return Error{"page_of_others", {{"file", index}}};
  return check_writable(index);
}

Result<WrittenReport> write_report(const std::string& study_path, const std::string& folder,
                                   const std::string& date, const std::string& program, const Watch& watch,
                                   const StudyProgress& progress, const KnownResults& known,
                                   const std::string& pdf) {
  const auto bytes = read_file(study_path);
  if (!bytes) return bytes.error();
  auto study = read_study(*bytes, study_path);
  if (!study) return study.error();
  const FolderInWaiting in_waiting(folder);
  if (const auto made = make_folder(folder); !made) return made.error();

  auto run = run_study(*study, watch, progress, known);
  if (!run) return run.error();
  WrittenReport written{"", {}, run->notices, run->shown, run->failure};
  if (!run->failure.empty()) return written;
  if (progress) progress("figures", 1);
  const auto figures = draw_figures(*study, run->results, watch);
  if (!figures) return figures.error();
  study->byline.text += (study->byline.text.empty() ? "" : " · ") + date + " · " + program;
  const auto page = make_page(*study, run->results, *figures, versions(program));
  if (!page) return page.error();

  if (!pdf.empty()) {
    const auto bytes_of_pdf = to_pdf(*page);
    if (!bytes_of_pdf) return bytes_of_pdf.error();
    if (const auto done = write_file(pdf, *bytes_of_pdf); !done) return done.error();
    written.pdf = pdf;
  }
  for (const auto& [id, figure] : *figures) {
    written.figures.push_back(folder + "/" + id + ".svg");
    if (const auto done = write_file(written.figures.back(), figure.svg); !done) return done.error();
  }
  if (const auto done = write_file(folder + "/results.json", to_json(run->results)); !done)
    return done.error();
  written.index = folder + "/index.html";
  if (const auto done = write_file(written.index, to_html(*page)); !done) return done.error();
  return written;
}

std::string to_json(const WrittenReport& report) {
  Json document = {{"index", report.index.empty() ? Json(nullptr) : Json(report.index)},
                   {"figures", report.figures}};
  if (!report.pdf.empty()) document["pdf"] = report.pdf;
  add_notices(document, report.notices, {});
  document["shown"] = in_words(report.shown);
  if (!report.failure.empty()) document["message"] = in_words(report.failure);
  return to_text(document);
}

}  // namespace cromer::core
