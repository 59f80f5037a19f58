#include "cromer/study/write_report.h"

#include "cromer/study/results.h"

namespace cromer::core {
namespace {

/// Fills texts one after another; the first Error stays.
struct Filler {
  const Results& results;
  std::optional<Error> error{};

  std::string operator()(const std::string& text, std::string_view scope = "") {
    auto filled = fill(text, results, scope);
    if (filled) return std::move(*filled);
    if (!error) error = filled.error();
    return text;
  }
};

/// The runs of a task are "id.1", "id.2", ...; each has a label.
std::vector<std::string> runs_of(const Results& results, const std::string& id) {
  std::vector<std::string> names;
  for (int i = 1; results.fact(id + "." + std::to_string(i) + ".label"); ++i)
    names.push_back(id + "." + std::to_string(i));
  return names;
}

TableBlock make_table(const TableSpec& spec, Filler& text) {
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
    const auto runs = runs_of(text.results, id);
    if (runs.empty() && !text.error) text.error = Error{"no_runs_to_list", {{"task", id}}};
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
  for (const auto& key : study.key_figures)
    page.key_figures.push_back({text(key.name), text(key.value), text(key.remark)});
  const Place top{study.file, 1, 1};
  if (text.error) return top.error(text.error->notice);

  std::map<std::string, int> numbers;
  for (std::size_t i = 0; i < study.figures.size(); ++i)
    numbers[study.figures[i].look.id] = static_cast<int>(i) + 1;
  for (const BlockSpec& block : study.blocks) {
    if (const auto* heading = std::get_if<BlockSpec::Heading>(&block.content)) {
      page.blocks.push_back(Heading{text(heading->text)});
    } else if (const auto* paragraph = std::get_if<BlockSpec::Text>(&block.content)) {
      page.blocks.push_back(Paragraph{text(paragraph->text)});
    } else if (const auto* code = std::get_if<BlockSpec::Code>(&block.content)) {
      page.blocks.push_back(Code{text(code->text), text(code->caption)});
    } else if (const auto* table = std::get_if<TableSpec>(&block.content)) {
      page.blocks.push_back(make_table(*table, text));
    } else {
      const std::string& id = std::get<BlockSpec::FigureName>(block.content).id;
      const DrawnFigure& figure = figures.at(id);
      page.blocks.push_back(FigureBlock{id, figure.svg, figure.title,
                                        "Figure " + std::to_string(numbers.at(id)), figure.caption,
                                        figure.width});
    }
    if (text.error) return block.place.error(text.error->notice);
  }
  return page;
}

}  // namespace cromer::core
